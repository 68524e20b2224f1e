// What exists in a world and why, with the bytes and flops of each pass.
#include <algorithm>
#include <cmath>

#include "engine/world/explain_passes.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", value);
  return buffer;
}

GroupReport report(const Group& group, std::size_t index, const std::vector<PairSystem>& pairs,
                   const std::vector<UserEffect>& users, const std::vector<const char*>& between_steps) {
  GroupReport r{group.name, name(group.motion), group.live, group.why, {}, {}};
  if (group.pivots()) r.effects.push_back("pivot");
  for (std::size_t e = 0; e < group.effects.size(); ++e) {
    const std::size_t count = group.instance_count(e);
    const std::string& effect = local_effects()[e].description.name;
    if (count > 0) r.effects.push_back(count == 1 ? effect : effect + " x" + std::to_string(count));
  }
  for (const PairSystem& system : pairs) {
    if (system.acts_on(index)) r.effects.push_back(system.name());
  }
  for (const std::size_t u : group.users) r.effects.push_back(users[u].name);
  r.effects.insert(r.effects.end(), between_steps.begin(), between_steps.end());
  const auto unit = [](const std::string& key) {
    return key == "radius" ? " m" : key == "density" ? " kg/m^3" : " kg";
  };
  for (const auto& [key, value] : group.constants) r.constants.push_back(key + " = " + text(value) + unit(key));
  return r;
}

std::vector<std::string> what_is_off(const std::vector<Group>& groups, const std::vector<PairSystem>& pairs, bool fused,
                                     bool contacts) {
  std::vector<std::string> off;
  const auto none = [&](auto has) { return std::none_of(groups.begin(), groups.end(), has); };
  if (none([](const Group& g) { return g.turns(); })) off.push_back("orientation");
  if (none([](const Group& g) { return g.motion != MotionKind::point; })) off.push_back("torque");
  if (none([](const Group& g) { return g.spins(); })) off.push_back("angular momentum");
  if (fused) off.push_back("rate columns and passes for each stage");
  if (none([](const Group& g) { return g.force_sums[0] != nullptr; })) off.push_back("force sums");
  const bool searches =
      contacts || std::any_of(pairs.begin(), pairs.end(), [](const auto& p) { return p.effect->searches(); });
  for (const char* part : {"grid", "pairs"}) {
    if (!searches) off.push_back(part);
  }
  if (!contacts) off.push_back("contacts");
  for (std::size_t e = 0; e < LocalEffects::count; ++e) {
    if (none([e](const Group& g) { return !g.effects[e].empty(); })) {
      off.push_back(local_effects()[e].description.name);
    }
  }
  if (none([](const Group& g) { return g.pivots(); })) off.push_back("pivot");
  for (const PairEffectInfo& info : pair_effects()) {
    const auto is = [&](const PairSystem& system) { return system.info == &info; };
    if (std::none_of(pairs.begin(), pairs.end(), is)) off.push_back(info.description.name);
  }
  return off;
}

/// Staged passes of all groups in the order of the step; effects between bodies lie between the others.
void put_in_order(std::vector<PassReport>& passes) {
  static const std::vector<std::string> before{"keep_neighbours", "prepare", "user_effects"};
  static const std::vector<std::string> after{"press_contacts", "evaluate", "compare_stages", "finish",
                                              "finish_contacts"};
  const auto rank = [](const PassReport& pass) {
    const auto early = std::find(before.begin(), before.end(), pass.name);
    if (early != before.end()) return early - before.begin() - static_cast<std::ptrdiff_t>(before.size());
    const auto late = std::find(after.begin(), after.end(), pass.name);
    return late == after.end() ? 0 : late - after.begin() + 1;
  };
  std::stable_sort(passes.begin(), passes.end(),
                   [&](const PassReport& a, const PassReport& b) { return rank(a) < rank(b); });
}

}  // namespace

