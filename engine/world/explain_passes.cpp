// What the passes of smooth motion read, write and cost.
#include <algorithm>
#include <cmath>

#include "engine/world/explain_passes.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// Values of state that a step reads and writes, and the arithmetic of body() and rates(), for one body.
struct MotionCost {
  int reads, writes, flops;
};

/// An exponential takes 80 flops and the rate of its vector 90, in place of a quaternion's rate (28).
MotionCost cost(MotionKind kind) {
  constexpr int by_exponential = 142;
  switch (kind) {
    case MotionKind::point:
      return {6, 6, 3};
    case MotionKind::spinning:
      return {9, 9, 6};
    case MotionKind::oriented:
      return {13, 13, 32};
    case MotionKind::rigid:
      return {13, 13, 86};
    case MotionKind::pivoted:
      return {7, 13, 190};  // position and velocity follow, and are written
    case MotionKind::body_frame:
      return {13, 13, 98};
    case MotionKind::oriented_exponential:
      return {13, 13, 32 + by_exponential};
    case MotionKind::rigid_exponential:
      return {13, 13, 86 + by_exponential};
    case MotionKind::pivoted_exponential:
      return {7, 13, 190 + by_exponential};
  }
  return {};
}

std::vector<std::string> state_names(MotionKind kind) {
  return with_motion(kind, [&]<class M>() {
    std::vector<std::string> names;
    if (M::position_end > 0) names = {"position", "velocity"};
    if (M::turns && M::position_end == 0) names.push_back("orientation");
    if (M::spins) names.push_back(kind == MotionKind::body_frame ? body_momentum : "angular_momentum");
    if (M::turns && M::position_end > 0) names.push_back("orientation");
    return names;
  });
}

std::vector<std::string> with_prefix(const char* prefix, std::vector<std::string> names) {
  for (std::string& name : names) name = prefix + name;
  return names;
}

/// Coefficients that are not zero: terms of the sums that a method forms.
struct Terms {
  int stages = 0;  ///< over all phases
  int weights = 0;
};

Terms terms(const Method& m) {
  Terms t;
  for (int i = 0; i < m.phases; ++i) {
    for (int j = 0; j < m.phases; ++j) t.stages += m.a[i][j] != 0;
    t.weights += m.b[i] != 0;
    if (m.family == Family::splitting) t.weights += (m.kick[i] != 0) + (m.drift[i] != 0);
  }
  if (m.family == Family::taylor) t.weights = 2;
  if (m.family == Family::multistep) t.weights = m.history + 1 + (m.phases > 1 ? m.history + 1 : 0);
  for (int e = 0; e < m.errors; ++e) {
    for (int p = 0; p < m.phases; ++p) t.weights += m.error[e][p] != 0;
  }
  return t;
}

/// Builds the pass list of one group.
struct PassWriter {
  const Group& group;
  const Method& method;
  int calls;  ///< phases that are evaluated in a step
  const Columns& columns;
  const std::string& reason;
  std::vector<PassReport>& passes;
  double real = static_cast<double>(sizeof(Real));
  MotionCost motion = cost(group.motion);
  int size = state_size(group.motion);
  Terms count = terms(method);

  double effect_flops() const {
    double sum = 0;
    for (std::size_t e = 0; e < group.effects.size(); ++e) {
      sum += local_effects()[e].description.flops * static_cast<double>(group.instance_count(e));
    }
    return sum;
  }
  /// Added mass needs it at build only.
  bool pushed_by_radius() const {
    return std::any_of(group.instances.begin(), group.instances.end(), [](const EffectInstance& instance) {
      return local_effects()[static_cast<std::size_t>(instance.effect)].reads("radius");
    });
  }
  /// Constant columns that a pass reads, by name, and their values for one body.
  std::vector<std::string> constant_names(int& values) const {
    std::vector<std::string> names;
    values = 0;
    for (const Column& column : columns.all()) {
      if (column.info.role != Role::constant || !column.covers(group.first_row)) continue;
      if (column.info.name == "inverse_inertia" && group.motion == MotionKind::point) continue;
      if (column.info.name == "radius" && !pushed_by_radius()) continue;
      names.push_back(column.info.name);
      values += column.info.components;
    }
    return names;
  }
  void add(const char* name, std::vector<std::string> reads, std::vector<std::string> writes, double values,
           double flops, int times, const std::string& why) {
    int constants = 0;
    for (const std::string& column : constant_names(constants)) reads.push_back(column);
    passes.push_back(
        {name, group.name, std::move(reads), std::move(writes), (values + constants) * real, flops, times, why});
  }

  std::vector<std::string> written() const {
    return group.pivots() ? std::vector<std::string>{"position", "velocity", "orientation", "angular_momentum"}
                          : state_names(group.motion);
  }

