// A scene file while it is being read: the scene, and what the file says of bodies before their files are read.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "ballpark/scenes.h"

namespace ballpark::scenes {

struct BodyDraft : BodyGroup {
  std::string file;  ///< rows of the group (.npy, .csv), relative to the scene file
};

struct Draft {
  SceneFile file;
  std::vector<BodyDraft> bodies;
};

/// What a table of the file fills.
using Owner = std::variant<Draft*, RunSettings*, BodyDraft*, Generate*, Effect*, Impulse*, OutputRequest*,
                           EventRequest*, Expectation*, StressRequest*, StressCell*, Material*, MaterialPair*,
                           Boundary*, Motion*, ContactSettings*>;

/// A value of the file after its type was checked.
using Parsed =
    std::variant<double, std::uint64_t, bool, std::string, Vector3d, std::vector<double>, std::vector<std::uint64_t>,
                 std::vector<Vector3d>, std::vector<Quaternion>, std::vector<std::string>, std::vector<IdPair>>;

}  // namespace ballpark::scenes
