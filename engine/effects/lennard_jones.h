// Lennard-Jones pairs: atoms that hold each other at a distance. In powers of r^2 alone.
#pragma once

#include "engine/effects/short_range.h"

namespace ballpark::BALLPARK_PRECISION {

struct LennardJones {
  static constexpr int flops = 22;
  Real epsilon, sigma_squared, cutoff, shift;

  explicit LennardJones(const EffectInput& input)
      : epsilon(input.number("epsilon")),
        sigma_squared(input.number("sigma") * input.number("sigma")),
        cutoff(input.number("cutoff")),
        shift(0) {
    shift = energy(cutoff * cutoff);
  }

  template <class V>
  V push(const V& square) const {
    const V inverse = V(Real(1)) / square, ratio = V(sigma_squared) * inverse, sixth = ratio * ratio * ratio;
    return V(24 * epsilon) * (sixth * (sixth + sixth - V(Real(1)))) * inverse;
  }
  Real energy(Real square) const {
    const Real ratio = sigma_squared / square, sixth = ratio * ratio * ratio;
    return 4 * epsilon * (sixth * (sixth - 1)) - shift;
  }

  static EffectDescription description() {
    return {
        .name = "lennard_jones",
        .doc =
            "repels near and attracts far pairs, U = 4 e ((s/r)^12 - (s/r)^6) - U_c for r < c, shifted by U_c to "
            "be 0 at c, where the force is not shifted but ends with a jump; c = 2^(1/6) s: no jump, repels only",
        .source =
            "Jones 1924, Proc. R. Soc. A 106, 463; Allen & Tildesley 2017, 1.3; c = 2^(1/6) s: Weeks, "
            "Chandler & Andersen 1971, J. Chem. Phys. 54, 5237",
        .parameters = {{.name = "epsilon", .unit = "J", .fallback = {}, .minimum = 0, .doc = "e: depth of the well"},
                       {.name = "sigma",
                        .unit = "m",
                        .fallback = {},
                        .minimum = least_reach,
                        .doc = "s: where U, unshifted, is 0; it is least at 2^(1/6) s"},
                       cutoff_parameter("c: pairs farther apart than that do nothing; 2.5 s is common")},
        .reads = {"position"},
        .exerts = {"force"},
        .has_energy = true,
        .flops = flops,
        .between_bodies = true};
  }
};

}  // namespace ballpark::BALLPARK_PRECISION
