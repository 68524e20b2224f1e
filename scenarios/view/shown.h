// Which bodies of a world are shown, and what the scene says of them.
#pragma once

#include <vector>

#include "ballpark/world.h"
#include "scenarios/view/recording.h"

namespace ballpark::view {

/// What kinetic energy needs.
struct Inertia {
  double mass = 0;
  Vector3d moments = Vector3d::Zero();  ///< principal [kg m^2]
};

struct ShownBodies {
  std::vector<ShownGroup> groups;
  std::vector<std::size_t> ids;   ///< sorted by group
  std::vector<Inertia> inertias;  ///< one for each
  std::size_t stride = 1;
};

/// At most about `most` bodies: every stride-th of each group over all copies, each group's first at least.
ShownBodies shown_bodies(const Scene& scene, const World& world, int copies, std::size_t most);

/// Bodies of each group in one copy, in the scene's order, which is that of ids.
std::vector<std::size_t> group_counts(const Scene& scene, const World& world, int copies);

/// Balls that spin get an orientation, which nothing but the eye needs. Groups that could not run with one stay.
void let_spinning_balls_turn(Scene& scene, const Options& options);

}  // namespace ballpark::view
