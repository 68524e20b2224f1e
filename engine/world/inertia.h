// Angular momentum and inertia about the centre of mass or a pivot, for building and changing bodies.
#pragma once

#include <array>
#include <cmath>

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

/// Unit eigenvectors of a symmetric matrix xx, yy, zz, xy, xz, yz, one after the other, then its eigenvalues: Jacobi's
/// rotations (Golub & Van Loan, Matrix Computations, 8.5).
inline std::array<Wide, 12> principal_axes(const std::array<Wide, 6>& m) {
  Wide a[3][3] = {{m[0], m[3], m[4]}, {m[3], m[1], m[5]}, {m[4], m[5], m[2]}}, axes[3][3] = {{1}, {0, 1}, {0, 0, 1}};
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (a[p][q] == 0) continue;
        const Wide theta = (a[q][q] - a[p][p]) / (2 * a[p][q]), root = std::sqrt(theta * theta + 1);
        const Wide t = theta < 0 ? 1 / (theta - root) : 1 / (theta + root), c = 1 / std::sqrt(t * t + 1), s = t * c;
        for (auto& row : a) {
          const Wide at_p = row[p], at_q = row[q];
          row[p] = c * at_p - s * at_q, row[q] = s * at_p + c * at_q;
        }
        for (int i = 0; i < 3; ++i) {
          const Wide at_p = a[p][i], at_q = a[q][i];
          a[p][i] = c * at_p - s * at_q, a[q][i] = s * at_p + c * at_q;
          const Wide axis_p = axes[p][i], axis_q = axes[q][i];
          axes[p][i] = c * axis_p - s * axis_q, axes[q][i] = s * axis_p + c * axis_q;
        }
      }
    }
  }
  return {axes[0][0], axes[0][1], axes[0][2], axes[1][0], axes[1][1], axes[1][2],
          axes[2][0], axes[2][1], axes[2][2], a[0][0],    a[1][1],    a[2][2]};
}

}  // namespace ballpark::BALLPARK_PRECISION
