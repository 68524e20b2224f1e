// The impact of two balls, or of a ball and a wall: an instantaneous impulse with restitution and Coulomb friction,
// which ends sliding or, if it can, makes the surfaces stick. (Walton & Braun 1986, with tangential restitution 0;
// Foerster, Louge, Chang & Allia 1994, Phys. Fluids 6, 1108.)
#pragma once

#include "engine/core/maths.h"
#include "engine/kernels/vector3.h"

namespace ballpark::BALLPARK_PRECISION {

/// One side of an impact. A wall has infinite mass: zeros, and the velocity of its surface.
template <class V>
struct ImpactSide {
  V inverse_mass = V(Real(0));     ///< [1/kg]
  V inverse_inertia = V(Real(0));  ///< isotropic [1/(kg m^2)]
  V radius = V(Real(0));           ///< [m]
  Vector3<V> velocity;             ///< [m/s]
  Vector3<V> spin;                 ///< world frame [rad/s]
};

/// Material of a pair.
struct ImpactLaw {
  Real restitution = 1;        ///< e, in [0, 1]
  Real friction = 0;           ///< mu, not negative
  Real restitution_speed = 0;  ///< v0 [m/s]; 0: one restitution for all speeds
  Real cohesion = 0;           ///< work of adhesion, of contacts that last [J/m^2]

  /// Viscoelastic below v0, plastic above. (McNamara & Falcon 2005, Phys. Rev. E 71, 031302, eq. 1)
  Real restitution_at(Real approach) const {
    if (restitution_speed == 0) return restitution;
    const auto share = static_cast<double>(approach) / static_cast<double>(restitution_speed);
    if (share > 1) return static_cast<Real>(static_cast<double>(restitution) / __builtin_sqrt(__builtin_sqrt(share)));
    return static_cast<Real>(1 - (1 - static_cast<double>(restitution)) * maths::pow(share, 0.2));
  }
};

/// Velocity of surface 1 over surface 2 at the contact; `normal` points from 1 to 2.
template <class V>
BALLPARK_INLINE Vector3<V> slip_of(const ImpactSide<V>& one, const ImpactSide<V>& two, const Vector3<V>& normal) {
  return one.velocity + one.radius * cross(one.spin, normal) - two.velocity + two.radius * cross(two.spin, normal);
}

/// The impulse on side 2 [N s]; side 1 gets its opposite. Zero where the sides do not approach.
template <class V>
BALLPARK_INLINE Vector3<V> impact_impulse(const ImpactSide<V>& one, const ImpactSide<V>& two, const Vector3<V>& normal,
                                          const ImpactLaw& law) {
  const V zero = V(Real(0)), unit = V(Real(1));
  const Vector3<V> u = slip_of(one, two, normal);
  const V approach = dot(u, normal);
  const Vector3<V> tangential = u - approach * normal;
  const V slip = length(tangential);
  const V inverse_mass = one.inverse_mass + two.inverse_mass;
  const V turning = one.radius * one.radius * one.inverse_inertia + two.radius * two.radius * two.inverse_inertia;
  const V pressed = V(Real(1) + law.restitution) * approach / inverse_mass;
  const V sticking = slip / (inverse_mass + turning), sliding = V(law.friction) * pressed;
  const V friction = select(sticking > sliding, sliding, sticking);
  const V per_slip = select(slip > zero, friction / select(slip > zero, slip, unit), zero);
  const Vector3<V> impulse = pressed * normal + per_slip * tangential;
  const auto meets = approach > zero;
  return {select(meets, impulse.x, zero), select(meets, impulse.y, zero), select(meets, impulse.z, zero)};
}

/// Both sides after the impulse on side 2.
template <class V>
BALLPARK_INLINE void apply_impact(const Vector3<V>& impulse, const Vector3<V>& normal, ImpactSide<V>& one,
                                  ImpactSide<V>& two) {
  const Vector3<V> twist = cross(normal, impulse);
  one.velocity -= one.inverse_mass * impulse;
  two.velocity += two.inverse_mass * impulse;
  one.spin -= (one.inverse_inertia * one.radius) * twist;
  two.spin -= (two.inverse_inertia * two.radius) * twist;
}

}  // namespace ballpark::BALLPARK_PRECISION
