// What [stress] compares: more runs of a scene beside the one that was judged, or its end beside its start.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ballpark/scenes.h"

namespace ballpark::scenes {

/// A run's last state.
struct Ending {
  std::uint64_t hash = 0;
  std::uint64_t steps = 0;
  std::vector<BodyState> bodies;  ///< by id
};
Ending ending_of(const World& world);

/// What comparing found: each MEASURE that stress.compare asks for, and how the shifted scene's run ended.
struct Compared {
  std::map<std::string, double> measures;
  Status shifted;
};
/// `plain`: the scene's own run. Throws SceneError where the scene cannot be run so.
Compared compared(const SceneFile& file, const Options& options, const Ending& plain);

/// The same scene elsewhere: bodies, boundaries and the places of effects.
Scene shifted(Scene scene, const Vector3d& by);

}  // namespace ballpark::scenes
