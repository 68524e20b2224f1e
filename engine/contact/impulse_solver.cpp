#include "engine/contact/impulse_solver.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace ballpark::BALLPARK_PRECISION {

namespace {

constexpr std::size_t contacts_per_task = 512;

std::size_t tasks(std::size_t items, std::size_t per_task) {
  return (items + per_task - 1) / per_task;
}

Vector3<Real> real(const Vector3<double>& a) {
  return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
}

}  // namespace

/// Bodies that were found near each other come near in memory. What is remembered between steps goes by rank.
void ImpulseSolver::sort_bodies() {
  if (nearby_.size() != bodies.count || bodies.count == 0) return;
  for (std::size_t slot = 0; slot < bodies.count; ++slot) {
    nearby_[slot] += static_cast<std::uint32_t>(slot / bodies.per_copy * bodies.per_copy);
  }
  bodies.sort(nearby_);
  nearby_.clear();
}

void ImpulseSolver::find(double time, Real step, Workers& workers) {
  set_moments(time, step);
  const bool sorts = bodies.count >= settings.sort_from && found_++ % settings.sort_every == 0;
  set_.find(bodies, walls, moments_, period, laws, step, settings.margin, workers, sorts ? &nearby_ : nullptr);
  impacts_.forget_neighbours();
  counters_.pairs += set_.candidates;
  counters_.peak_pairs = std::max<std::uint64_t>(counters_.peak_pairs, set_.candidates);
  counters_.colours = std::max(counters_.colours, static_cast<int>(set_.colour_begin.size()) - 1);
  elapsed_ = 0;
  if (settings.substeps == 1) return;  // then the bodies themselves are as they were planned
  start_ = bodies.position;
  planned_ = bodies.velocity;
}

void ImpulseSolver::reflect(double time, Real substep, Workers& workers) {
  set_moments(time, substep);
  elapsed_ += substep;
  impacts_.begin(bodies, movers_);
  prepare(substep, workers);
  impacts_.resolve({bodies, walls, moments_, laws, period, substep, settings.push_out, settings.restitution_threshold},
                   set_, closing_, workers);
  counters_.impacts += impacts_.count;
  counters_.impact_rounds = std::max(counters_.impact_rounds, impacts_.rounds);
  counters_.unfinished_impacts += impacts_.unfinished;
  mark_approaches(workers);
}

/// Which contacts that may come to rest approach at the start, after all impacts.
void ImpulseSolver::mark_approaches(Workers& workers) {
  for_contacts(workers, [&](const std::vector<Contact>& list, std::size_t first, std::size_t last, bool wall) {
    std::vector<std::uint8_t>& marks = wall ? set_.wall_marks : set_.pair_marks;
    for (std::size_t i = first; i < last; ++i) {
      if (!marks[i] || (marks[i] & ContactSet::was_loaded)) continue;
      const Contact& contact = list[i];
      const Vector3<Real> a =
          wall ? moments_[contact.a].velocity : bodies.velocity.at(contact.a) + impacts_.kick_of(contact.a);
      const Vector3<Real> b = bodies.velocity.at(contact.b) + impacts_.kick_of(contact.b);
      if (dot(contact.normal, b - a) < 0) marks[i] |= ContactSet::approaches;
    }
  });
}

void ImpulseSolver::solve(Workers& workers) {
  start_movers(workers);
  bodies.spins ? keep_apart<true>(workers) : keep_apart<false>(workers);
  hold_back(last_substep_, workers);
  choose_held(workers);
  advance_bodies(last_substep_, workers);
}

void ImpulseSolver::relax(Workers& workers) {
  bodies.spins ? settle<true>(workers) : settle<false>(workers);
  finish(workers);
}

void ImpulseSolver::set_moments(double time, Real substep) {
  moments_.resize(walls.size());
  wall_sides_.resize(walls.size());
  const double end = time + static_cast<double>(substep);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const WallMotion& motion = walls[w].motion;
    const Vector3<double> from = motion.displacement(time), to = motion.displacement(end);
    moments_[w] = {real(from), real(to - from), real(motion.velocity_at(time)) + walls[w].belt,
                   real(motion.velocity_at(end)) + walls[w].belt};
  }
}

