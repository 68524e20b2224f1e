#include "engine/world/contact_step.h"

#include <cmath>

#include "engine/core/maths.h"
#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

Vector3<Real> at(Real* const (&columns)[3], std::size_t row) {
  return {columns[0][row], columns[1][row], columns[2][row]};
}

void put(Real* const (&columns)[3], std::size_t row, const Vector3<Real>& a) {
  columns[0][row] = a.x, columns[1][row] = a.y, columns[2][row] = a.z;
}

/// q turned by the vector `angle` (world axes): the exponential map.
void turn(Real* const (&q)[4], std::size_t row, const Vector3<Real>& angle) {
  const Real size = length(angle);
  if (!(size > 0)) return;
  const Real half = size / 2, along = maths::sin(half) / size, w = maths::cos(half);
  const Vector3<Real> v = along * angle, old = {q[1][row], q[2][row], q[3][row]};
  const Real old_w = q[0][row];
  const Vector3<Real> turned = w * old + old_w * v + cross(v, old);
  q[0][row] = w * old_w - dot(v, old);
  q[1][row] = turned.x, q[2][row] = turned.y, q[3][row] = turned.z;
}

Real into_period(Real x, double lower, Real period) {
  return period > 0 ? x - period * std::floor((x - static_cast<Real>(lower)) / period) : x;
}

/// Calls act(counter of the run, counter of the contacts) for each.
template <class All, class Own, class Act>
void for_counters(All& all, Own& own, Act act) {
  act(all.pairs, own.pairs);
  act(all.contacts, own.contacts);
  act(all.peak_pairs, own.peak_pairs);
  act(all.peak_contacts, own.peak_contacts);
  act(all.impacts, own.impacts);
  act(all.impact_rounds, own.impact_rounds);
  act(all.unfinished_impacts, own.unfinished_impacts);
  act(all.held_back, own.held_back);
  act(all.missed, own.missed);
  act(all.colours, own.colours);
  act(all.max_penetration, own.deepest);
  act(all.residual, own.residual);
}

}  // namespace

void ImpulseStep::add_counters(Counters& all) const {
  for_counters(all, solver.counters(),
               [](auto& run, const auto& own) { run = static_cast<std::decay_t<decltype(run)>>(own); });
}

void ImpulseStep::set_counters(const Counters& all) {
  for_counters(all, solver.counters(),
               [](const auto& run, auto& own) { own = static_cast<std::decay_t<decltype(own)>>(run); });
}

bool ContactStep::holds(std::size_t group) const {
  return std::any_of(ranges.begin(), ranges.end(), [&](const SlotRange& range) { return range.group == group; });
}

template <class Act>
void ContactStep::for_bodies(const std::vector<Group>& groups, Workers& workers, Act act) const {
  const ContactBodies& bodies = scene().bodies;
  const auto task = [&](std::size_t r) {
    const SlotRange& range = ranges[r];
    const Group& group = groups[range.group];
    for (std::size_t i = 0; i < range.count; ++i) {
      const std::size_t slot = bodies.slot_of(range.first_slot + i);
      const bool spins = bodies.spins && bodies.mobility[slot] > 0;
      act(group, range.first_row + i, slot, spins ? bodies.mobility[slot] / bodies.radius[slot] : Real(0));
    }
  };
  workers.for_each(ranges.size(), task, ranges.size() < 4 ? 1 : workers.threads());
}

void ContactStep::read(const std::vector<Group>& groups, StateColumns StepGroup::*columns, Workers& workers,
                       VectorColumn& position, VectorColumn& velocity, VectorColumn& surface) const {
  for_bodies(groups, workers, [&](const Group& group, std::size_t row, std::size_t slot, Real per_momentum) {
    const StateColumns& state = group.kernel.*columns;
    position.put(slot, at(state.position, row));
    velocity.put(slot, at(state.velocity, row));
    if (!scene().bodies.spins) return;
    surface.put(slot, per_momentum > 0 ? per_momentum * at(state.momentum, row) : Vector3<Real>{});
  });
}

Vector3<Real> ContactStep::wrapped(const Vector3<Real>& x) const {
  const Real* period = scene().period.length;
  return {into_period(x.x, lower[0], period[0]), into_period(x.y, lower[1], period[1]),
          into_period(x.z, lower[2], period[2])};
}

