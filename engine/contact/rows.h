// One contact at a time: sequential impulses (projected Gauss-Seidel) with Coulomb's cone. (Jean 1999, Comput. Methods
// Appl. Mech. Eng. 177, 235: non-smooth contact dynamics; Catto 2005: accumulated impulses.)
#pragma once

#include "engine/contact/contact_set.h"

namespace ballpark::BALLPARK_PRECISION {

/// A body as the solver sees it: one cache line in double.
struct alignas(cache_line_of<Real>) Mover {
  Vector3<Real> velocity;
  Vector3<Real> surface;  ///< R w
  Real inverse_mass = 0;
  Real mobility = 0;  ///< R^2 / I

  void push(const Vector3<Real>& impulse) { velocity += inverse_mass * impulse; }
  void twist(const Vector3<Real>& turned) { surface -= mobility * turned; }
};

/// Shortens a tangential impulse to Coulomb's cone.
inline Vector3<Real> within_cone(const Vector3<Real>& tangent, Real most) {
  const Real square = dot(tangent, tangent);
  if (square <= most * most) return tangent;
  return (most / square_root(square)) * tangent;
}

/// What the other side of a contact does: a body, or a wall with the velocity of its surface.
struct WallSide {
  Vector3<Real> velocity;
  Vector3<Real> surface;
  static constexpr Real inverse_mass = 0, mobility = 0;
  void push(const Vector3<Real>&) const {}
  void twist(const Vector3<Real>&) const {}
};

/// Adds an impulse to both sides.
template <bool friction, class Side>
inline void apply(const ContactImpulse& impulse, const Vector3<Real>& normal, Side& a, Mover& b) {
  Vector3<Real> all = impulse.normal * normal;
  if constexpr (friction) {
    all += impulse.tangent;
    const Vector3<Real> turned = cross(normal, impulse.tangent);
    a.twist(turned);
    b.twist(turned);
  }
  a.push(Real(-1) * all);
  b.push(all);
}

/// One Gauss-Seidel update of the impulse `now`, beside which `held` acts already: the normal speed becomes `least`
/// unless that pulls, the slip becomes zero or lies on the cone of the whole impulse. Returns the error in the normal
/// speed that it found [m/s].
template <bool friction, class Side>
inline Real update(const Contact& c, Real least, const ContactImpulse& held, ContactImpulse& now, Side& a, Mover& b) {
  const Vector3<Real> over = b.velocity - a.velocity;
  const Real speed = dot(c.normal, over);
  const Real inverse_mass = a.inverse_mass + b.inverse_mass;
  Real normal = now.normal + 1 / inverse_mass * (least - speed);
  if (normal < -held.normal) normal = -held.normal;
  if (held.normal + normal == 0 && held.normal + now.normal == 0) return 0;  // apart, and so it was
  ContactImpulse change{normal - now.normal, {}};
  now.normal = normal;
  if constexpr (friction) {
    const Vector3<Real> slip = over - speed * c.normal - cross(a.surface + b.surface, c.normal);
    const Real mass = 1 / (inverse_mass + a.mobility + b.mobility);
    const Vector3<Real> wanted = held.tangent + now.tangent - mass * slip;
    const Vector3<Real> tangent = within_cone(wanted, c.friction * (held.normal + normal)) - held.tangent;
    change.tangent = tangent - now.tangent;
    now.tangent = tangent;
  }
  apply<friction>(change, c.normal, a, b);
  const Real error = change.normal * inverse_mass;
  return error < 0 ? -error : error;
}

}  // namespace ballpark::BALLPARK_PRECISION
