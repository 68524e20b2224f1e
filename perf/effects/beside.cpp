#include "perf/effects/beside.h"

#include <algorithm>
#include <cmath>

namespace ballpark::cost {

namespace {

constexpr std::size_t base_runs = 3;  ///< how far they are apart is the noise

double apart(double a, double b) {
  return std::abs(a / b - 1);
}

/// Largest relative difference of two of the base's runs.
double noise_of(const std::vector<TimedRun>& runs) {
  double noise = 0;
  for (std::size_t a = 0; a < base_runs; ++a) {
    for (std::size_t b = 0; b < base_runs; ++b) {
      const Seconds &once = runs[a].seconds, &again = runs[b].seconds;
      noise = std::max({noise, apart(again.minimum, once.minimum), apart(again.median, once.median)});
    }
  }
  return noise;
}

std::size_t memory_for(const TimedRun& run, const Options& options) {
  return memory_of(World(scene_with(*run.scene, run.setting), options));
}

/// As many of the others from `first` on, at least one, as memory holds at once beside the base.
std::size_t end_of_batch(const TimedRun& base, const std::vector<TimedRun>& others, std::size_t first,
                         const Options& options) {
  std::size_t memory = base_runs * memory_for(base, options) + memory_for(others[first], options), last = first + 1;
  for (; last < others.size(); ++last) {
    memory += memory_for(others[last], options);
    if (memory > most_memory) break;
  }
  return last;
}

}  // namespace

bool Beside::shows() const {
  const double minima = saved_of_minima(), medians = saved_of_medians();
  return std::min(std::abs(minima), std::abs(medians)) > noise && (minima > 0) == (medians > 0);
}

std::optional<std::vector<Beside>> time_beside(const TimedRun& base, const std::vector<TimedRun>& others,
                                               const Options& options, const SweepTime& time, const GoOn& go_on) {
  std::vector<Beside> list;
  for (std::size_t first = 0, last = 0; first < others.size(); first = last) {
    last = end_of_batch(base, others, first, options);
    std::vector<TimedRun> runs(base_runs, base);
    for (std::size_t i = first; i < last; ++i) runs.push_back(others[i]);
    const double share = static_cast<double>(last - first) / static_cast<double>(others.size());
    if (!time_in_turns(runs, options, {share * time.seconds, time.rounds}, [&](double) { return go_on(); })) {
      return std::nullopt;
    }
    for (std::size_t i = base_runs; i < runs.size(); ++i) {
      const std::string trouble = runs[0].trouble.empty() ? runs[i].trouble : runs[0].trouble;
      list.push_back({runs[i].seconds, runs[0].seconds, noise_of(runs), trouble});
    }
  }
  return list;
}

}  // namespace ballpark::cost
