// What runs take beside a base, timed in turns with it.
#pragma once

#include <optional>
#include <vector>

#include "perf/cost/timing_rounds.h"

namespace ballpark::cost {

/// Of a run and its base.
struct Beside {
  Seconds seconds, base;
  double noise = 0;  ///< largest relative difference of runs of the base alone, by minimum or median
  std::string trouble = {};

  /// Share of the base's time that the run does without; negative: it takes more.
  double saved_of_minima() const { return 1 - seconds.minimum / base.minimum; }
  double saved_of_medians() const { return 1 - seconds.median / base.median; }
  /// Is it more than runs of the same differ by, with one sign by minima and medians?
  bool shows() const;
};

/// In the order of `others`, each in turns with the base, which runs thrice. nullopt if it was stopped. Throws
/// SceneError.
std::optional<std::vector<Beside>> time_beside(const TimedRun& base, const std::vector<TimedRun>& others,
                                               const Options& options, const SweepTime& time, const GoOn& go_on);

}  // namespace ballpark::cost
