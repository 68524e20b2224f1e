// A trap about a centre, along each axis of its own stiffness: F = -(kx x, ky y, kz z) from the centre.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct HarmonicTrap {
  struct Constants {
    Vector3<Real> centre, stiffness;
  };

  template <class V>
  BALLPARK_INLINE static Vector3<V> from_centre(const Constants& c, const Body<V>& body) {
    return body.position - Vector3<V>{V(c.centre.x), V(c.centre.y), V(c.centre.z)};
  }
  template <class V>
  BALLPARK_INLINE static Vector3<V> times_stiffness(const Constants& c, const Vector3<V>& a) {
    return {V(c.stiffness.x) * a.x, V(c.stiffness.y) * a.y, V(c.stiffness.z) * a.z};
  }

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    loads.force -= times_stiffness(c, from_centre(c, body));
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants& c, const Body<V>& body, const Acceleration<V>&,
                                         Loads<V>& rate) {
    rate.force -= times_stiffness(c, body.velocity);
  }

  template <class V>
  BALLPARK_INLINE static V energy(const Constants& c, const Body<V>& body) {
    const Vector3<V> r = from_centre(c, body);
    return V(Real(0.5)) * dot(r, times_stiffness(c, r));
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "harmonic_trap",
            .doc = "trap about a centre, F = -(kx x, ky y, kz z), x, y, z from the centre",
            .source = "Landau & Lifshitz, Mechanics 21 and 23",
            .parameters = {{.name = "centre",
                            .kind = ParameterKind::vector,
                            .unit = "m",
                            .fallback = Vector3d(0, 0, 0),
                            .doc = "where it pulls to"},
                           {.name = "stiffness",
                            .kind = ParameterKind::vector,
                            .unit = "N/m",
                            .fallback = {},
                            .doc = "kx, ky, kz; 0 lets go of an axis, a negative one pushes away"}},
            .reads = {"position"},
            .exerts = {"force"},
            .flops = 9};
  }
  static Constants pack(const EffectInput& input) {
    return {input.vector("centre"), input.vector("stiffness")};
  }
  /// Of the stiffest axis.
  static Stiffness stiffness(const EffectInput& input) {
    return {input.exact_vector("stiffness").maxCoeff()};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