/// Where each contact is, and which begin with an impact: those that meet, approach, and bore no load until now.
void ImpulseSolver::prepare(Real substep, Workers& workers) {
  const Substep now{bodies, walls, moments_, laws, period, substep, settings.push_out, settings.restitution_threshold};
  const std::size_t blocks = tasks(bodies.count, slots_per_task);
  closing_.resize(blocks);
  set_.pair_marks.resize(set_.pairs.size());
  set_.wall_marks.resize(set_.walls.size());
  block_maximum_.assign(blocks, 0);
  const Real scale = last_substep_ > 0 ? substep / last_substep_ : Real(1);  // an impulse is a force times a time
  last_substep_ = substep;
  const auto ready = [&](Contact& contact, bool wall, std::uint8_t& mark, std::size_t block) {
    const bool starts = now.place(contact, wall, {}, {}) <= 1 && !contact.loaded();
    for (ContactImpulse* impulse : {&contact.solved, &contact.relaxed}) {
      impulse->normal *= scale;
      impulse->tangent = scale * (impulse->tangent - dot(contact.normal, impulse->tangent) * contact.normal);
    }
    if (contact.least_speed > 0) {
      block_maximum_[block] = std::max(block_maximum_[block], contact.least_speed * substep / settings.push_out);
    }
    const Vector3<Real> other = wall ? moments_[contact.a].velocity : bodies.velocity.at(contact.a);
    const bool approaches = dot(contact.normal, bodies.velocity.at(contact.b) - other) < 0;
    mark = contact.loaded()                            ? ContactSet::was_loaded
           : !approaches && !(contact.least_speed < 0) ? ContactSet::touches
                                                       : 0;
    return starts && approaches;
  };
  workers.for_each(blocks, [&](std::size_t block) {
    const std::size_t first = block * slots_per_task, last = std::min(first + slots_per_task, bodies.count);
    closing_[block].clear();
    for (std::size_t slot = first; slot < last; ++slot) {
      const std::uint32_t rank = bodies.rank_of(slot);
      for (std::uint32_t i = set_.first_of_rank[rank]; i < set_.first_of_rank[rank + 1]; ++i) {
        const std::uint32_t at = set_.place[i];
        if (ready(set_.pairs[at], false, set_.pair_marks[at], block)) closing_[block].push_back(i);
      }
      for (std::uint32_t i = set_.first_wall_of_rank[rank]; i < set_.first_wall_of_rank[rank + 1]; ++i) {
        if (!ready(set_.walls[i], true, set_.wall_marks[i], block)) continue;
        closing_[block].push_back(static_cast<std::uint32_t>(set_.pairs.size()) + i);
      }
    }
  });
  for (const Real depth : block_maximum_) counters_.deepest = std::max(counters_.deepest, depth);
}

/// Velocity over the substep's smooth motion.
Vector3<Real> ImpulseSolver::mean_velocity(std::size_t slot) const {
  return (1 / last_substep_) * (bodies.end_position.at(slot) - bodies.position.at(slot));
}

Vector3<Real> ImpulseSolver::mean_surface(std::size_t slot) const {
  return Real(0.5) * (bodies.surface.at(slot) + bodies.end_surface.at(slot));
}

/// Mean velocities over the substep, with what impacts have added.
void ImpulseSolver::start_movers(Workers& workers) {
  for_slots(workers, [&](std::size_t i) {
    Mover mover{mean_velocity(i), {}, bodies.inverse_mass[i], bodies.mobility[i]};
    if (bodies.spins) mover.surface = mean_surface(i);
    if (impacts_.touches(i)) {
      mover.velocity += movers_[i].velocity;
      if (bodies.spins) mover.surface += movers_[i].surface;
    }
    movers_[i] = mover;
  });
}

