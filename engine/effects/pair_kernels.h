// Kernels of effects between bodies, as pointers: one set for each target.
#pragma once

#include <cstddef>

#include "engine/core/real.h"

namespace ballpark::BALLPARK_PRECISION {

/// Bodies that attract each other: some copies of `count` bodies, one behind the other, as columns from the first on.
struct Attraction {
  const Real* position[3];
  const Real* mass;
  std::size_t count = 0, copies = 1;
  std::size_t end = 0;         ///< of what may be read and written, from the first body on: no less than a vector
  Real strength = 0;           ///< G
  Real softening_squared = 0;  ///< s^2
};

/// Some bodies, and all that pulls at them: points, and cells with second moments, see gravity_tree.h.
struct Pull {
  const Real* position[3];  ///< of the bodies, with room for a vector behind the last
  std::size_t bodies = 0;
  const Real* points[4];  ///< x, y, z, mass
  std::size_t point_count = 0;
  const Real* cells[10];  ///< x, y, z, mass, then sums of m times xx, yy, zz, xy, xz, yz
  std::size_t cell_count = 0;
  Real softening_squared = 0;
};

/// Woven copies: so many at a time stand body by body, each body of all of them in one cache line.
inline constexpr std::size_t woven_width = 64 / sizeof(Real);
inline constexpr std::size_t most_woven = 32;  ///< bodies of a copy that may be woven

/// For bodies [first, last) of each copy; or for all of woven copies.
struct PairKernels {
  /// Adds the force on each [N].
  void (*attract)(const Attraction&, std::size_t first, std::size_t last, Real* const* force);
  /// Adds half of each body's energy in the field of the others [J].
  void (*attraction_energy)(const Attraction&, std::size_t first, std::size_t last, Real* energy);
  void (*attract_woven)(const Attraction&, Real* const* force);
  void (*woven_attraction_energy)(const Attraction&, Real* energy);
  /// What is pulled at, but for G: accelerations, as columns; or potentials. Both with room for a vector.
  void (*pull)(const Pull&, Real* const* acceleration);
  void (*pull_potential)(const Pull&, Real* potential);
};

}  // namespace ballpark::BALLPARK_PRECISION
