// Spring and damper between a body and a fixed point: F = -k (|r| - l) r/|r| - c v, r from the anchor to the body.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct Spring {
  struct Constants {
    PerBody anchor[3];
    Real stiffness, damping, rest_length;
  };

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    const Vector3<V> r = body.position - vector_at<V>(c.anchor, body.row);
    const V tension = c.rest_length > 0 ? V(c.stiffness) * (V(Real(1)) - slack(c, r)) : V(c.stiffness);
    loads.force -= tension * r + V(c.damping) * body.velocity;
  }

  /// d/dt of the spring's part: -k (v - l (v - r (r.v)/|r|^2) / |r|).
  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants& c, const Body<V>& body, const Acceleration<V>& a,
                                         Loads<V>& rate) {
    Vector3<V> stretch = body.velocity;
    if (c.rest_length > 0) {
      const Vector3<V> r = body.position - vector_at<V>(c.anchor, body.row);
      const V square = dot(r, r), zero = V(Real(0));
      const V along = select(square > zero, dot(r, body.velocity) / square, zero);
      stretch -= slack(c, r) * (body.velocity - along * r);
    }
    rate.force -= V(c.stiffness) * stretch + V(c.damping) * a.linear;
  }

  template <class V>
  BALLPARK_INLINE static V energy(const Constants& c, const Body<V>& body) {
    const V extension = length(body.position - vector_at<V>(c.anchor, body.row)) - V(c.rest_length);
    return V(Real(0.5)) * V(c.stiffness) * extension * extension;
  }

  /// l / |r|; zero at the anchor, where the force has no direction.
  template <class V>
  BALLPARK_INLINE static V slack(const Constants& c, const Vector3<V>& r) {
    const V distance = length(r), zero = V(Real(0));
    return select(distance > zero, V(c.rest_length) / distance, zero);
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "spring",
            .doc = "spring and damper to a fixed point, F = -k (|r| - l) r/|r| - c v, r from the anchor to the body",
            .source = "Hooke's law; the damper acts on the whole velocity",
            .parameters = {{.name = "anchor",
                            .kind = ParameterKind::vectors,
                            .unit = "m",
                            .fallback = {},
                            .doc = "the fixed point: one, or one for each body"},
                           {.name = "stiffness", .unit = "N/m", .fallback = {}, .minimum = 0, .doc = "k"},
                           {.name = "damping", .unit = "N s/m", .fallback = 0.0, .minimum = 0, .doc = "c"},
                           {.name = "rest_length", .unit = "m", .fallback = 0.0, .minimum = 0, .doc = "l"}},
            .reads = {"position", "velocity"},
            .exerts = {"force"},
            .flops = 15};
  }
  static Constants pack(const EffectInput& input) {
    Constants c{};
    input.vectors("anchor", c.anchor);
    c.stiffness = input.number("stiffness");
    c.damping = input.number("damping");
    c.rest_length = input.number("rest_length");
    return c;
  }
  static Stiffness stiffness(const EffectInput& input) {
    return {input.exact("stiffness"), input.exact("damping")};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
