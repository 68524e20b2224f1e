// When two balls are near: the one test that the grid and its oracle share.
#pragma once

#include <cmath>

#include "engine/kernels/body.h"

namespace ballpark::BALLPARK_PRECISION {

/// Balls by row. Two are near if their surfaces are at most `margin` apart.
struct Balls {
  const Real* position[3] = {};  ///< [m]
  PerBody radius;                ///< [m]
  std::size_t count = 0;
  Real margin = 0;  ///< [m], not negative
};

/// Length after which space repeats along each axis [m]; 0: open. At least two of the largest reaches, so that a pair
/// is near in one way only.
struct Period {
  Real length[3] = {};
  bool any() const { return length[0] > 0 || length[1] > 0 || length[2] > 0; }
};

/// The nearest of a distance's images.
inline Real nearest_image(Real distance, Real period) {
  return period > 0 ? distance - period * std::floor(distance / period + Real(0.5)) : distance;
}

inline Vector3<Real> nearest_image(const Vector3<Real>& apart, const Period& period) {
  if (!period.any()) return apart;
  return {nearest_image(apart.x, period.length[0]), nearest_image(apart.y, period.length[1]),
          nearest_image(apart.z, period.length[2])};
}

/// `reach`: sum of the radii and the margin.
BALLPARK_INLINE bool within(Real dx, Real dy, Real dz, Real reach) {
  return dx * dx + dy * dy + dz * dz <= reach * reach;
}

}  // namespace ballpark::BALLPARK_PRECISION
