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

Real wrapped(Real x, Real lower, Real period) {
  return period > 0 ? x - period * std::floor((x - lower) / period) : x;
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

void ContactStep::add_counters(Counters& all) const {
  for_counters(all, solver.counters(),
               [](auto& run, const auto& own) { run = static_cast<std::decay_t<decltype(run)>>(own); });
}

void ContactStep::set_counters(const Counters& all) {
  for_counters(all, solver.counters(),
               [](const auto& run, auto& own) { own = static_cast<std::decay_t<decltype(own)>>(run); });
}

/// Calls act(group, row, slot, surface speed per angular momentum) for all bodies that may touch.
template <class Act>
void ContactStep::for_ranges(const std::vector<Group>& groups, Workers& workers, Act act) const {
  const auto task = [&](std::size_t r) {
    const SlotRange& range = ranges[r];
    const Group& group = groups[range.group];
    for (std::size_t i = 0; i < range.count; ++i) {
      const std::size_t slot = range.first_slot + i;
      const bool spins = solver.bodies.spins && solver.bodies.mobility[slot] > 0;
      act(group, range.first_row + i, slot,
          spins ? solver.bodies.mobility[slot] / solver.bodies.radius[slot] : Real(0));
    }
  };
  workers.for_each(ranges.size(), task, ranges.size() < 4 ? 1 : workers.threads());
}

/// The state columns as they are now, into these columns of the slots.
void ContactStep::read(const std::vector<Group>& groups, Workers& workers, VectorColumn& position,
                       VectorColumn& velocity, VectorColumn& surface) {
  for_ranges(groups, workers, [&](const Group& group, std::size_t row, std::size_t slot, Real per_momentum) {
    const StateColumns& state = group.kernel.state;
    position.put(slot, at(state.position, row));
    velocity.put(slot, at(state.velocity, row));
    if (per_momentum > 0) surface.put(slot, per_momentum * at(state.momentum, row));
  });
}

void ContactStep::read_start(const std::vector<Group>& groups, Workers& workers) {
  ContactBodies& bodies = solver.bodies;
  read(groups, workers, bodies.position, bodies.velocity, bodies.surface);
}

void ContactStep::read_trial(const std::vector<Group>& groups, Workers& workers) {
  ContactBodies& bodies = solver.bodies;
  read(groups, workers, bodies.end_position, bodies.end_velocity, bodies.end_surface);
}

std::size_t ContactStep::count_outside(const std::vector<Group>& groups, double time) const {
  std::vector<Vector3<Real>> offsets;
  for (const Wall& wall : solver.walls) {
    const Vector3<double> moved = wall.motion.displacement(time);
    offsets.push_back({static_cast<Real>(moved.x), static_cast<Real>(moved.y), static_cast<Real>(moved.z)});
  }
  std::size_t count = 0;
  for (const SlotRange& range : ranges) {
    const StateColumns& state = groups[range.group].kernel.state;
    for (std::size_t i = 0; i < range.count; ++i) {
      const Vector3<Real> x = at(state.position, range.first_row + i);
      bool outside = false;
      for (std::size_t w = 0; w < offsets.size(); ++w) outside |= solver.walls[w].distance(x - offsets[w], 0) < 0;
      count += outside;
    }
  }
  return count;
}

/// A body that nothing touched gets back the bits of its trial.
void ContactStep::write(const std::vector<Group>& groups, Workers& workers) const {
  const ContactBodies& bodies = solver.bodies;
  for_ranges(groups, workers, [&](const Group& group, std::size_t row, std::size_t slot, Real per_momentum) {
    const StateColumns& state = group.kernel.state;
    const Vector3<Real> x = bodies.end_position.at(slot);
    const Real* period = solver.period.length;
    put(state.position, row,
        {wrapped(x.x, static_cast<Real>(lower[0]), period[0]), wrapped(x.y, static_cast<Real>(lower[1]), period[1]),
         wrapped(x.z, static_cast<Real>(lower[2]), period[2])});
    put(state.velocity, row, bodies.end_velocity.at(slot));
    if (!(per_momentum > 0)) return;
    const Vector3<Real> trial = at(state.momentum, row);
    const Vector3<Real> change = bodies.end_surface.at(slot) - per_momentum * trial;
    put(state.momentum, row, trial + (1 / per_momentum) * change);
    if (group.turns()) turn(state.orientation, row, (1 / bodies.radius[slot]) * bodies.turned.at(slot));
  });
}

}  // namespace ballpark::BALLPARK_PRECISION
