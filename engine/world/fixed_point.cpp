#include "engine/world/fixed_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/world/build.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// Changes smaller than this may be rounding of the forces themselves. They are if they no longer shrink.
constexpr Real nearly = 1024 * std::numeric_limits<Real>::epsilon();
/// Position and velocity change in turns: not every iteration has smaller changes than the one before.
constexpr int patience = 3;
/// By then `most_left` has become less than rounding, in any precision.
constexpr int most_iterations = 250;

/// Puts the later rates of a body in the place of those before. Gives the largest change of its stages by that, over
/// the size of their terms: distances and velocities times the step together, turns likewise.
Real take_rates(const Group& group, const MotionCalls& calls, std::size_t row, const Method& method) {
  const int stages = method.phases / 2, turns_begin = group.pivots() ? 0 : 6;
  Real y[max_state_size], unit[max_state_size];
  calls.load(group.kernel, row, y);
  calls.units(group.kernel, row, method.step, unit);
  Real change[2] = {}, size[2] = {0, 1};  // of the place and its rate; of turns, whose size is that of an angle
  bool finite = true;
  for (int p = 0; p < calls.size; ++p) {
    Real later[max_stages], by[max_stages];
    for (int j = 0; j < stages; ++j) {
      Real& rate = group.kernel.rates[j * calls.size + p][row];
      later[j] = group.kernel.rates[(stages + j) * calls.size + p][row];
      by[j] = later[j] - rate;
      rate = later[j];
    }
    const bool turns = p >= turns_begin;
    for (int i = 0; i < stages; ++i) {
      const Real* a = method.a[stages + i];
      Real moved = 0, terms = std::abs(y[p]);
      for (int j = 0; j < stages; ++j) moved += a[j] * by[j], terms += std::abs(a[j] * later[j]);
      finite = finite && std::isfinite(moved);
      moved = std::abs(moved);
      change[turns] = std::max(change[turns], moved / unit[p]);
      size[turns] = std::max(size[turns], (terms + moved) / unit[p]);
    }
  }
  if (!finite) return std::numeric_limits<Real>::infinity();
  return std::max(change[0] > 0 ? change[0] / size[0] : 0, change[1] / size[1]);
}

}  // namespace

Method FixedPoint::phases_of(const Method& implicit) {
  Method m = implicit;
  const int stages = implicit.phases;
  m.family = Family::explicit_runge_kutta;
  m.phases = 2 * stages;
  for (int i = 0; i < stages; ++i) {
    m.offset[stages + i] = implicit.offset[i];
    for (int j = 0; j < stages; ++j) {
      m.a[stages + i][j] = implicit.a[i][j];
      m.a[i][j] = 0;
    }
  }
  return m;
}

FixedPoint::FixedPoint(const std::vector<Group>& groups, std::size_t copies, bool coupled) : coupled_(coupled) {
  const std::size_t rows = groups.empty() ? 0 : groups.back().first_row + groups.back().live;
  changes_.resize(rows);
  units_.resize(coupled ? copies : rows);
}

std::size_t FixedPoint::unit_of(const Group& group, std::size_t row) const {
  return coupled_ ? group.copies.copy_of(row) : group.first_row + row;
}

template <class Act>
void FixedPoint::for_rows(const std::vector<Group>& groups, const Part& part, Act act) {
  for (const Block& block : part.blocks) {
    const Group& group = groups[block.group];
    for (std::size_t row = block.first; row < block.last; ++row) {
      act(units_[unit_of(group, row)], group.first_row + row);
    }
  }
}

template <class Act>
void FixedPoint::for_units(const std::vector<Group>& groups, const Part& part, Act act) {
  if (!coupled_) return for_rows(groups, part, [&](Unit& unit, std::size_t) { act(unit); });
  for (std::size_t copy = part.copies.first; copy < part.copies.last; ++copy) act(units_[copy]);
}

void FixedPoint::begin(const std::vector<Group>& groups, const Part& part) {
  for_units(groups, part, [](Unit& unit) { unit = {}; });
}

void FixedPoint::compare(const Group& group, const Block& block, const Method& method) {
  const MotionCalls& calls = calls_of(group.motion);
  for (std::size_t row = block.first; row < block.last; ++row) {
    if (units_[unit_of(group, row)].done) continue;
    changes_[group.first_row + row] = take_rates(group, calls, row, method);
  }
}

