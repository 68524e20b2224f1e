// A fluid that flows: u = U + S (z - z0). Exerts nothing itself: drag and lift read velocity relative to it.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct Wind {
  struct Constants {
    Vector3<Real> velocity, shear;
    Real height;
  };

  template <class V>
  BALLPARK_INLINE static Vector3<V> flow(const Constants& c, const Body<V>& body, double) {
    const V above = body.position.z - V(c.height);
    return Vector3<V>{V(c.velocity.x), V(c.velocity.y), V(c.velocity.z)} +
           above * Vector3<V>{V(c.shear.x), V(c.shear.y), V(c.shear.z)};
  }

  template <class V>
  BALLPARK_INLINE static Vector3<V> flow_rate(const Constants& c, const Body<V>& body, double) {
    return body.velocity.z * Vector3<V>{V(c.shear.x), V(c.shear.y), V(c.shear.z)};
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "wind",
            .doc =
                "a fluid that flows, u = U + S (z - z0): linear_drag, quadratic_drag, reynolds_drag and magnus read "
                "velocity relative to it, and it exerts nothing else",
            .source = "Galilean invariance; linear shear: Batchelor, An Introduction to Fluid Dynamics 2.3",
            .parameters = {{.name = "velocity",
                            .kind = ParameterKind::vector,
                            .unit = "m/s",
                            .fallback = {},
                            .doc = "U, at the height z0"},
                           {.name = "shear",
                            .kind = ParameterKind::vector,
                            .unit = "1/s",
                            .fallback = Vector3d(0, 0, 0),
                            .doc = "S, what it gains with each metre of height"},
                           {.name = "height", .unit = "m", .fallback = 0.0, .doc = "z0"}},
            .reads = {"position"},
            .exerts = {"flow"},
            .flops = 10};
  }
  static Constants pack(const EffectInput& input) {
    return {input.vector("velocity"), input.vector("shear"), input.number("height")};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