  /// Compensated summation reads and writes a carry for each value of the state.
  double carried() const { return group.kernel.carry ? size : 0; }
  std::vector<std::string> with_carry(std::vector<std::string> names) const {
    if (group.kernel.carry) names.push_back("carry");
    return names;
  }

  /// Of 3 coordinates in each stage: chained methods leave out trial positions that no effect reads.
  double left_out() const {
    const bool chained = method.family == Family::chained_runge_kutta && !group.pivots();
    return chained && !group.kernel.forces.read_position ? 2.0 * 3 * count.stages : 0;
  }

  bool estimates() const { return method.errors > 0; }
  /// What a step leaves to the next one, and where it began.
  std::vector<std::string> with_kept(std::vector<std::string> names) const {
    if (method.history > 0 || estimates()) names.push_back("rates");
    return names;
  }
  std::vector<std::string> with_before(std::vector<std::string> names) const {
    if (!estimates()) return names;
    for (const std::string& name : written()) names.push_back(name + "_before");
    return names;
  }
  double before() const { return estimates() ? motion.writes : 0; }

  void fused() {
    const double flops =
        calls * (motion.flops + effect_flops()) + 2.0 * size * (count.stages + count.weights) + size - left_out();
    const double kept = size * (method.history > 0 ? method.history + 1 : estimates() ? 2 : 0);
    add("fused_step", with_kept(with_carry(state_names(group.motion))), with_before(with_kept(with_carry(written()))),
        motion.reads + motion.writes + 2 * carried() + kept + before(), flops, 1, reason);
  }

  /// Arithmetic of one iteration, which most steps take two or three of: rates on duals, each of whose products is 3
  /// for each variable; and the factors of a dense matrix (bodies that are solved together have larger ones).
  void implicit() {
    const double unknowns = size * method.phases;
    const double rates = method.phases * (motion.flops + effect_flops()) * (1 + 3.0 * size);
    add("implicit_step", with_carry(state_names(group.motion)), with_carry(written()),
        motion.reads + motion.writes + 2 * carried(), rates + unknowns * unknowns * (2 * unknowns / 3 + 2), 1, reason);
  }

  /// Of an implicit method: one iteration, which reads both halves of the rates and writes the first.
  void compared() {
    auto reads = state_names(group.motion);
    reads.push_back("rates");
    const double rates = size * method.phases;
    add("compare_stages", reads, {"rates"}, motion.reads + 1.5 * rates, (2.0 * count.stages + 2) * size, 1,
        "iterated until no stage changes: each time half of the phases, and this");
  }

  void staged() {
    const auto trial = with_prefix("trial_", written());
    std::vector<std::string> sums;
    const double phases = method.phases;
    const bool moves = method.family == Family::splitting;
    const double between = (phases - 1) / phases;  // kicks and drifts between phases
    const double moved = moves ? motion.writes * between + carried() * (1 + between) : 0;
    auto reads = moves ? with_carry(state_names(group.motion)) : state_names(group.motion);
    if (count.stages > 0 || moves) reads.push_back("rates");
    const double stage_terms = moves ? between : count.stages / phases;
    auto prepared = trial;
    if (group.force_sums[0]) sums.push_back("force");
    if (group.torque_sums[0]) sums.push_back("torque");
    prepared.insert(prepared.end(), sums.begin(), sums.end());
    const double summed = 3.0 * static_cast<double>(sums.size());
    add("prepare", reads, prepared, motion.reads + motion.writes + moved + size * stage_terms + summed,
        2 * size * stage_terms, calls, "trial state of each phase");
    if (!group.users.empty()) {
      add("user_effects", trial, sums, motion.writes + summed, 0, calls, "user effects (their flops are not known)");
    }
    auto loads = with_prefix("trial_", state_names(group.motion));
    loads.insert(loads.end(), sums.begin(), sums.end());
    add("evaluate", loads, {"rates"}, motion.reads + size + summed, motion.flops + effect_flops(), calls,
        "rates of each phase");
    auto ends = with_carry(state_names(group.motion));
    ends.push_back("rates");
    add("finish", ends, with_before(with_carry(written())),
        motion.reads + motion.writes + 2 * carried() + size * std::max(count.weights, 1) + before(),
        2.0 * size * count.weights + size, 1, "the state after the step");
  }
};

}  // namespace

void explain_passes(const Group& group, const Method& method, const StepPlan& plan, const Columns& columns,
                    std::vector<PassReport>& passes) {
  PassWriter writer{group, method, plan.calls, columns, plan.reason, passes};
  plan.path == StepPath::implicit ? writer.implicit() : plan.path == StepPath::fused ? writer.fused() : writer.staged();
  if (plan.iterates) writer.compared();
}

}  // namespace ballpark::BALLPARK_PRECISION