std::size_t ContactStep::count_outside(const std::vector<Group>& groups, double time) const {
  const std::vector<Wall>& walls = scene().walls;
  std::vector<Vector3<Real>> offsets;
  for (const Wall& wall : walls) {
    const Vector3<double> moved = wall.motion.displacement(time);
    offsets.push_back({static_cast<Real>(moved.x), static_cast<Real>(moved.y), static_cast<Real>(moved.z)});
  }
  std::size_t count = 0;
  for (const SlotRange& range : ranges) {
    const StateColumns& state = groups[range.group].kernel.state;
    for (std::size_t i = 0; i < range.count; ++i) {
      const Vector3<Real> x = at(state.position, range.first_row + i);
      bool outside = false;
      for (std::size_t w = 0; w < offsets.size(); ++w) outside |= walls[w].distance(x - offsets[w], 0) < 0;
      count += outside;
    }
  }
  return count;
}

void ImpulseStep::read_start(const std::vector<Group>& groups, Workers& workers) {
  ContactBodies& bodies = solver.bodies;
  read(groups, &StepGroup::state, workers, bodies.position, bodies.velocity, bodies.surface);
}

void ImpulseStep::read_trial(const std::vector<Group>& groups, Workers& workers) {
  ContactBodies& bodies = solver.bodies;
  read(groups, &StepGroup::state, workers, bodies.end_position, bodies.end_velocity, bodies.end_surface);
}

/// A body that nothing touched gets back the bits of its trial.
void ImpulseStep::write(const std::vector<Group>& groups, Workers& workers) const {
  const ContactBodies& bodies = solver.bodies;
  for_bodies(groups, workers, [&](const Group& group, std::size_t row, std::size_t slot, Real per_momentum) {
    const StateColumns& state = group.kernel.state;
    put(state.position, row, wrapped(bodies.end_position.at(slot)));
    put(state.velocity, row, bodies.end_velocity.at(slot));
    if (!(per_momentum > 0)) return;
    const Vector3<Real> trial = at(state.momentum, row);
    const Vector3<Real> change = bodies.end_surface.at(slot) - per_momentum * trial;
    put(state.momentum, row, trial + (1 / per_momentum) * change);
    if (group.turns()) turn(state.orientation, row, (1 / bodies.radius[slot]) * bodies.turned.at(slot));
  });
}

void PenaltyStep::add_counters(Counters& all) const {
  const PenaltyCounters& own = penalty.counters();
  all.pairs = own.pairs, all.contacts = own.contacts;
  all.peak_pairs = own.peak_pairs, all.peak_contacts = own.peak_contacts;
  all.neighbour_lists = own.lists, all.missed = own.stepped;
  all.max_penetration = static_cast<double>(own.deepest);
  all.contact_spring = static_cast<double>(own.spring), all.contact_damping = static_cast<double>(own.damping);
}

void PenaltyStep::set_counters(const Counters& all) {
  PenaltyCounters& own = penalty.counters();
  own.pairs = all.pairs, own.contacts = all.contacts;
  own.peak_pairs = all.peak_pairs, own.peak_contacts = all.peak_contacts;
  own.lists = all.neighbour_lists, own.stepped = all.missed;
  own.deepest = static_cast<Real>(all.max_penetration);
  own.spring = static_cast<Real>(all.contact_spring), own.damping = static_cast<Real>(all.contact_damping);
}

void PenaltyStep::read_state(const std::vector<Group>& groups, StateColumns StepGroup::*columns, Workers& workers) {
  ContactBodies& bodies = penalty.bodies;
  read(groups, columns, workers, bodies.position, bodies.velocity, bodies.surface);
}

void PenaltyStep::begin(const std::vector<Group>& groups, double time, Real h, Workers& workers) {
  read_state(groups, &StepGroup::state, workers);
  penalty.begin(time, h, workers);
}

