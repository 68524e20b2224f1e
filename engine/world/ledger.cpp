#include "engine/world/ledger.h"

#include <array>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// Gauss-Legendre, four nodes: exact for polynomials of degree 7. (Abramowitz and Stegun 25.4.30, table 25.4.)
struct Node {
  double place, weight;  ///< on [0, 1]
};
constexpr Node nodes[] = {{0.06943184420297371, 0.17392742256872693},
                          {0.33000947820757187, 0.32607257743127307},
                          {0.66999052179242813, 0.32607257743127307},
                          {0.93056815579702629, 0.17392742256872693}};

double power_of(const Vector3<Real>& force, const Vector3<Real>& velocity) {
  return static_cast<double>(force.x) * static_cast<double>(velocity.x) +
         static_cast<double>(force.y) * static_cast<double>(velocity.y) +
         static_cast<double>(force.z) * static_cast<double>(velocity.z);
}

/// What an effect does where a body is: alone in the flow, or, if it answers to loads, on top of them.
Loads<Real> loads_of(const Group& group, std::size_t e, const void* constants, const Body<Real>& body, double time) {
  LocalForces forces = group.kernel.forces;
  forces.sums = {};
  forces.start = time;
  forces.turning_apart = false;
  const EffectInstance instance{static_cast<int>(e), constants};
  if (!local_effects()[e].reads_loads) {
    forces.begin = &instance, forces.end = &instance + 1;
    return forces.loads(body, 0);
  }
  while (forces.end[-1].constants != constants) --forces.end;
  Loads<Real> loads = forces.loads(body, 0);
  --forces.end;
  const Loads<Real> before = forces.loads(body, 0);
  loads.force -= before.force;
  loads.torque -= before.torque;
  return loads;
}

template <class M>
void add_effects(const Group& group, const Body<Real>& body, double time, EnergyReading& sum) {
  for (std::size_t e = 0; e < group.effects.size(); ++e) {
    const EffectInfo& info = local_effects()[e];
    const std::vector<std::byte>& instances = group.effects[e];
    for (std::size_t at = 0; info.pushes && at < instances.size(); at += info.constants_size) {
      const void* constants = instances.data() + at;
      Loads<Real> loads = loads_of(group, e, constants, body, time);
      if (info.energy) {  // what it would do at rest as well comes back
        sum.potential[e] += static_cast<double>(info.energy(constants, body));
        Body<Real> at_rest = body;
        at_rest.velocity = at_rest.spin = {};
        const Loads<Real> kept = loads_of(group, e, constants, at_rest, time);
        loads.force -= kept.force;
        loads.torque -= kept.torque;
      }
      sum.power[e] += power_of(loads.force, body.velocity);
      if constexpr (M::spins) sum.power[e] += power_of(loads.torque, body.spin);
    }
  }
}

template <class M>
void add_body(const Group& group, std::size_t row, double time, EnergyReading& sum) {
  if (!is_finite(group, row)) return;
  const BodyConstants& constants = group.kernel.constants;
  const auto c = M::template constants<Real>(constants, row);
  Real y[M::size];
  M::load(group.kernel.state, row, y);
  const Body<Real> body = M::body(c, y);
  const double half_mass = 0.5 * static_cast<double>(constants.effective_mass.at<Real>(row));
  const double translation = half_mass * power_of(body.velocity, body.velocity);
  sum.kinetic.translation += translation;
  if constexpr (M::size == PivotedMotion::size) {  // w.L / 2 about the pivot is all of it
    sum.kinetic.rotation += 0.5 * power_of(body.spin, vector_from(y)) - translation;
  } else if constexpr (M::spins) {
    sum.kinetic.rotation += 0.5 * power_of(body.spin, M::angular_momentum(y));
  }
  add_effects<M>(group, body, time, sum);
}

}  // namespace

void EnergyReading::add(const EnergyReading& part) {
  kinetic.translation += part.kinetic.translation;
  kinetic.rotation += part.kinetic.rotation;
  for (std::size_t i = 0; i < power.size(); ++i) {
    power[i] += part.power[i];
    potential[i] += part.potential[i];
  }
}

