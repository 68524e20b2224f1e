// A charge in a uniform electric field: F = q E.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct ElectricField {
  struct Constants {
    Vector3<Real> force;
  };

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>&, Loads<V>& loads) {
    loads.force += Vector3<V>{V(c.force.x), V(c.force.y), V(c.force.z)};
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants&, const Body<V>&, const Acceleration<V>&, Loads<V>&) {}

  template <class V>
  BALLPARK_INLINE static V energy(const Constants& c, const Body<V>& body) {
    return -dot({V(c.force.x), V(c.force.y), V(c.force.z)}, body.position);
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "electric_field",
            .doc = "uniform electric field on a charge, F = q E; its potential energy -q E.x is zero at the origin",
            .source = "Lorentz 1895; Landau & Lifshitz, The Classical Theory of Fields 20",
            .parameters = {{.name = "charge", .unit = "C", .fallback = {}, .doc = "q of each body"},
                           {.name = "field", .kind = ParameterKind::vector, .unit = "V/m", .fallback = {}, .doc = "E"}},
            .reads = {},
            .exerts = {"force"},
            .flops = 3};
  }
  static Constants pack(const EffectInput& input) {
    return {input.number("charge") * input.vector("field")};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
