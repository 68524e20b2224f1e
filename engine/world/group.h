// What a world is made of: groups of bodies in columns, the blocks and parts that passes go through, and events.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ballpark/scene.h"
#include "engine/effects/local_effects.h"
#include "engine/world/kernel_table.h"
#include "engine/world/pair_system.h"
#include "engine/world/presence.h"

namespace ballpark::BALLPARK_PRECISION {

/// Bodies of a task: a fixed length, whatever the number of threads. A block of particles is 192 kB in double.
inline constexpr std::size_t block_length = 4096;

/// Where a group has the bodies of each copy of the scene. Copy after copy; or woven, so that lanes can run over
/// copies: `width` copies at a time stand body by body, each body of all of them in one cache line.
struct CopyRows {
  static constexpr std::size_t width = woven_width;

  std::size_t per_copy = 0;  ///< bodies in one copy
  std::size_t woven = 0;     ///< copies [0, woven) are, a multiple of the width; those behind them are not

  std::size_t row_of(std::size_t copy, std::size_t index) const {
    if (copy >= woven) return copy * per_copy + index;
    return (copy / width * per_copy + index) * width + copy % width;
  }
  std::size_t copy_of(std::size_t row) const {
    if (row >= woven * per_copy) return row / per_copy;
    return row / (width * per_copy) * width + row % width;
  }
  std::size_t index_of(std::size_t row) const { return (row >= woven * per_copy ? row : row / width) % per_copy; }
};

/// Bodies of one kind: rows [first_row, first_row + live), padded.
struct Group {
  std::string name;
  std::size_t scene_index = 0;
  CopyRows copies;
  std::size_t id_offset = 0;  ///< of its first body in a copy
  std::size_t first_row = 0, live = 0;
  MotionKind motion = MotionKind::point;                  ///< how it is stepped
  MotionKind carried = MotionKind::point;                 ///< with the columns that it carries but no force changes
  MotionKind turning = MotionKind::point;                 ///< how it is stepped once its spin changes
  std::string why;                                        ///< of the motion
  std::vector<std::pair<std::string, double>> constants;  ///< equal over the group, by name
  std::vector<Vector3d> inertia;  ///< principal moments [kg m^2]: none, one, or one for each body of a copy
  std::array<std::vector<std::byte>, LocalEffects::count> effects;  ///< Constants of each instance, by local effect
  std::vector<EffectInstance> instances;                            ///< what kernel.forces points to
  std::vector<std::size_t> users;                                   ///< indices of user effects
  StepGroup kernel;
  Real* force_sums[3] = {};         ///< staged path with user effects or forces between bodies
  Real* torque_sums[3] = {};        ///< likewise, where a user effect or contact friction turns the bodies
  std::vector<Real*> rates;         ///< staged path, and rates kept between steps: what kernel.rates points to
  std::vector<Real*> rate_columns;  ///< where they are in memory: sets as at the start, see World::arrange_rates
  std::vector<Real*> carry;         ///< compensated summation: what kernel.carry points to
  std::vector<Real*> carry_before;  ///< adaptive: as it was when the step began
  Presence presence;

  /// What adds to the mass of a row's body [kg].
  double added_mass(std::size_t row) const;
  bool answers_to_loads() const;  ///< does one of its effects?
  bool turns() const { return carried >= MotionKind::oriented; }
  bool spins() const { return carried != MotionKind::point; }
  bool pivots() const { return carried == MotionKind::pivoted; }
  std::size_t instance_count(std::size_t e) const { return effects[e].size() / local_effects()[e].constants_size; }
  /// After a change of effects: tells the kernels.
  void list_instances();
};

struct Block {
  std::size_t group = 0, first = 0, last = 0;  ///< rows of the group
};

/// Bodies that no others act on: some whole copies of the scene.
struct Part {
  CopyRange copies;
  bool alone = false;  ///< on one thread: passes of few bodies gain nothing from another one
  std::vector<Block> blocks;
  std::vector<Moved> moved;  ///< of each block

  void add(std::size_t group, std::size_t first, std::size_t last);  ///< rows, as blocks
};

/// Time as a sum of steps, with what rounding takes from it (Knuth's two-sum).
struct Elapsed {
  double time = 0, rest = 0;
  double until(double t) const { return (t - time) - rest; }
  /// By h, to `exactly` that time if it is given.
  void advance(double h, std::optional<double> exactly) {
    const double add = h + rest, sum = time + add, part = sum - time;
    rest = exactly ? 0 : (time - (sum - part)) + (add - part);
    time = exactly.value_or(sum);
  }
};

/// What happens at a time. A step that holds it is split there.
struct Event {
  double at = 0;                   ///< [s]
  std::optional<Impulse> impulse;  ///< none: only the split (an effect begins or ends)
};

}  // namespace ballpark::BALLPARK_PRECISION
