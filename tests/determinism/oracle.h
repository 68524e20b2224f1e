// The scalar oracle: the kernels' own templates on plain Real, beside the tables of all targets, bit by bit. Included
// once for each precision.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "engine/core/flush_denormals.h"
#include "engine/integrators/rows.h"
#include "engine/world/local_step.h"
#include "engine/world/world.h"
#include "tests/catch.h"
#include "tests/determinism/scenarios.h"

namespace ballpark::BALLPARK_PRECISION {

namespace oracle {

inline constexpr std::size_t rows = 96;  // three of the widest vectors
inline constexpr int most_values = max_state_size;

/// Random numbers of every kind that a column can hold: mostly of size 1, some tiny, huge, zero or denormal.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  Real plain() { return static_cast<Real>(static_cast<double>(engine_()) / 2147483648.0 - 1); }
  Real any() {
    using Limits = std::numeric_limits<Real>;
    switch (engine_() % 16) {
      case 0:
        return plain() * Limits::min();  // denormal
      case 1:
        return std::bit_cast<Real>(static_cast<Word>(engine_() % 9));  // the smallest of all, and zero
      case 2:
        return -Real(0);
      case 3:
        return plain() * std::sqrt(Limits::min());
      case 4:
        return plain() * std::sqrt(std::sqrt(Limits::max()));
      default:
        return plain();
    }
  }
  Real positive() { return Real(0.25) + std::abs(plain()); }
  std::vector<Real> column(Real (Numbers::*draw)()) {
    std::vector<Real> values(rows);
    for (Real& value : values) value = (this->*draw)();
    return values;
  }
  using Word = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

 private:
  std::mt19937 engine_;
};

/// A group's columns, random, with every local effect on it. Not to be copied: kernels hold pointers into it.
class RandomGroup {
 public:
  RandomGroup(unsigned seed, bool compensated) : numbers_(seed) {
    make(kernel.state.position, &Numbers::any);
    make(kernel.state.velocity, &Numbers::any);
    make(kernel.state.momentum, &Numbers::any);
    make(kernel.state.orientation, &Numbers::plain);
    make(kernel.trial.position, &Numbers::plain);
    make(kernel.trial.velocity, &Numbers::plain);
    make(kernel.trial.momentum, &Numbers::plain);
    make(kernel.trial.orientation, &Numbers::plain);
    make(kernel.trial.turn, &Numbers::plain);
    make(kernel.trial_spin, &Numbers::plain);
    make(kernel.constants.orientation, &Numbers::plain);
    make(carry_, &Numbers::any);
    make(rates_, &Numbers::plain);
    for (PerBody& inverse : kernel.constants.inverse_inertia) inverse.rows = add(&Numbers::plain);
    for (PerBody& arm : kernel.constants.arm) arm.rows = add(&Numbers::plain);
    for (PerBody& pivot : kernel.constants.pivot) pivot.value = numbers_.plain();
    for (PerBody& axis : kernel.constants.principal) axis.rows = add(&Numbers::plain);
    kernel.constants.mass.rows = add(&Numbers::positive);
    kernel.constants.effective_mass.rows = add(&Numbers::positive);
    kernel.rates = rates_;
    if (compensated) kernel.carry = carry_;
    add_effects(LocalEffects{});
    if (seed % 2 == 0) add_flows(4);  // wind and gusts come last
  }
  RandomGroup(const RandomGroup&) = delete;
  RandomGroup& operator=(const RandomGroup&) = delete;

  /// As build sets it for a method.
  void turn_apart(bool apart) { kernel.forces.turning_apart = apart; }

  StepGroup kernel;
  const std::deque<std::vector<Real>>& columns() const { return columns_; }

 private:
  Real* add(Real (Numbers::*draw)()) { return columns_.emplace_back(numbers_.column(draw)).data(); }
  template <std::size_t n>
  void make(Real* (&pointers)[n], Real (Numbers::*draw)()) {
    for (Real*& pointer : pointers) pointer = add(draw);
  }

  template <class... E>
  void add_effects(EffectList<E...>) {
    int effect = 0;
    (add_instances<E>(effect++), ...);
    kernel.forces.begin = instances_.data();
    kernel.forces.end = instances_.data() + instances_.size();
  }

