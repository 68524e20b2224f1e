// The fluid that a sphere takes along as it speeds up: (m + C rho V) a = F, V = 4/3 pi R^3. It pushes nothing: build
// adds it to what resists every force, those of contacts and impulses too.
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct AddedMass {
  struct Constants {
    PerBody radius;
    Real per_cube;  ///< 4/3 pi C rho
  };

  /// [kg]
  template <class V>
  BALLPARK_INLINE static V added_mass(const Constants& c, std::size_t row) {
    const V r = c.radius.at<V>(row);
    return V(c.per_cube) * (r * r * r);
  }

  /// The kinetic energy of that fluid.
  template <class V>
  BALLPARK_INLINE static V energy(const Constants& c, const Body<V>& body) {
    return V(Real(0.5)) * added_mass<V>(c, body.row) * dot(body.velocity, body.velocity);
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "added_mass",
            .doc =
                "fluid that a sphere takes along as it speeds up, (m + C rho V) a = F, V = 4/3 pi R^3 of the bodies' "
                "radius; its energy is that fluid's",
            .source = "Green 1833, Stokes 1843; Lamb, Hydrodynamics 92",
            .parameters = {{.name = "density",
                            .unit = "kg/m^3",
                            .fallback = {},
                            .minimum = 0,
                            .doc = "rho of the fluid, e.g. 998 of water"},
                           {.name = "coefficient",
                            .unit = "1",
                            .fallback = 0.5,
                            .minimum = 0,
                            .doc = "C: 0.5 for a sphere far from walls and others"}},
            .reads = {"radius"},
            .exerts = {"inertia"},
            .has_force_derivative = true};
  }
  static Constants pack(const EffectInput& input) {
    const double per_cube = four_thirds_pi * input.exact("density") * input.exact("coefficient");
    return {input.radius, static_cast<Real>(per_cube)};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
