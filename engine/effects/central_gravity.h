// Attraction to a fixed centre by the inverse square of the distance: F = -m mu r / (r^2 + s^2)^(3/2).
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct CentralGravity {
  struct Constants {
    Vector3<Real> centre;
    Real strength, softening_squared;
  };

  template <class V>
  BALLPARK_INLINE static Vector3<V> from_centre(const Constants& c, const Body<V>& body) {
    return body.position - Vector3<V>{V(c.centre.x), V(c.centre.y), V(c.centre.z)};
  }

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    const Vector3<V> r = from_centre(c, body);
    const V square = dot(r, r) + V(c.softening_squared);
    loads.force -= (body.mass * V(c.strength) / (square * square_root(square))) * r;
  }

  /// F' = -m mu (v - 3 r (r.v) / d^2) / d^3, d^2 = r^2 + s^2.
  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants& c, const Body<V>& body, const Acceleration<V>&,
                                         Loads<V>& rate) {
    const Vector3<V> r = from_centre(c, body);
    const V square = dot(r, r) + V(c.softening_squared);
    const V scale = body.mass * V(c.strength) / (square * square_root(square));
    const V along = V(Real(3)) * dot(r, body.velocity) / square;
    rate.force -= scale * (body.velocity - along * r);
  }

  template <class V>
  BALLPARK_INLINE static V energy(const Constants& c, const Body<V>& body) {
    const Vector3<V> r = from_centre(c, body);
    return -body.mass * V(c.strength) / square_root(dot(r, r) + V(c.softening_squared));
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "central_gravity",
            .doc = "inverse-square attraction to a fixed centre, F = -m mu r / (r^2 + s^2)^(3/2)",
            .source = "Newton, Principia I; softening after Plummer 1911",
            .parameters = {{.name = "centre",
                            .kind = ParameterKind::vector,
                            .unit = "m",
                            .fallback = Vector3d(0, 0, 0),
                            .doc = "where it pulls to"},
                           {.name = "strength", .unit = "m^3/s^2", .fallback = {}, .doc = "mu = G M; negative repels"},
                           {.name = "softening", .unit = "m", .fallback = 0.0, .minimum = 0, .doc = "s"}},
            .reads = {"position"},
            .exerts = {"force"},
            .flops = 19};
  }
  static Constants pack(const EffectInput& input) {
    const Real s = input.number("softening");
    return {input.vector("centre"), input.number("strength"), s * s};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
