// A torque that the scene or the caller applies for a while.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct AppliedTorque {
  struct Constants {
    Vector3<Real> torque;
    RowChoice rows;
    Window window;
  };

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    if (!c.window.active || c.rows.misses<V>(body.row)) return;
    const auto& t = c.torque;
    loads.torque += c.rows.only_here(Vector3<V>{V(t.x), V(t.y), V(t.z)}, body.row);
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants&, const Body<V>&, const Acceleration<V>&, Loads<V>&) {}

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "torque",
            .doc = "a constant torque, for a while, in world axes",
            .source = "Euler's second law",
            .parameters = {{.name = "torque", .kind = ParameterKind::vector, .unit = "N m", .fallback = {}, .doc = "T"},
                           {.name = "at", .unit = "s", .fallback = 0.0, .doc = "when it begins"},
                           {.name = "until",
                            .unit = "s",
                            .fallback = std::numeric_limits<double>::infinity(),
                            .doc = "when it ends"}},
            .reads = {},
            .exerts = {"torque"},
            .flops = 3};
  }
  static Constants pack(const EffectInput& input) {
    return {input.vector("torque"), {}, {input.exact("at"), input.exact("until")}};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