template <class Act>
Real ImpulseSolver::sweep(Act act, Workers& workers) {
  const std::size_t wall_tasks = set_.walls.empty() ? 0 : tasks(bodies.count, slots_per_task);
  const int at_most = set_.pairs.size() + set_.walls.size() < 2 * contacts_per_task ? 1 : workers.threads();
  block_maximum_.assign(std::max(tasks(set_.pairs.size(), contacts_per_task), wall_tasks), 0);
  const auto note = [&](std::size_t task, Real error) { block_maximum_[task] = std::max(block_maximum_[task], error); };
  const std::size_t colours = set_.colour_begin.size() - 1;
  for (std::size_t colour = 0; colour < colours; ++colour) {
    const std::size_t first = set_.colour_begin[colour], last = set_.colour_begin[colour + 1];
    const bool shares = set_.last_colour_shares && colour + 1 == colours;
    const std::size_t per_task = shares ? last - first : contacts_per_task;
    const auto task = [&](std::size_t t) {
      Real most = 0;
      for (std::size_t i = first + t * per_task; i < std::min(first + (t + 1) * per_task, last); ++i) {
        Contact& contact = set_.pairs[i];
        most = std::max(most, act(contact, movers_[contact.a], movers_[contact.b]));
      }
      note(t, most);
    };
    workers.for_each(tasks(last - first, per_task), task, at_most);
  }
  const auto task = [&](std::size_t t) {
    const std::size_t begin = t * slots_per_task, end = std::min(begin + slots_per_task, bodies.count);
    Real most = 0;
    for (std::uint32_t i = set_.first_wall_of_rank[begin]; i < set_.first_wall_of_rank[end]; ++i) {
      Contact& contact = set_.walls[i];
      most = std::max(most, act(contact, wall_sides_[contact.a], movers_[contact.b]));
    }
    note(t, most);
  };
  workers.for_each(wall_tasks, task, at_most);
  return block_maximum_.empty() ? Real(0) : *std::max_element(block_maximum_.begin(), block_maximum_.end());
}

/// What still closes is stopped where it touches: restitution 0, on the mean velocity.
template <bool friction>
void ImpulseSolver::keep_apart(Workers& workers) {
  for (std::size_t w = 0; w < walls.size(); ++w) {
    wall_sides_[w].velocity = (1 / last_substep_) * moments_[w].moved + walls[w].belt;
  }
  sweep(
      [](const Contact& contact, auto& a, Mover& b) {
        if (contact.solved.normal != 0) apply<friction>(contact.solved, contact.normal, a, b);
        return Real(0);
      },
      workers);
  for (int n = 0; n < settings.iterations; ++n) {
    sweep([](Contact& contact, auto& a,
             Mover& b) { return update<friction>(contact, contact.least_speed, {}, contact.solved, a, b); },
          workers);
  }
}

/// Positions after the substep; movers go on with its end velocities.
void ImpulseSolver::advance_bodies(Real substep, Workers& workers) {
  for_slots(workers, [&](std::size_t i) {
    const Vector3<Real> change = movers_[i].velocity - mean_velocity(i);
    movers_[i].velocity = bodies.end_velocity.at(i) + change;
    if (share_[i] < 1) {
      bodies.end_position.put(i, bodies.position.at(i) + share_[i] * (bodies.end_position.at(i) + substep * change -
                                                                      bodies.position.at(i)));
    } else {
      bodies.end_position.put(i, bodies.end_position.at(i) + substep * change);
    }
    if (!bodies.spins) return;
    const Vector3<Real> turn = movers_[i].surface - mean_surface(i);
    movers_[i].surface = bodies.end_surface.at(i) + turn;
    if (bodies.turns) bodies.turned.put(i, share_[i] * substep * turn);
  });
}

/// Velocity at the end of the substep, with what contacts have changed.
Vector3<Real> ImpulseSolver::end_velocity(std::size_t slot) const {
  return bodies.end_velocity.at(slot) + (movers_[slot].velocity - mean_velocity(slot));
}

/// Does a contact that bears no load come to rest all the same? Only if it bore one before, touched without
/// approaching, or was reflected (and then its sides did not approach after the impacts); and if another substep like
/// the end of this one would close it. An integrator may move a body before its velocity changes, and a bounce may be
/// over within the substep.
bool ImpulseSolver::settles(const Contact& contact, std::uint8_t mark, bool wall) const {
  const Vector3<Real> mean_a = wall ? wall_sides_[contact.a].velocity : movers_[contact.a].velocity;
  if (mark & ContactSet::approaches) return false;
  const Vector3<Real> end_a = wall ? moments_[contact.a].end_velocity : end_velocity(contact.a);
  const Real gap = contact.least_speed > 0 ? -contact.least_speed / settings.push_out : -contact.least_speed;
  const Real parting = dot(contact.normal, movers_[contact.b].velocity - mean_a);
  return gap + parting + dot(contact.normal, end_velocity(contact.b) - end_a) < 0;
}