bool FixedPoint::judge(const std::vector<Group>& groups, const Part& part) {
  const FlushDenormals flush;  // as in passes, whoever runs this
  for_units(groups, part, [](Unit& unit) { unit.change = 0; });
  for_rows(groups, part, [&](Unit& unit, std::size_t row) {
    if (changes_[row] > unit.change) unit.change = changes_[row], unit.row = row;
  });
  bool all_done = true;
  for_units(groups, part, [&](Unit& unit) {
    if (!unit.done) judge(unit);
    all_done = all_done && unit.done;
  });
  return all_done;
}

void FixedPoint::judge(Unit& unit) {
  StageResult& result = unit.result;
  result.residual = unit.change;
  ++result.iterations;
  unit.stalled = unit.change < unit.least ? 0 : unit.stalled + 1;
  unit.least = std::min(unit.least, unit.change);
  result.converged = result.residual == 0 || (result.residual < nearly && unit.stalled >= patience);
  unit.done = result.converged || !std::isfinite(result.residual) || result.iterations == most_iterations;
}

StageTally FixedPoint::tally(const std::vector<Group>& groups, ImplicitStep::IdOf id_of) const {
  StageTally all;
  for (const Unit& unit : units_) {
    if (!unit.done) continue;  // padding
    if (unit.result.converged) {
      all.add(unit.result, 0);
      continue;
    }
    const auto holds = [&](const Group& g) { return unit.row >= g.first_row && unit.row < g.first_row + g.live; };
    const Group& group = *std::find_if(groups.begin(), groups.end(), holds);
    all.add(unit.result, id_of(group, unit.row - group.first_row));
  }
  return all;
}

/// With the largest step; infinity if no force tells its stiffness (user effects and attraction do not).
StepLimitReport World::hardest_to_iterate() const {
  StepLimitReport least{"", std::numeric_limits<double>::infinity()};
  const auto consider = [&](const std::string& whose, const Stiffness& per_mass) {
    const double largest = FixedPoint::largest_step(*row_, per_mass) * (impulse_ ? impulse_->substeps : 1);
    if (largest < least.largest) least = {whose, largest};
  };
  for (const auto& [whose, per_mass] : stiffnesses_) consider(whose, per_mass);
  if (penalty_) consider("contacts", watched_stiffness_ + beside_contacts());
  return least;
}

std::string World::how_solved() const {
  if (implicit_) return "Newton's method";
  if (!fixed_point_) return "";
  const auto [whose, largest] = hardest_to_iterate();
  const std::string contraction =
      std::isinf(largest) ? "contraction not known before the run"
                          : fmt::format("contraction {:.2g} ({})", FixedPoint::most_left * step_ / largest, whose);
  return fmt::format("fixed-point iteration: {}; {}", contraction, not_differentiated_);
}

/// A step beyond what can be iterated is refused: Newton's method is not there to help.
void Builder::check_iteration() const {
  if (!world_.fixed_point_) return;
  const double h = world_.step_;
  const auto [whose, largest] = world_.hardest_to_iterate();
  if (h <= largest * (1 + 1e-6)) return;
  throw SceneError(
      "run.step",
      fmt::format("{} takes fixed-point iteration for its stages, as {}, and at {:g} s each iteration multiplies their "
                  "error by {:.3g} (on {}); expected a step of at most {:.4g} s, or another integrator, e.g. rk4",
                  world_.row_->name, world_.not_differentiated_, h, FixedPoint::most_left * h / largest, whose,
                  largest));
}

/// The stages' rates, as phases.
void World::find_stages(const Part& part, const Method& method, double from) {
  const int stages = method.phases / 2;
  for (int phase = 0; phase < stages; ++phase) staged_phase(part, method, phase, from);
  fixed_point_->begin(groups_, part);
  for (bool done = false; !done;) {
    for (int phase = stages; phase < method.phases; ++phase) staged_phase(part, method, phase, from);
    pass(part, "compare_stages",
         [&](const Group& group, const Block& block) { fixed_point_->compare(group, block, method); });
    done = fixed_point_->judge(groups_, part);
  }
}

Moved World::fixed_point_step(const Method& method, double from) {
  const Moved moved = staged_step(method, from);
  StageTally tally =
      fixed_point_->tally(groups_, [this](const Group& group, std::size_t row) { return id_of(group, row); });
  tally.finite = moved.finite;
  count_iterations(tally, method.phases / 2);
  return moved;
}

}  // namespace ballpark::BALLPARK_PRECISION