Explanation World::explain() const {
  Explanation all;
  all.path = implicit_ ? "implicit" : fused_ ? "fused" : "staged";
  all.path_reason = path_reason_;
  all.integrator = row_->name;
  all.stages = how_solved();
  all.precision = precision() == Precision::single_   ? "single"
                  : precision() == Precision::double_ ? "double"
                                                      : "extended";
  all.target = target();
  const auto has_rule = [this](const Group& group) {
    const bool own_axes = group.carried == MotionKind::body_frame;
    return group.motion != MotionKind::point && group.turns() && (rotation_ != RotationRule::body || own_axes);
  };
  if (std::any_of(groups_.begin(), groups_.end(), has_rule)) all.rotation = name(rotation_);
  all.threads = threads();
  all.block_length = block_length;
  all.narrowed = narrowed_;
  all.column_bytes = columns_.bytes();
  const StepPlan plan{implicit_ ? StepPath::implicit
                      : fused_  ? StepPath::fused
                                : StepPath::staged,
                      fixed_point_ != nullptr, method_.phases - keeps_rates_, path_reason_};
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    if (group.live == 0) continue;
    std::vector<const char*> between;
    for (const BetweenSteps& effect : between_steps_) {
      if (effect.acts_on(g)) between.push_back(effect.name());
    }
    all.groups.push_back(report(group, g, pair_systems_, users_, between));
    explain_passes(group, method_, plan, columns_, all.passes);
  }
  for (const PairSystem& system : pair_systems_) {
    if (!implicit_) system.explain(groups_, method_.phases - keeps_rates_, all);
  }
  if (penalty_) penalty_->explain(groups_, all);
  if (!fused_) put_in_order(all.passes);
  if (impulse_) impulse_->explain(groups_, all);
  explain_between_steps(all.passes);
  for (const auto& [name, per_mass] : stiffnesses_) {
    const double largest = limit_of(per_mass).largest;
    if (std::isfinite(largest)) all.step_limits.push_back({name, largest});
  }
  if (penalty_) {
    all.contact.largest_step = limit_of(watched_stiffness_ + beside_contacts()).largest;
  }
  for (const Column& column : columns_.all()) {
    const ColumnInfo& info = column.info;
    for (const Group& group : groups_) {
      if (!column.covers(group.first_row) || group.live == 0) continue;
      all.columns.push_back({info.name, info.unit, name(info.role), group.name, info.components,
                             static_cast<double>(info.components) * static_cast<double>(sizeof(Real)), info.why});
    }
  }
  for (const PassReport& pass : all.passes) {
    for (const GroupReport& group : all.groups) {
      if (group.name != pass.group) continue;
      const double share = static_cast<double>(group.bodies) / static_cast<double>(body_count()) * pass.calls_per_step;
      all.bytes_per_body_step += share * pass.bytes_per_body;
      all.flops_per_body_step += share * pass.flops_per_body;
    }
  }
  all.off = what_is_off(groups_, pair_systems_, fused_, contacts_ != nullptr);
  for (const StepEffectInfo& info : step_effects()) {
    const auto is = [&](const BetweenSteps& between) { return between.info == &info; };
    if (std::none_of(between_steps_.begin(), between_steps_.end(), is)) all.off.push_back(info.description.name);
  }
  return all;
}

void World::profile(bool on) {
  profiling_ = on;
  if (!on) return;
  pass_times_.clear();
  bytes_per_call_.clear();
  const Explanation all = explain();
  for (const PassReport& pass : all.passes) {
    const auto known = std::find_if(pass_times_.begin(), pass_times_.end(),
                                    [&](const PassTime& entry) { return entry.name == pass.name; });
    const auto index = static_cast<std::size_t>(known - pass_times_.begin());
    if (known == pass_times_.end()) {
      pass_times_.push_back({pass.name});
      bytes_per_call_.push_back(0);
    }
    for (const GroupReport& group : all.groups) {
      if (group.name == pass.group) bytes_per_call_[index] += pass.bytes_per_body * static_cast<double>(group.bodies);
    }
  }
}

Precision World::precision() const {
  return std::is_same_v<Real, float>    ? Precision::single_
         : std::is_same_v<Real, double> ? Precision::double_
                                        : Precision::extended;
}

}  // namespace ballpark::BALLPARK_PRECISION
