// A force that the scene or the caller applies for a while: F at a point fixed relative to the centre of mass.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct AppliedForce {
  struct Constants {
    Vector3<Real> force, torque;
    RowChoice rows;
    Window window;
  };

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    if (!c.window.active || c.rows.misses<V>(body.row)) return;
    const auto &f = c.force, &t = c.torque;
    loads.force += c.rows.only_here(Vector3<V>{V(f.x), V(f.y), V(f.z)}, body.row);
    loads.torque += c.rows.only_here(Vector3<V>{V(t.x), V(t.y), V(t.z)}, body.row);
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants&, const Body<V>&, const Acceleration<V>&, Loads<V>&) {}

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "force",
            .doc = "a constant force, for a while, at an offset from the centre of mass (torque = offset x F)",
            .source = "Newton's second law",
            .parameters = {{.name = "force", .kind = ParameterKind::vector, .unit = "N", .fallback = {}, .doc = "F"},
                           {.name = "offset",
                            .kind = ParameterKind::vector,
                            .unit = "m",
                            .fallback = Vector3d(0, 0, 0),
                            .doc = "point of application minus centre of mass, world axes"},
                           {.name = "at", .unit = "s", .fallback = 0.0, .doc = "when it begins"},
                           {.name = "until",
                            .unit = "s",
                            .fallback = std::numeric_limits<double>::infinity(),
                            .doc = "when it ends"}},
            .reads = {},
            .exerts = {"force", "torque"},
            .flops = 6};
  }
  static Constants pack(const EffectInput& input) {
    const Vector3<Real> f = input.vector("force");
    return {f, cross(input.vector("offset"), f), {}, {input.exact("at"), input.exact("until")}};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
