// The second half of building: values into the columns that exist.
#include <algorithm>
#include <cmath>

#include "engine/world/build.h"

namespace ballpark::BALLPARK_PRECISION {

void Builder::fill_constants(Group& group) {
  const BodyGroup& body = scene_.bodies[group.scene_index];
  BodyConstants& k = group.kernel.constants;
  const auto index = [&](std::size_t row) { return group.copies.index_of(row); };
  const auto remember = [&](const char* name, const std::vector<double>& rows, double value) {
    if (!rows.empty() && std::all_of(rows.begin(), rows.end(), [&](double v) { return v == rows[0]; })) {
      group.constants.emplace_back(name, value);
    }
  };
  if (group.copies.per_copy == 0) return;
  PerBody mass[1];
  constant(group, "mass", "kg", mass, "differs between bodies",
           [&](std::size_t row) { return std::array<Wide, 1>{static_cast<Wide>(mass_of(body, index(row)))}; });
  k.mass = k.effective_mass = mass[0];
  if (!k.mass.rows) group.constants.emplace_back("mass", mass_of(body, 0));
  remember("radius", body.radius, row_or(body.radius, 0, 0.0));
  remember("density", body.density, row_or(body.density, 0, 0.0));
  if (!group.spins()) return;
  for (std::size_t i = 0; i < std::max<std::size_t>(body.inertia.size(), 1); ++i)
    group.inertia.push_back(inertia_of(body, i));
  if (body.inertia.empty() && (body.mass.size() > 1 || body.radius.size() > 1 || body.density.size() > 1)) {
    group.inertia.clear();
    for (std::size_t i = 0; i < group.copies.per_copy; ++i) group.inertia.push_back(inertia_of(body, i));
  }
  const auto inertia = [&](std::size_t row) { return wide(row_or(group.inertia, index(row), Vector3d(0, 0, 0))); };
  if (group.pivots()) {
    const Effect& pivot = *pivot_of(scene_, body);
    const auto points = std::get<std::vector<Vector3d>>(complete_parameters(pivot, *find_effect("pivot")).at("point"));
    const auto point = [&](std::size_t row) { return wide(row_or(points, index(row), Vector3d(0, 0, 0))); };
    const auto arm = [&](std::size_t row) {
      const Start start = start_of(scene_, group.scene_index, index(row), scene_.run.seed + group.copies.copy_of(row),
                                   options_.perturb);
      return rotation_of(start.orientation).to_body(start.position - point(row));
    };
    const auto array = [](const Vector3<Wide>& a) { return std::array<Wide, 3>{a.x, a.y, a.z}; };
    constant(group, "pivot", "m", k.pivot, "pivot", [&](std::size_t row) { return array(point(row)); });
    constant(group, "arm", "m", k.arm, "pivot", [&](std::size_t row) { return array(arm(row)); });
    constant(group, "inverse_inertia", "1/(kg m^2)", k.inverse_inertia, "rotation about the pivot",
             [&](std::size_t row) {
               return inverse_about_pivot(inertia(row), static_cast<Wide>(mass_of(body, index(row))), arm(row));
             });
    if (world_.rotation_ != RotationRule::splitting) return;
    constant(group, "principal_axes", "1, 1/(kg m^2)", k.principal, "rotation by splitting", [&](std::size_t row) {
      return principal_axes(inverse_about_pivot(inertia(row), static_cast<Wide>(mass_of(body, index(row))), arm(row)));
    });
    return;
  }
  PerBody inverse[3];
  constant(group, "inverse_inertia", "1/(kg m^2)", inverse, "rotation", [&](std::size_t row) {
    const Vector3<Wide> i = inertia(row);
    return std::array<Wide, 3>{1 / i.x, 1 / i.y, 1 / i.z};
  });
  std::copy(inverse, inverse + 3, k.inverse_inertia);
}

void Builder::fill_state(Group& group) {
  const std::size_t blocks = (group.live + block_length - 1) / block_length;
  world_.workers_.for_each(blocks, [&](std::size_t b) {
    const std::size_t end = std::min((b + 1) * block_length, group.live);
    for (std::size_t row = b * block_length; row < end; ++row) {
      fill_row(group, row,
               start_of(scene_, group.scene_index, group.copies.index_of(row),
                        scene_.run.seed + group.copies.copy_of(row), options_.perturb));
    }
  });
  repeat_last_row(group);
}

void Builder::fill_row(Group& group, std::size_t row, const Start& start) {
  const StateColumns& state = group.kernel.state;
  const auto put3 = [&](Real* const(&columns)[3], const Vector3<Wide>& a) {
    const Wide values[3] = {a.x, a.y, a.z};
    for (int c = 0; c < 3; ++c) columns[c][row] = static_cast<Real>(values[c]);
  };
  put3(state.position, start.position);
  put3(state.velocity, start.velocity);
  if (group.turns()) {
    const double q[4] = {start.orientation.w, start.orientation.x, start.orientation.y, start.orientation.z};
    for (int c = 0; c < 4; ++c) state.orientation[c][row] = static_cast<Real>(q[c]);
  }
  if (!group.spins()) return;
  Vector3<Wide> spin = start.angular_velocity;
  if (group.pivots() && dot(spin, spin) == 0) {  // given by a velocity instead: w = r x v / r^2
    const BodyConstants& k = group.kernel.constants;
    const Vector3<Real> pivot = vector_at<Real>(k.pivot, row);
    const Vector3<Wide> r = start.position - Vector3<Wide>{pivot.x, pivot.y, pivot.z};
    spin = (1 / dot(r, r)) * cross(r, start.velocity);
  }
  put3(state.momentum, momentum_for(group, row, start.orientation, spin));
  if (group.pivots()) place_pivoted(group, row);
}

/// Padding rows move as the last body does, so that they never turn into something slow or not finite before it.
void Builder::repeat_last_row(Group& group) {
  if (group.live == 0) return;
  for (Column& column : world_.columns_.all()) {
    if (column.info.role != Role::state || !column.covers(group.first_row)) continue;
    for (int c = 0; c < column.info.components; ++c) {
      Real* values = column.at(c, group.first_row);
      std::fill(values + group.live, values + padded(group.live), values[group.live - 1]);
    }
  }
}

/// Compensated summation: a carry for each value that the motion integrates.
void Builder::add_carry(Group& group) {
  const int size = state_size(group.carried);
  Column& column = world_.columns_.add({"carry", "state", size, Role::state, "compensated summation"}, group.first_row,
                                       padded(group.live));
  for (int i = 0; i < size; ++i) group.carry.push_back(column.at(i, group.first_row));
  group.kernel.carry = group.carry.data();
}

/// Sets of rates: of all phases on the staged path, and those kept between steps.
void Builder::add_rates(Group& group) {
  const Method& method = world_.adaptive_ ? world_.unit_ : world_.method_;
  const bool multistep = method.history > 0, keeps = multistep || world_.keeps_rates_;
  if (world_.fused_ && !keeps && !world_.adaptive_) return;
  const int size = state_size(group.carried);
  std::vector<bool> used(static_cast<std::size_t>(std::max(method.phases, method.history_begin + method.history)),
                         true);
  if (world_.fused_ && !multistep) {  // phases are in registers, but for those that two steps share
    used.assign(static_cast<std::size_t>(method.last_set) + 1, true);
  }
  const auto sets = static_cast<int>(std::count(used.begin(), used.end(), true));
  const char* why =
      keeps ? "rates of phases and of earlier steps" : "staged path: one set for each phase of the integrator";
  Column& column = world_.columns_.add({"rates", "state/s", sets * size, keeps ? Role::kept : Role::rate, why},
                                       group.first_row, padded(group.live));
  int next = 0;
  for (const bool in_memory : used) {
    for (int i = 0; i < size; ++i) group.rates.push_back(in_memory ? column.at(next++, group.first_row) : nullptr);
  }
  group.rate_columns = group.rates;
  group.kernel.rates = group.rates.data();
}

/// Embedded pairs: where a step began, to return to.
void Builder::add_before(Group& group) {
  const auto add = [&](const char* name, const char* unit, auto& pointers) {
    Column& column = world_.columns_.add(
        {name, unit, static_cast<int>(std::size(pointers)), Role::rate, "run.tolerance: a step may be rejected"},
        group.first_row, padded(group.live));
    for (int c = 0; c < column.info.components; ++c) pointers[c] = column.at(c, group.first_row);
  };
  StateColumns& before = group.kernel.before;
  add("position_before", "m", before.position);
  add("velocity_before", "m/s", before.velocity);
  if (group.spins()) add("angular_momentum_before", "kg m^2/s", before.momentum);
  if (group.turns()) add("orientation_before", "1", before.orientation);
  if (group.carry.empty()) return;
  group.carry_before.resize(group.carry.size());
  add("carry_before", "state", group.carry_before);
}

/// Staged path: trial state, rates of each phase and, for user effects, spin and sums.
void Builder::add_scratch(Group& group) {
  const std::size_t rows = padded(group.live), first = group.first_row;
  Columns& columns = world_.columns_;
  const auto add = [&](const char* name, const char* unit, Role role, auto& pointers, const char* why) {
    Column& column = columns.add({name, unit, static_cast<int>(std::size(pointers)), role, why}, first, rows);
    for (int c = 0; c < column.info.components; ++c) pointers[static_cast<std::size_t>(c)] = column.at(c, first);
  };
  StepGroup& k = group.kernel;
  add("trial_position", "m", Role::rate, k.trial.position, "staged path");
  add("trial_velocity", "m/s", Role::rate, k.trial.velocity, "staged path");
  if (group.spins()) add("trial_angular_momentum", "kg m^2/s", Role::rate, k.trial.momentum, "staged path");
  if (group.turns()) add("trial_orientation", "1", Role::rate, k.trial.orientation, "staged path");
  if (turns_by_vector(group)) add("trial_turn", "rad", Role::rate, k.trial.turn, "staged path, run.rotation");
  add_rates(group);
  for (std::size_t u = 0; u < world_.users_.size(); ++u) {
    const Effect as_effect{.kind = {}, .groups = world_.users_[u].groups, .parameters = {}};
    if (acts_on(as_effect, scene_.bodies[group.scene_index])) group.users.push_back(u);
  }
  const bool pairs = has_pair_effect(scene_, scene_.bodies[group.scene_index]);
  const bool pressed = scene_.contact.kind == "penalty" && !scene_.bodies[group.scene_index].shape.empty();
  if (group.users.empty() && !pairs && !pressed) return;
  const char* why = pressed ? "contacts" : pairs ? "effects between bodies" : "user effects";
  add("force", "N", Role::sum, group.force_sums, why);
  for (int c = 0; c < 3; ++c) k.forces.sums.force[c] = group.force_sums[c];
  const bool rubbed = pressed && has_friction(scene_, scene_.bodies[group.scene_index]);
  if (group.spins() && (rubbed || !group.users.empty())) {
    add("torque", "N m", Role::sum, group.torque_sums, rubbed ? "contact friction" : "user effects");
    for (int c = 0; c < 3; ++c) k.forces.sums.torque[c] = group.torque_sums[c];
  }
  if (group.users.empty()) return;
  if (group.spins()) {
    add("trial_spin", "rad/s", Role::rate, k.trial_spin, "user effects");
  }
  if (!k.constants.mass.rows) {
    Column& mass = columns.add({"mass", "kg", 1, Role::constant, "user effects read it"}, first, rows);
    std::fill_n(mass.at(0, first), rows, k.constants.mass.value);
    k.constants.mass.rows = mass.at(0, first);
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
