// What a scene is judged and watched by, seen in a run: the quantities of its [[expect]], and when and where its
// [[event]]s are first.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "perf/cost/subject.h"

namespace ballpark::cost {

struct Observation {
  std::string name, unit;  ///< "state.0.x", "landing" [s], "place of landing" [m]; the unit of an expectation is open
  Vector3d value = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());  ///< a number has x alone
  bool there = false;                                                             ///< or the run does not have it
  bool missed = false;                                                            ///< an expectation that was not met
};

/// The scene's file with another scene: in the order of its expectations and events, each event twice. nullopt if it
/// was stopped. Throws SceneError.
std::optional<std::vector<Observation>> observe(const scenes::SceneFile& file, const Scene& scene,
                                                const Options& options, const GoOn& go_on);

/// How far two are apart; infinite: one run does not have it.
double apart(const Observation& a, const Observation& b);

}  // namespace ballpark::cost
