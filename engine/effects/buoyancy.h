// Archimedes' lift of a sphere that displaces a fluid at rest: F = -rho V g, V = 4/3 pi R^3.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct Buoyancy {
  struct Constants {
    PerBody radius;
    Vector3<Real> lift;  ///< -4/3 pi rho g
  };

  template <class V>
  BALLPARK_INLINE static Vector3<V> lift(const Constants& c, std::size_t row) {
    const V r = c.radius.at<V>(row), cube = r * r * r;
    return {cube * V(c.lift.x), cube * V(c.lift.y), cube * V(c.lift.z)};
  }

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    loads.force += lift<V>(c, body.row);
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants&, const Body<V>&, const Acceleration<V>&, Loads<V>&) {}

  template <class V>
  BALLPARK_INLINE static V energy(const Constants& c, const Body<V>& body) {
    return -dot(lift<V>(c, body.row), body.position);
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "buoyancy",
            .doc =
                "lift of a sphere by the weight of the fluid that it displaces, F = -rho V g, V = 4/3 pi R^3 of the "
                "bodies' radius",
            .source = "Archimedes, On Floating Bodies I",
            .parameters = {{.name = "density",
                            .unit = "kg/m^3",
                            .fallback = {},
                            .minimum = 0,
                            .doc = "rho of the fluid, e.g. 998 of water, 1.2 of air"},
                           {.name = "acceleration",
                            .kind = ParameterKind::vector,
                            .unit = "m/s^2",
                            .fallback = Vector3d(0, 0, -9.81),
                            .doc = "g, which the fluid weighs by"}},
            .reads = {"radius"},
            .exerts = {"force"},
            .flops = 8};
  }
  static Constants pack(const EffectInput& input) {
    const Vector3d lift = -four_thirds_pi * input.exact("density") * input.exact_vector("acceleration");
    return {input.radius, {static_cast<Real>(lift.x()), static_cast<Real>(lift.y()), static_cast<Real>(lift.z())}};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