/// Tangential springs of a splitting drift as positions do, by the velocities that these had.
void PenaltyStep::drift(const std::vector<Group>& groups, Real h, Workers& workers) {
  if (h == 0 || !penalty.bodies.spins) return;
  read_state(groups, &StepGroup::state, workers);
  ContactBodies& bodies = penalty.bodies;
  for_bodies(groups, workers, [&](const Group&, std::size_t, std::size_t slot, Real) {
    bodies.position.put(slot, bodies.position.at(slot) - (h / 2) * bodies.velocity.at(slot));
  });
  penalty.drift(h, workers);
}

void PenaltyStep::add_forces(const std::vector<Group>& groups, const Method& method, int phase, double time,
                             Workers& workers) {
  const bool splits = method.family == Family::splitting;
  if (splits) drift(groups, phase > 0 ? method.drift[phase - 1] : method.lead, workers);
  read_state(groups, &StepGroup::trial, workers);
  const std::size_t before = splits ? 0 : static_cast<std::size_t>(phase);
  penalty.find_forces({method.a[phase], before}, phase == 0, time, workers);
  const ContactBodies& bodies = penalty.bodies;
  for_bodies(groups, workers, [&](const Group& group, std::size_t row, std::size_t slot, Real per_momentum) {
    put(group.force_sums, row, at(group.force_sums, row) + penalty.force.at(slot));
    if (!(per_momentum > 0)) return;
    put(group.torque_sums, row, at(group.torque_sums, row) + bodies.radius[slot] * penalty.moment.at(slot));
  });
}

void PenaltyStep::finish(const std::vector<Group>& groups, const Method& method, Workers& workers) {
  if (method.family == Family::splitting) {
    drift(groups, method.drift[method.phases - 1], workers);
  } else {
    penalty.finish({method.b, static_cast<std::size_t>(method.phases)}, workers);
  }
  if (!penalty.period.any()) return;
  for_bodies(groups, workers, [&](const Group& group, std::size_t row, std::size_t, Real) {
    const StateColumns& state = group.kernel.state;
    put(state.position, row, wrapped(at(state.position, row)));
  });
}

Real PenaltyStep::stride(const std::vector<Group>& groups, Real h, Workers& workers) {
  const ContactBodies& bodies = penalty.bodies;
  strides_.resize(bodies.count);
  for_bodies(groups, workers, [&](const Group& group, std::size_t row, std::size_t slot, Real) {
    const StateColumns &from = group.kernel.before, &to = group.kernel.state;
    const Real way = length(nearest_image(at(to.position, row) - at(from.position, row), penalty.period));
    const Real speed = std::max(length(at(from.velocity, row)), length(at(to.velocity, row)));
    strides_[slot] = std::max(way, h * speed) / bodies.radius[slot];
  });
  Real wall_speed = 0, most = 0;
  for (const Wall& wall : penalty.walls) wall_speed = std::max(wall_speed, static_cast<Real>(wall.motion.top_speed()));
  for (std::size_t slot = 0; slot < bodies.count; ++slot) {
    most = std::max({most, strides_[slot], h * wall_speed / bodies.radius[slot]});
  }
  return most;
}

std::vector<BodyLoad> PenaltyStep::loads(const std::vector<Group>& groups, double time, Workers& workers) {
  read_state(groups, &StepGroup::state, workers);
  return penalty.loads(time, workers);
}

double PenaltyStep::power(const std::vector<Group>& groups, double time, Workers& workers) {
  read_state(groups, &StepGroup::state, workers);
  ContactBodies& bodies = penalty.bodies;
  const VectorColumn velocity = bodies.velocity;
  const auto power_now = [&] {
    penalty.loads(time, workers);
    double sum = 0;
    for (std::size_t slot = 0; slot < bodies.count; ++slot) {
      sum += static_cast<double>(dot(penalty.force.at(slot), velocity.at(slot)));
      if (bodies.spins) sum += static_cast<double>(dot(penalty.moment.at(slot), bodies.surface.at(slot)));
    }
    return sum;
  };
  const double all = power_now();
  if (remembers()) return all;
  for (std::size_t slot = 0; slot < bodies.count; ++slot) bodies.velocity.put(slot, {});
  return all - power_now();  // what springs would do at rest as well comes back
}

double PenaltyStep::energy(const std::vector<Group>& groups, double time, Workers& workers) {
  read_state(groups, &StepGroup::state, workers);
  return penalty.energy(time, workers);
}

}  // namespace ballpark::BALLPARK_PRECISION
