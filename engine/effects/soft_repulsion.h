// Soft repulsion: pairs that may pass through each other, and are pushed apart the less the nearer they are.
#pragma once

#include "engine/effects/short_range.h"
#include "engine/kernels/wave.h"

namespace ballpark::BALLPARK_PRECISION {

struct SoftRepulsion {
  static constexpr int flops = 66;
  Real strength, cutoff;

  explicit SoftRepulsion(const EffectInput& input)
      : strength(input.number("strength")), cutoff(input.number("cutoff")) {}

  template <class V>
  V push(const V& square) const {
    constexpr Real pi = Real(3.14159265358979323846264338327950288L);
    const V r = square_root(square);
    return V(pi * strength / cutoff) * wave(r / V(2 * cutoff)).sine / r;
  }
  Real energy(Real square) const {
    const Real cosine = wave(square_root(square) / (4 * cutoff)).cosine;  // 1 + cos 2h = 2 cos^2 h
    return 2 * strength * (cosine * cosine);
  }

  static EffectDescription description() {
    return {.name = "soft_repulsion",
            .doc = "pushes bodies apart that overlap, never hard, U = A (1 + cos(pi r/c)) for r < c",
            .source = "pair_style soft of LAMMPS (Thompson et al. 2022, Comput. Phys. Commun. 271, 108171)",
            .parameters = {{.name = "strength",
                            .unit = "J",
                            .fallback = {},
                            .minimum = 0,
                            .doc = "A: half of what it takes to bring two bodies to one place"},
                           cutoff_parameter("c: pairs farther apart than that do nothing")},
            .reads = {"position"},
            .exerts = {"force"},
            .has_energy = true,
            .flops = flops,
            .between_bodies = true};
  }
};

}  // namespace ballpark::BALLPARK_PRECISION
