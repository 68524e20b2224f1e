// Boundaries as lines in space.
#pragma once

#include <vector>

#include "scenarios/view/recording.h"

namespace ballpark::view {

struct Line {
  Vector3d from, to;
};

/// Boxes by their edges; of what has no end, as much as lies near the box: a plane as a grid, a tube as circles.
std::vector<Line> outline(const Boundary& boundary, double time, const Box& box);

/// How far it has moved by then.
Vector3d displacement(const Boundary& boundary, double time);

}  // namespace ballpark::view
