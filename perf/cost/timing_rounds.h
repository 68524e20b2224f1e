// Whole runs timed in turns, so that a drifting machine favours none.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "perf/cost/sweep.h"

namespace ballpark::cost {

/// A run whose time is wanted, from the scene's start.
struct TimedRun {
  const Scene* scene = nullptr;  ///< outlives the timing
  Setting setting;
  std::string state_hash = {};  ///< in which it must end; "": whatever it ends in
  Seconds seconds = {};
  std::string trouble = {};  ///< why its time does not count; "" if it does
};

/// Of the runs, as many at once as memory holds. False if it was stopped. Throws SceneError.
bool time_in_turns(std::vector<TimedRun>& runs, const Options& options, const SweepTime& time,
                   const std::function<bool(double fraction)>& go_on);

/// What the worlds of runs that wait for their turns may take [B].
inline constexpr std::size_t most_memory = 2'000'000'000;
/// Of one that waits.
std::size_t memory_of(const World& world);

}  // namespace ballpark::cost
