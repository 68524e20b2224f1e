// When two balls are near: the one test that the grid and its oracle share.
#pragma once

#include "engine/kernels/body.h"
#include "engine/kernels/period.h"

namespace ballpark::BALLPARK_PRECISION {

/// Balls by row. Two are near if their surfaces are at most `margin` apart.
struct Balls {
  const Real* position[3] = {};  ///< [m]
  PerBody radius;                ///< [m]
  std::size_t count = 0;
  Real margin = 0;  ///< [m], not negative
};

/// `reach`: sum of the radii and the margin.
BALLPARK_INLINE bool within(Real dx, Real dy, Real dz, Real reach) {
  return dx * dx + dy * dy + dz * dz <= reach * reach;
}

}  // namespace ballpark::BALLPARK_PRECISION
