// Uniform gravity: F = m g.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct Gravity {
  struct Constants {
    Vector3<Real> acceleration;
  };

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    const auto& g = c.acceleration;
    loads.force += Vector3<V>{body.mass * V(g.x), body.mass * V(g.y), body.mass * V(g.z)};
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants&, const Body<V>&, const Acceleration<V>&, Loads<V>&) {}

  template <class V>
  BALLPARK_INLINE static V energy(const Constants& c, const Body<V>& body) {
    const auto& g = c.acceleration;
    return -body.mass * dot({V(g.x), V(g.y), V(g.z)}, body.position);
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "gravity",
            .doc = "uniform gravity, F = m g",
            .source = "Newton's second law",
            .parameters = {{.name = "acceleration",
                            .kind = ParameterKind::vector,
                            .unit = "m/s^2",
                            .fallback = Vector3d(0, 0, -9.81),
                            .doc = "free-fall acceleration g"}},
            .reads = {},
            .exerts = {"force"},
            .flops = 6};
  }
  static Constants pack(const EffectInput& input) {
    return {input.vector("acceleration")};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