double EnergyReading::energy() const {
  double sum = kinetic.sum();
  for (const double part : potential) sum += part;
  return sum;
}

template <class Book, class Act>
void LedgerBook::for_numbers(Book& book, Act act) {
  const auto sum = [&](auto& s) { act(s.value), act(s.rest); };
  act(book.from);
  act(book.initial.kinetic.translation), act(book.initial.kinetic.rotation);
  for (auto& potential : book.initial.potential) act(potential);
  for (auto& work : book.work) sum(work);
  for (auto& work : book.between_steps) sum(work);
  sum(book.contacts), sum(book.outside);
}

std::vector<double> LedgerBook::numbers() const {
  std::vector<double> all;
  for_numbers(*this, [&](double number) { all.push_back(number); });
  return all;
}

bool LedgerBook::set_numbers(const std::vector<double>& all) {
  if (all.size() != numbers().size()) return false;
  std::size_t i = 0;
  for_numbers(*this, [&](double& number) { number = all[i++]; });
  return true;
}

void LedgerBook::add_work(const EnergyReading& at, double seconds) {
  for (std::size_t i = 0; i < work.size(); ++i) work[i].add(seconds * at.power[i]);
}

void LedgerBook::add_jump(const EnergyReading& before, const EnergyReading& after, ExactSum LedgerBook::*cause) {
  (this->*cause).add(after.energy() - before.energy());
}

EnergyReading World::read_energy() const {
  const std::size_t local = local_effects().size(), between = local + pair_systems_.size();
  const EnergyReading nothing(between + users_.size() + 1);
  const std::vector<Block>& blocks = whole_.blocks;
  std::vector<EnergyReading> parts(blocks.size(), nothing);
  workers_.for_each(blocks.size(), [&](std::size_t b) {
    const Group& group = groups_[blocks[b].group];
    with_carried(group.carried, [&]<class M>() {
      for (std::size_t row = blocks[b].first; row < blocks[b].last; ++row) add_body<M>(group, row, time(), parts[b]);
    });
  });
  EnergyReading sum = nothing;
  for (const EnergyReading& part : parts) sum.add(part);
  for (std::size_t p = 0; p < pair_systems_.size(); ++p) {
    sum.power[local + p] = pair_systems_[p].power(groups_, workers_);
    sum.potential[local + p] = pair_systems_[p].energy(groups_, workers_);
  }
  for (std::size_t u = 0; u < users_.size(); ++u) sum.power[between + u] = power_of_user(u);
  if (penalty_) {
    sum.power.back() = penalty_->power(groups_, time(), workers_);
    sum.potential.back() = penalty_->energy(groups_, time(), workers_);
  }
  return sum;
}

/// Of a user effect, on all groups that it is for.
double World::power_of_user(std::size_t user) const {
  double sum = 0;
  for (const Group& group : groups_) {
    if (std::find(group.users.begin(), group.users.end(), user) == group.users.end()) continue;
    const std::size_t rows = padded(group.live);
    std::array<AlignedArray<Real>, 9> columns;
    for (AlignedArray<Real>& column : columns) column = AlignedArray<Real>(rows);
    const auto three = [&](std::size_t first) {
      return std::array{columns[first].data(), columns[first + 1].data(), columns[first + 2].data()};
    };
    const std::array<Real*, 3> spin = three(0), force = three(3), torque = three(6);
    for (std::size_t row = 0; row < group.live; ++row) {
      const Vector3<Real> turning = body_at(group, row).spin;
      spin[0][row] = turning.x, spin[1][row] = turning.y, spin[2][row] = turning.z;
    }
    BodyBlock<Real> view = block_of(group, group.kernel.state, {0, 0, group.live});
    view.time = time();
    for (int c = 0; c < 3; ++c) {
      if (view.angular_velocity[c]) view.angular_velocity[c] = spin[static_cast<std::size_t>(c)];
      view.force[c] = force[static_cast<std::size_t>(c)];
      if (view.torque[c]) view.torque[c] = torque[static_cast<std::size_t>(c)];
    }
    run_user(users_[user], view);
    for (std::size_t row = 0; row < group.live; ++row) {
      const Body<Real> body = body_at(group, row);
      sum += power_of({force[0][row], force[1][row], force[2][row]}, body.velocity);
      sum += power_of({torque[0][row], torque[1][row], torque[2][row]}, body.spin);
    }
  }
  return sum;
}

