// A fluid's friction on spin: T = -c w.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct SpinDecay {
  struct Constants {
    Real coefficient;
  };

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    loads.torque -= V(c.coefficient) * body.spin;
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants& c, const Body<V>&, const Acceleration<V>& a, Loads<V>& rate) {
    rate.torque -= V(c.coefficient) * a.angular;
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "spin_decay",
            .doc =
                "friction of a fluid on spin, T = -c w; a sphere in a viscous fluid has c = 8 pi eta R^3, and a ball "
                "of moment I spins as exp(-c t / I)",
            .source = "Kirchhoff 1876; Lamb, Hydrodynamics 334",
            .parameters = {{.name = "coefficient", .unit = "N m s", .fallback = {}, .minimum = 0, .doc = "c"}},
            .reads = {"spin"},
            .exerts = {"torque"},
            .flops = 6};
  }
  static Constants pack(const EffectInput& input) {
    return {input.number("coefficient")};
  }
  static Stiffness stiffness(const EffectInput& input) {
    return {.turning = input.exact("coefficient")};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
