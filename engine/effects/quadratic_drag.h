// Quadratic (Newton) drag: F = -k |v| v.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct QuadraticDrag {
  static constexpr bool feels_flow = true;
  struct Constants {
    Real coefficient;
  };

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    loads.force -= (V(c.coefficient) * length(body.velocity)) * body.velocity;
  }

  /// F' = -k (|v| a + (v.a / |v|) v); zero at rest.
  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants& c, const Body<V>& body, const Acceleration<V>& a,
                                         Loads<V>& rate) {
    const V zero = V(Real(0)), k = V(c.coefficient), speed = length(body.velocity);
    const V stretch = select(speed > zero, dot(body.velocity, a.linear) / speed, zero);
    rate.force -= k * (speed * a.linear + stretch * body.velocity);
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "quadratic_drag",
            .doc =
                "drag in proportion to the square of the speed, F = -k |v| v; a body of area A in a fluid of density "
                "rho has k = rho C A / 2",
            .source = "Newton, Principia II",
            .parameters = {{.name = "coefficient", .unit = "kg/m", .fallback = {}, .minimum = 0, .doc = "k"}},
            .reads = {"velocity"},
            .exerts = {"force"},
            .flops = 13};
  }
  static Constants pack(const EffectInput& input) {
    return {input.number("coefficient")};
  }
  /// Linearised at the fastest body of the start: dF/dv = -2 k |v| along v.
  static Stiffness stiffness(const EffectInput& input) {
    return {0, 2 * input.exact("coefficient") * input.largest_speed};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