void World::keep_ledger(bool on) {
  book_.reset();
  if (!on) return;
  for (const Group& group : groups_) {
    if (!group.kernel.forces.sums.force[0] || !group.answers_to_loads()) continue;
    throw SceneError("ledger", "the table under group " + group.name +
                                   " answers to forces between bodies or of users, whose work then cannot be told "
                                   "apart; expected a scene without one or the other");
  }
  EnergyReading now = read_energy();
  const std::size_t lines = now.power.size();
  book_.reset(new LedgerBook{
      time(), std::move(now), std::vector<ExactSum>(lines), std::vector<ExactSum>(between_steps_.size()), {}, {}});
}

/// A step, then the way that it went, gone again aside from where it began.
void World::booked_step(double until) {
  const Snapshot before = snapshot();
  const double from = time();
  adaptive_ ? adaptive_step(until) : one_step();
  const double to = time();
  if (!(to > from) || status_.code == Status::Code::non_finite) return;
  const Snapshot after = snapshot();
  const Stiffness watched = watched_stiffness_;
  return_to(before);
  book_path(from, to);
  return_to(after);
  watched_stiffness_ = watched;
}

/// Smooth from one event to the next.
void World::book_path(double from, double to) {
  std::vector<double> ends{from};
  for (std::size_t e = next_event_; e < events_.size() && events_[e].at < to; ++e) {
    if (events_[e].at > ends.back()) ends.push_back(events_[e].at);
  }
  ends.push_back(to);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double length = ends[i + 1] - ends[i];
    for (const Node& node : nodes) {
      look_ahead(ends[i] + node.place * length, [&] { book_->add_work(read_energy(), node.weight * length); });
    }
  }
}

Ledger World::ledger() const {
  if (!book_) throw SceneError("ledger", "the ledger is closed; expected keep_ledger(true) before the steps");
  const EnergyReading now = read_energy(), &then = book_->initial;
  Ledger all{book_->from, time(), then.kinetic, now.kinetic, {}};
  const auto named = [&](const std::string& name) -> LedgerLine& {  // two networks of bonds share a line
    const auto same = [&](const LedgerLine& other) { return other.name == name; };
    const auto of = std::find_if(all.lines.begin(), all.lines.end(), same);
    return of == all.lines.end() ? all.lines.emplace_back(LedgerLine{.name = name}) : *of;
  };
  const auto line = [&](const std::string& name, bool has_energy, std::size_t i) {
    const double before = then.potential[i], after = now.potential[i];
    LedgerLine& of = named(name);
    of.work += book_->work[i].total() - (after - before);
    of.has_energy |= has_energy;
    of.initial += before, of.final += after;
  };
  std::size_t i = 0;
  for (; i < local_effects().size(); ++i) {
    const EffectInfo& info = local_effects()[i];
    const bool on = std::any_of(groups_.begin(), groups_.end(), [&](const Group& g) { return !g.effects[i].empty(); });
    if (on && info.pushes) line(info.description.name, info.energy != nullptr, i);
  }
  for (const PairSystem& system : pair_systems_) line(system.name(), system.info->description.has_energy, i++);
  for (const UserEffect& user : users_) line(user.name, false, i++);
  if (penalty_) line("contacts", true, i);
  if (penalty_ && penalty_->remembers()) all.lines.back().work = book_->work[i].total();
  for (std::size_t b = 0; b < between_steps_.size(); ++b) {
    named(between_steps_[b].name()).work += book_->between_steps[b].total();
  }
  if (impulse_) all.lines.push_back({"contacts", book_->contacts.total()});
  if (book_->outside.total() != 0) all.lines.push_back({"from outside", book_->outside.total()});
  return all;
}

}  // namespace ballpark::BALLPARK_PRECISION