  /// What flows is in the list too, where it pushes nothing.
  void add_flows(std::size_t count) {
    kernel.forces.flow_end = instances_.data() + instances_.size();
    kernel.forces.flow_begin = kernel.forces.flow_end - count;
    kernel.forces.start = 0.37;
  }
  /// Two instances: one for all rows, one for a single row where the effect can choose; anchors for each body.
  template <class E>
  void add_instances(int effect) {
    using Constants = typename E::Constants;
    auto& made = storage_.emplace_back(2 * sizeof(Constants));
    for (int i = 0; i < 2; ++i) {
      Constants c = random_constants<Constants>();
      if constexpr (requires { c.rows; }) c.rows.row = i == 0 ? -1 : 21;
      if constexpr (requires { c.centrifugal; }) c.centrifugal = i == 0;
      if constexpr (requires { c.radius; }) c.radius.rows = add(&Numbers::positive);
      if constexpr (requires { c.inverse_inertia; }) c.inverse_inertia.rows = add(&Numbers::positive);
      if constexpr (requires { c.anchor; }) {
        for (PerBody& anchor : c.anchor) anchor.rows = add(&Numbers::plain);
        c.rest_length = i == 0 ? Real(0) : Real(0.5);
      }
      std::byte* at = made.data() + static_cast<std::size_t>(i) * sizeof(Constants);
      std::memcpy(at, &c, sizeof c);
      instances_.push_back({effect, at});
    }
  }
  template <class Constants>
  Constants random_constants() {
    Constants c{};
    if constexpr (requires { c.acceleration; }) c.acceleration = vector();
    if constexpr (requires { c.reynolds; }) c.reynolds = 100 * numbers_.positive(), c.stokes = numbers_.positive();
    if constexpr (requires { c.lift; }) c.lift = vector();
    if constexpr (requires { c.shear; }) c.velocity = vector(), c.shear = vector(), c.height = numbers_.plain();
    if constexpr (requires { c.waves; }) {
      for (auto& w : c.waves) {
        w = {vector(), vector(), static_cast<double>(numbers_.plain()), static_cast<double>(numbers_.plain())};
      }
    }
    if constexpr (requires { c.coefficient; }) c.coefficient = numbers_.positive();
    if constexpr (requires { c.anchor; }) c.stiffness = numbers_.positive();
    if constexpr (requires { c.stiffness.x; }) c.stiffness = vector();
    if constexpr (requires { c.damping; }) c.damping = numbers_.positive();
    if constexpr (requires { c.centre; }) c.centre = vector();
    if constexpr (requires { c.strength; }) c.strength = numbers_.positive();
    if constexpr (requires { c.force; }) c.force = vector();
    if constexpr (requires { c.torque; }) c.torque = vector();
    if constexpr (requires { c.field; }) c.field = vector();
    if constexpr (requires { c.rate.x; }) c.rate = vector(), c.point = vector();
    if constexpr (requires { c.sliding; }) {
      c.normal = vector(), c.turning = vector();
      for (Real* number : {&c.sliding, &c.rolling, &c.spinning, &c.rate}) *number = numbers_.positive();
    }
    return c;
  }
  Vector3<Real> vector() { return {numbers_.plain(), numbers_.plain(), numbers_.plain()}; }

  Numbers numbers_;
  std::deque<std::vector<Real>> columns_;
  std::deque<std::vector<std::byte>> storage_;
  std::vector<EffectInstance> instances_;
  Real* carry_[most_values] = {};
  Real* rates_[max_phases * most_values] = {};
};

/// Which bits differ first, as "column 3, row 17", or "" if none. NaN equals NaN.
inline std::string difference(const RandomGroup& a, const RandomGroup& b) {
  for (std::size_t c = 0; c < a.columns().size(); ++c) {
    for (std::size_t row = 0; row < rows; ++row) {
      const Real x = a.columns()[c][row], y = b.columns()[c][row];
      if (std::isnan(x) && std::isnan(y)) continue;
      if (std::memcmp(&x, &y, sizeof x) == 0) continue;
      return "column " + std::to_string(c) + ", row " + std::to_string(row);
    }
  }
  return "";
}

/// A step of all rows on the path; returns what the kernel tells.
inline Moved step(const KernelTable& table, const Method& method, int motion, bool fused, const StepGroup& group) {
  const FamilyKernels& kernels = table.family(method.family, group.carry != nullptr);
  if (fused) return kernels.fused[motion](group, method, 0, rows);
  for (int phase = 0; phase < method.phases; ++phase) {
    kernels.prepare[motion](group, method, phase, 0, rows);
    table.evaluate[motion](group, method, phase, 0, rows);
  }
  return kernels.finish[motion](group, method, 0, rows);
}

template <int>
using Scalar = Real;

/// One random group, moved by the oracle and by the target's kernels. A chained method's oracle keeps every stage.
inline void compare(const KernelTable& kernels, const Row& row, const Method& method, int motion, bool compensated,
                    unsigned seed) {
  static constexpr KernelTable scalar = table_of_all_motions<Scalar>("scalar");
  Method plain = method;
  plain.family = row.family;
  for (const bool fused : {true, false}) {
    CAPTURE(kernels.target, row.name, method.errors, motion, compensated, seed, fused);
    RandomGroup one(seed, compensated), other(seed, compensated);
    const RandomGroup before(seed, compensated);
    one.turn_apart(row.turns_velocity);
    other.turn_apart(row.turns_velocity);
    REQUIRE(difference(one, other).empty());
    const Moved expected = step(scalar, plain, motion, fused, one.kernel);
    const Moved moved = step(kernels, method, motion, fused, other.kernel);
    CHECK(moved.finite == expected.finite);
    CHECK(difference(one, other) == "");
    CHECK(difference(one, before) != "");
    if (!expected.finite) continue;
    CHECK(moved.over == expected.over);
    CHECK((expected.over > 0) == (method.errors > 0));
  }
}

inline void compare_everything() {
  for (const std::string& target : scenarios::available_targets()) {
    const KernelTable* kernels = kernel_table(target);
    REQUIRE(kernels != nullptr);
    for (const Row& row : BALLPARK_PRECISION::rows()) {
      if (row.family == Family::implicit_runge_kutta) continue;  // has no kernels
      for (int motion = 0; motion < motion_count; ++motion) {
        if (!kernels->family(method_for(row, 1).family, false).fused[motion]) continue;
        for (unsigned seed = 1; seed <= 8; ++seed) {
          const bool compensates = kernels->family(row.family, true).fused[motion] != nullptr;
          compare(*kernels, row, method_for(row, 0.01), motion, compensates && seed % 2 == 0, seed);
        }
        if (row.family == Family::splitting) {
          for (const RotationRule rule : {RotationRule::exponential, RotationRule::splitting}) {
            compare(*kernels, row, method_for(row, 0.01, rule), motion, false, 9);
          }
        }
        if (!row.embeds()) continue;
        Method pair = pair_for(row, 1e-6, 1e-6);
        scale(pair_for(row, 1e-6, 1e-6), 0.01, pair);
        for (unsigned seed = 1; seed <= 4; ++seed) compare(*kernels, row, pair, motion, false, seed);
      }
    }
  }
}

}  // namespace oracle

}  // namespace ballpark::BALLPARK_PRECISION
