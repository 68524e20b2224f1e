// Angular momentum and inertia about the centre of mass or a pivot, for building and changing bodies.
#pragma once

#include <array>

#include "ballpark/scene.h"
#include "engine/kernels/vector3.h"

namespace ballpark::BALLPARK_PRECISION {

/// What initial values are computed in: at least double.
using Wide = std::conditional_t<std::is_same_v<Real, float>, double, Real>;

inline Vector3<Wide> wide(const Vector3d& a) {
  return {a.x(), a.y(), a.z()};
}
inline Rotation<Wide> rotation_of(const Quaternion& q) {
  return Rotation<Wide>(q.w, q.x, q.y, q.z);
}

/// L = J w in the body frame, J = I + m (a^2 1 - a a^T): principal moments I about the centre of mass [kg m^2], arm a
/// from the fixed point to it [m] (zero for a free body).
inline Vector3<Wide> momentum_in_body(const Vector3<Wide>& inertia, Wide mass, const Vector3<Wide>& arm,
                                      const Vector3<Wide>& spin) {
  const Vector3<Wide> own = {inertia.x * spin.x, inertia.y * spin.y, inertia.z * spin.z};
  return own + mass * (dot(arm, arm) * spin - dot(arm, spin) * arm);
}

/// J^-1 as xx, yy, zz, xy, xz, yz [1/(kg m^2)]. A point mass (I = 0) has none about its arm: zero there, so that it
/// never spins about it.
inline std::array<Wide, 6> inverse_about_pivot(const Vector3<Wide>& inertia, Wide mass, const Vector3<Wide>& arm) {
  const Wide square = dot(arm, arm), m = mass;
  if (inertia.x == 0 && inertia.y == 0 && inertia.z == 0) {
    const Wide f = 1 / (m * square * square);
    return {f * (square - arm.x * arm.x), f * (square - arm.y * arm.y), f * (square - arm.z * arm.z),
            -f * arm.x * arm.y,           -f * arm.x * arm.z,           -f * arm.y * arm.z};
  }
  const Wide xx = inertia.x + m * (arm.y * arm.y + arm.z * arm.z), xy = -m * arm.x * arm.y;
  const Wide yy = inertia.y + m * (arm.x * arm.x + arm.z * arm.z), xz = -m * arm.x * arm.z;
  const Wide zz = inertia.z + m * (arm.x * arm.x + arm.y * arm.y), yz = -m * arm.y * arm.z;
  const Wide cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
  const Wide f = 1 / (xx * cxx + xy * cxy + xz * cxz);
  return {f * cxx, f * (xx * zz - xz * xz), f * (xx * yy - xy * xy), f * cxy, f * cxz, f * (xy * xz - xx * yz)};
}

}  // namespace ballpark::BALLPARK_PRECISION
