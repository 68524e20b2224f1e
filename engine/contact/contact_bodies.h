// Bodies that may touch, as contacts see them. A body's rank is that of its id among them: it orders contacts, so that
// no order in memory ever reaches a bit. Its slot is where it lies in memory: near bodies lie near each other. Balls
// have isotropic inertia; their spin is carried as the speed of the surface, R w, in which contact needs no radius.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/collide/vector_column.h"

namespace ballpark::BALLPARK_PRECISION {

/// Alignment of what the solver reads at random: eight values are a line in double.
template <class R>
inline constexpr std::size_t cache_line_of = sizeof(R) == 8 ? 64 : alignof(R);

struct ContactBodies {
  std::size_t count = 0;
  std::size_t per_copy = 0;  ///< slots of one copy of the scene; copies do not touch each other
  bool spins = false;        ///< some contact has friction: surface speeds matter
  bool turns = false;        ///< somebody carries an orientation

  std::vector<Real> radius;        ///< [m]
  std::vector<Real> inverse_mass;  ///< [1/kg]
  std::vector<Real> mobility;      ///< R^2 / I [1/kg]: surface speed per tangential impulse
  std::vector<std::uint16_t> material;
  std::vector<std::uint32_t> ranks, slots;  ///< of each slot; of each rank. Empty: they are the same
  std::vector<std::uint16_t> spare_material;

  // At the start of a substep, as the state columns had it:
  VectorColumn position;  ///< [m]
  VectorColumn velocity;  ///< [m/s]
  VectorColumn surface;   ///< R w [m/s]
  // After its smooth motion (the trial), and then what contacts make of it:
  VectorColumn end_position, end_velocity, end_surface;
  VectorColumn turned;  ///< if `turns`: what contacts add to the rotation of the substep, times R [m]

  std::uint32_t rank_of(std::size_t slot) const {
    return ranks.empty() ? static_cast<std::uint32_t>(slot) : ranks[slot];
  }
  std::uint32_t slot_of(std::size_t rank) const {
    return slots.empty() ? static_cast<std::uint32_t>(rank) : slots[rank];
  }
  /// Moves what is constant to new slots: slot i gets what was in order[i]. The rest is read anew in each substep.
  void sort(const std::vector<std::uint32_t>& order);

  /// `solved`: does a solver need the end of a substep, too?
  void resize(std::size_t n, bool solved);
  std::size_t bytes() const;
};

}  // namespace ballpark::BALLPARK_PRECISION
