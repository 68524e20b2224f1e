// Magnus lift on a spinning body: F = S w x v.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct Magnus {
  static constexpr bool feels_flow = true;
  struct Constants {
    Real coefficient;
  };

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    loads.force += V(c.coefficient) * cross(body.spin, body.velocity);
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants& c, const Body<V>& body, const Acceleration<V>& a,
                                         Loads<V>& rate) {
    rate.force += V(c.coefficient) * (cross(a.angular, body.velocity) + cross(body.spin, a.linear));
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "magnus",
            .doc = "lift of a spinning body, F = S w x v, w its angular velocity",
            .source = "Magnus 1852; Bourg, Physics for Game Developers",
            .parameters = {{.name = "coefficient", .unit = "kg", .fallback = {}, .doc = "S"}},
            .reads = {"velocity", "spin"},
            .exerts = {"force"},
            .flops = 15};
  }
  static Constants pack(const EffectInput& input) {
    return {input.number("coefficient")};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
