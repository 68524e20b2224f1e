#include "scenarios/files/event_log.h"

#include <utility>

#include "scenarios/files/findings.h"
#include "scenarios/files/quantity.h"

namespace ballpark::scenes {

std::vector<BodyEvent> events_of(const SceneFile& file, const World& world) {
  std::vector<BodyEvent> events;
  std::vector<LocatedProblem> problems;
  for (std::size_t i = 0; i < file.events.size(); ++i) {
    const EventRequest& request = file.events[i];
    const Quantity quantity(request.quantity);
    const std::string problem = quantity.state_problem(world);
    if (!problem.empty()) {
      const std::string path = "event[" + std::to_string(i) + "].quantity";
      problems.push_back({locate(file, path), path, "\"" + printable(request.quantity) + "\": " + problem});
      continue;
    }
    const auto value = [column = quantity.column(), level = request.value](const BodyState& body) {
      return column(body) - level;
    };
    events.push_back(
        {request.name, quantity.body(), value, request.crossing != "falling", request.crossing != "rising"});
  }
  if (!problems.empty()) throw SceneFileError(std::move(problems));
  return events;
}

Watch watch_for(const BodyEvent& event, const World& world, EventTimes& into) {
  const auto note = [&event, &into](double time, bool rising) {
    if (!(rising ? event.rising : event.falling) || (into.count > 0 && time <= into.last)) return;
    ++into.count;
    into.last = time;
    if (into.times.size() < most_event_times) into.times.push_back(time);
  };
  return {[&event, &world] { return event.value(world.body(event.body)); }, note};
}

EventLog::EventLog(const SceneFile& file, World& world) : world_(world), events_(events_of(file, world)) {
  for (const BodyEvent& event : events_) noted_.push_back({event.name});
  for (std::size_t i = 0; i < events_.size(); ++i) watches_.push_back(watch_for(events_[i], world, noted_[i]));
}

void EventLog::step(std::uint64_t n, double length) {
  const double inside_the_next = (static_cast<double>(world_.steps() + n) + 0.5) * length;
  advance_watching(world_, inside_the_next, watches_, n);
}

/// Steps on to t are taken to find what is until then; they are taken again, and their events found again.
bool EventLog::approach(double t, double end, std::uint64_t most_steps) {
  for (std::uint64_t i = 0; i < most_steps; ++i) {
    const bool there = world_.approach(t, end, 0);
    const Snapshot start = world_.snapshot();
    const std::uint64_t steps = world_.steps();
    advance_watching(world_, end, watches_, 1);
    if (world_.steps() == steps) return there;
    if (!there) continue;
    while (world_.time() < t) {
      const std::uint64_t before = world_.steps();
      advance_watching(world_, end, watches_, 1);
      if (world_.steps() == before) break;
    }
    world_.restore(start);
    return true;
  }
  return world_.time() >= t;
}

std::vector<EventTimes> EventLog::until(double t) const {
  std::vector<EventTimes> list = noted_;
  for (EventTimes& event : list) {
    if (event.count == 0 || event.last <= t) continue;
    --event.count;  // an event is at most once in the step that passes t
    if (event.times.back() > t) event.times.pop_back();
    event.last = event.times.empty() ? 0 : event.times.back();
  }
  return list;
}

}  // namespace ballpark::scenes
