// Space that repeats: distances are those of nearest images.
#pragma once

#include <cmath>

#include "engine/kernels/vector3.h"

namespace ballpark::BALLPARK_PRECISION {

/// Length after which space repeats along each axis [m]; 0: open. At least two of the largest reaches, so that a pair
/// is near in one way only.
struct Period {
  Real length[3] = {};
  bool any() const { return length[0] > 0 || length[1] > 0 || length[2] > 0; }
};

/// The nearest of a distance's images: most are it themselves.
inline Real nearest_image(Real distance, Real period) {
  if (!(period > 0) || std::abs(distance) < Real(0.49) * period) return distance;
  return distance - period * std::floor(distance / period + Real(0.5));
}

inline Vector3<Real> nearest_image(const Vector3<Real>& apart, const Period& period) {
  if (!period.any()) return apart;
  return {nearest_image(apart.x, period.length[0]), nearest_image(apart.y, period.length[1]),
          nearest_image(apart.z, period.length[2])};
}

}  // namespace ballpark::BALLPARK_PRECISION
