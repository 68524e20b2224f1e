#include "perf/cost/event_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ballpark::cost {

EventErrors event_errors(const std::vector<scenes::EventTimes>& events,
                         const std::vector<scenes::EventTimes>& reference) {
  EventErrors errors;
  for (std::size_t i = 0; i < std::min(events.size(), reference.size()); ++i) {
    const scenes::EventTimes &run = events[i], &truth = reference[i];
    if (run.count != truth.count) {
      errors.time = std::numeric_limits<double>::infinity();
      errors.different += fmt::format("{}{}: {} times instead of {}", errors.different.empty() ? "" : "; ", run.name,
                                      run.count, truth.count);
      continue;
    }
    errors.time = std::max(errors.time, std::abs(run.last - truth.last));  // beyond those that are kept
    for (std::size_t k = 0; k < run.times.size(); ++k) {
      errors.time = std::max(errors.time, std::abs(run.times[k] - truth.times[k]));
    }
  }
  return errors;
}

double rounding_of(const std::vector<scenes::EventTimes>& events) {
  double last = 0;
  for (const scenes::EventTimes& event : events) last = std::max(last, event.last);
  return 4 * std::numeric_limits<double>::epsilon() * last;
}

scenes::EventTimes exact_times(const scenes::BodyEvent& event, const BodyState& start,
                               const std::function<BodyState(long double)>& state, double duration, std::size_t parts) {
  scenes::EventTimes found{event.name};
  const auto value_at = [&](long double t) { return event.value(state(t)); };
  long double from = 0;
  double before = event.value(start);
  for (std::size_t k = 1; k <= parts; ++k) {
    const long double to =
        static_cast<long double>(duration) * static_cast<long double>(k) / static_cast<long double>(parts);
    const double after = value_at(to);
    const bool rises = before < 0 && after >= 0, falls = before > 0 && after <= 0;
    if ((rises && event.rising) || (falls && event.falling)) {
      long double low = from, high = to;  // halved to the last bit of a double
      while (high - low > std::numeric_limits<double>::epsilon() / 4 * high) {
        const long double middle = low + (high - low) / 2;
        const double value = value_at(middle);
        ((before < 0 ? value >= 0 : value <= 0) ? high : low) = middle;
      }
      ++found.count;
      found.last = static_cast<double>(high);
      if (found.times.size() < scenes::most_event_times) found.times.push_back(found.last);
    }
    from = to;
    before = after;
  }
  return found;
}

}  // namespace ballpark::cost