/// act(list, first, last, with walls?) for parts of both lists of contacts.
template <class Act>
void ImpulseSolver::for_contacts(Workers& workers, Act act) {
  const std::size_t pairs = tasks(set_.pairs.size(), contacts_per_task);
  const std::size_t all = pairs + tasks(set_.walls.size(), contacts_per_task);
  const auto task = [&](std::size_t t) {
    const bool wall = t >= pairs;
    std::vector<Contact>& list = wall ? set_.walls : set_.pairs;
    const std::size_t first = (wall ? t - pairs : t) * contacts_per_task;
    act(list, first, std::min(first + contacts_per_task, list.size()), wall);
  };
  workers.for_each(all, task, all < 4 ? 1 : workers.threads());
}

/// Which contacts hold the velocity itself: the least normal speed is 0 for them, and none for the others.
void ImpulseSolver::choose_held(Workers& workers) {
  constexpr Real free = -std::numeric_limits<Real>::infinity();
  const auto choose = [&](Contact& contact, std::uint8_t mark, bool wall) {
    const bool held = contact.solved.normal > 0 || (mark && settles(contact, mark, wall));
    contact.least_speed = held ? Real(0) : free;
    if (!held || contact.relaxed.normal < -contact.solved.normal) contact.relaxed = {};
  };
  for_contacts(workers, [&](std::vector<Contact>& list, std::size_t first, std::size_t last, bool wall) {
    const std::vector<std::uint8_t>& marks = wall ? set_.wall_marks : set_.pair_marks;
    for (std::size_t i = first; i < last; ++i) choose(list[i], marks[i], wall);
  });
}

/// Contacts that bear a load hold the velocity itself: what rests is left with none.
template <bool friction>
void ImpulseSolver::settle(Workers& workers) {
  for (std::size_t w = 0; w < walls.size(); ++w) wall_sides_[w].velocity = moments_[w].end_velocity;
  sweep(
      [](const Contact& contact, auto& a, Mover& b) {
        if (contact.least_speed == 0) apply<friction>(contact.relaxed, contact.normal, a, b);
        return Real(0);
      },
      workers);
  for (int n = 0; n < settings.relax_iterations; ++n) {
    counters_.residual = sweep(
        [](Contact& contact, auto& a, Mover& b) {
          if (contact.least_speed < 0) return Real(0);
          return update<friction>(contact, 0, contact.solved, contact.relaxed, a, b);
        },
        workers);
  }
}

/// What the world reads back.
void ImpulseSolver::finish(Workers& workers) {
  for_slots(workers, [&](std::size_t i) {
    bodies.end_velocity.put(i, movers_[i].velocity);
    if (bodies.spins) bodies.end_surface.put(i, movers_[i].surface);
  });
  std::atomic<std::uint64_t> all = 0;
  for_contacts(workers, [&](const std::vector<Contact>& list, std::size_t first, std::size_t last, bool) {
    std::uint64_t loaded = 0;
    for (std::size_t i = first; i < last; ++i) loaded += list[i].loaded();
    all.fetch_add(loaded, std::memory_order_relaxed);
  });
  const std::uint64_t loaded = all;
  counters_.contacts += loaded;
  counters_.peak_contacts = std::max(counters_.peak_contacts, loaded);
}

std::size_t ImpulseSolver::bytes() const {
  std::size_t sum = bodies.bytes() + set_.bytes() + impacts_.bytes() + movers_.capacity() * sizeof(Mover) +
                    (block_maximum_.capacity() + share_.capacity() + shorter_.capacity()) * sizeof(Real) +
                    deflected_.capacity() + next_deflected_.capacity();
  for (const auto& list : closing_) sum += list.capacity() * sizeof(list[0]);
  return sum + start_.bytes() + planned_.bytes() + nearby_.capacity() * sizeof(nearby_[0]);
}

}  // namespace ballpark::BALLPARK_PRECISION
