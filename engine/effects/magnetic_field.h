// A charge in a uniform magnetic field: F = q v x B.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct MagneticField {
  struct Constants {
    Vector3<Real> field;  ///< times the charge [kg/s]
  };

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    loads.force += cross(body.velocity, {V(c.field.x), V(c.field.y), V(c.field.z)});
  }

  template <class V>
  BALLPARK_INLINE static Vector3<V> turning(const Constants& c, const Body<V>& body) {
    return (V(Real(-1)) / body.mass) * Vector3<V>{V(c.field.x), V(c.field.y), V(c.field.z)};
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants& c, const Body<V>&, const Acceleration<V>& a, Loads<V>& rate) {
    rate.force += cross(a.linear, {V(c.field.x), V(c.field.y), V(c.field.z)});
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {
        .name = "magnetic_field",
        .doc =
            "uniform magnetic field on a charge, F = q v x B: turns the velocity at the rate |q B| / m, does no work",
        .source = "Lorentz 1895; Landau & Lifshitz, The Classical Theory of Fields 21",
        .parameters = {{.name = "charge", .unit = "C", .fallback = {}, .doc = "q of each body"},
                       {.name = "field", .kind = ParameterKind::vector, .unit = "T", .fallback = {}, .doc = "B"}},
        .reads = {"velocity"},
        .exerts = {"force"},
        .flops = 12};
  }
  static Constants pack(const EffectInput& input) {
    return {input.number("charge") * input.vector("field")};
  }
  static Stiffness stiffness(const EffectInput& input) {
    return {.gyration = std::abs(input.exact("charge")) * input.exact_vector("field").norm()};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
