// Kernels of effects between bodies, as pointers: one set for each target.
#pragma once

#include <cstddef>

#include "engine/core/real.h"

namespace ballpark::BALLPARK_PRECISION {

/// Bodies that attract each other, as columns from the first slot of a copy on.
struct Attraction {
  const Real* position[3];
  const Real* mass;
  std::size_t count = 0;       ///< bodies; the columns are padded
  Real strength = 0;           ///< G
  Real softening_squared = 0;  ///< s^2
};

/// For slots [first, last), a multiple of any vector.
struct PairKernels {
  /// Force on each [N].
  void (*attract)(const Attraction&, std::size_t first, std::size_t last, Real* const* force);
  /// Half of each body's energy in the field of the others [J].
  void (*attraction_energy)(const Attraction&, std::size_t first, std::size_t last, Real* energy);
};

}  // namespace ballpark::BALLPARK_PRECISION
