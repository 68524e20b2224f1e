// Linear (Stokes) drag: F = -k v.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct LinearDrag {
  static constexpr bool feels_flow = true;
  struct Constants {
    Real coefficient;
  };

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    loads.force -= V(c.coefficient) * body.velocity;
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants& c, const Body<V>&, const Acceleration<V>& a, Loads<V>& rate) {
    rate.force -= V(c.coefficient) * a.linear;
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "linear_drag",
            .doc = "drag in proportion to speed, F = -k v; a sphere in a viscous fluid has k = 6 pi eta R",
            .source = "Stokes 1851",
            .parameters = {{.name = "coefficient", .unit = "kg/s", .fallback = {}, .minimum = 0, .doc = "k"}},
            .reads = {"velocity"},
            .exerts = {"force"},
            .flops = 6};
  }
  static Constants pack(const EffectInput& input) {
    return {input.number("coefficient")};
  }
  static Stiffness stiffness(const EffectInput& input) {
    return {0, input.exact("coefficient")};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
