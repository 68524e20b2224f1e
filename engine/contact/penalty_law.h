// Soft contact by springs and dashpots: along the normal, and across it with a spring that remembers how far the
// surfaces have slid since they touched, up to Coulomb's limit. (Cundall & Strack 1979, Geotechnique 29, 47.)
#pragma once

#include "engine/core/maths.h"
#include "engine/kernels/vector3.h"

namespace ballpark::BALLPARK_PRECISION {

/// What one pair's contact is made of.
struct SpringDashpot {
  Real stiffness = 0;        ///< k [N/m]
  Real damping = 0;          ///< c [N s/m]
  Real slide_stiffness = 0;  ///< of the tangential spring [N/m]
  Real slide_damping = 0;    ///< [N s/m]
  Real friction = 0;         ///< mu
  Real cohesion = 0;         ///< pulls while the surfaces touch [N]
};

/// Where a contact is and how it moves. Velocities are of b over a.
struct Touch {
  Real depth = 0;        ///< overlap [m]
  Vector3<Real> normal;  ///< from a to b
  Real parting = 0;      ///< speed along the normal [m/s]
  Vector3<Real> slip;    ///< of the surfaces, across the normal [m/s]
};

/// Force along the normal on b [N]. A dashpot that may not pull is cut off where the surfaces part faster than the
/// spring pushes.
inline Real push(const SpringDashpot& law, const Touch& touch, bool may_pull) {
  const Real force = law.stiffness * touch.depth - law.damping * touch.parting;
  return force < 0 && !may_pull ? Real(0) : force;
}

/// Friction on b [N]: of the spring stretched by `slid` [m] and its dashpot, at most mu times the push. `share`: how
/// much of the spring remains when it slips.
inline Vector3<Real> friction(const SpringDashpot& law, const Touch& touch, Real push, const Vector3<Real>& slid,
                              Real& share) {
  const Vector3<Real> wanted = Real(-1) * (law.slide_stiffness * slid + law.slide_damping * touch.slip);
  const Real size = length(wanted), most = law.friction * (push > 0 ? push : Real(0));
  share = size > most ? most / size : Real(1);
  return share < 1 ? share * wanted : wanted;
}

/// Damping ratio b = c / (2 sqrt(k m)), m the effective mass, of the contact whose impact ends with restitution e.
/// Inverse of
///   may pull:  e = exp(-pi b / sqrt(1 - b^2)), b < 1
///   else:      e = exp(-b/s atan2(2 b s, 2 b^2 - 1)), s = sqrt(1 - b^2), b < 1
///              e = exp(-b/s ln((b + s)/(b - s))),     s = sqrt(b^2 - 1), b > 1
/// (Schwager & Poeschel 2007, Granular Matter 9, 465.)
inline double restitution_of(double b, bool may_pull) {
  constexpr double pi = 3.141592653589793;
  if (b == 1) return may_pull ? 0 : maths::exp(-2.0);
  if (b < 1) {
    const double s = __builtin_sqrt(1 - b * b);
    return maths::exp(-b / s * (may_pull ? pi : maths::atan2(2 * b * s, 2 * b * b - 1)));
  }
  if (may_pull) return 0;
  const double s = __builtin_sqrt(b * b - 1);
  return maths::exp(-b / s * maths::log((b + s) / (b - s)));
}

inline constexpr double most_damped = 10;  ///< no larger ratio: it asks for ever smaller steps

inline double damping_ratio(double restitution, bool may_pull) {
  if (restitution >= 1) return 0;
  if (may_pull && restitution <= 0) return 1;
  double low = 0, high = may_pull ? 1 : most_damped;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (restitution_of(middle, may_pull) > restitution ? low : high) = middle;
  }
  return high;
}

}  // namespace ballpark::BALLPARK_PRECISION
