// The step. Local bodies: one fused pass; else, for each phase of the integrator, passes (staged.cpp).
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// Events this close to a step's ends, in steps, are taken to be on them.
constexpr double on_the_step = 1e-9;

}  // namespace

void World::step(std::uint64_t n) {
  run(n, std::numeric_limits<double>::infinity());
}

void World::advance_to(double t, std::uint64_t most_steps) {
  if (adaptive_) return run(most_steps, t);
  const double steps = std::floor((t - part_) / step_ + on_the_step), done = static_cast<double>(counters_.steps);
  if (steps > done) step(std::min(most_steps, static_cast<std::uint64_t>(steps - done)));
}

void World::run(std::uint64_t most_steps, double until) {
  std::optional<FlushDenormals> flush;  // once for all steps; contacts flush in their passes alone
  if (!contacts_) flush.emplace();
  for (std::uint64_t i = 0; i < most_steps && time() < until && !stuck_;) {
    const bool books_path = books() && !impulse_;
    const int n = adaptive_ || books_path ? 1 : steps_at_once(most_steps - i);
    books_path ? booked_step(until) : adaptive_ ? adaptive_step(until) : n > 1 ? many_steps(n) : one_step();
    i += static_cast<std::uint64_t>(n);
  }
}

/// How many of the next steps are kernels alone, one after the other: those of a world of one block in which nothing
/// happens until then.
int World::steps_at_once(std::uint64_t most) const {
  if (!fused_ || impulse_ || implicit_ || profiling_ || !between_steps_.empty() || whole_.blocks.size() != 1) return 1;
  if (row_->family == Family::multistep) return 1;
  if (std::any_of(groups_.begin(), groups_.end(), [](const Group& g) { return g.kernel.forces.flows(); })) return 1;
  constexpr std::uint64_t longest = 256;
  double free = static_cast<double>(std::min(most, longest));
  if (next_event_ < events_.size()) free = std::min(free, (events_[next_event_].at - time()) / step_ - on_the_step);
  return std::max(1, static_cast<int>(free));
}

/// As so many single steps. If something is no longer finite they are taken once more, one by one, to tell when.
void World::many_steps(int n) {
  columns_.save(Role::state, before_);
  activate_windows(time(), step_);
  if (!fused_pass(method_, n).finite && status_.code != Status::Code::non_finite) {
    columns_.restore(Role::state, before_);
    for (int i = 0; i < n; ++i) one_step();
    return;
  }
  counters_.force_evaluations += static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(method_.phases);
  counters_.steps += static_cast<std::uint64_t>(n);
}

void World::one_step() {
  part_of_step(step_);
  act_between_steps();
  ++counters_.steps;
}

/// begin -> events of this part, each at its time -> smooth motion in between
void World::part_of_step(double length) {
  const double start = time(), margin = on_the_step * step_;
  double done = 0;
  for (; next_event_ < events_.size() && events_[next_event_].at < start + length - margin; ++next_event_) {
    const Event& event = events_[next_event_];
    const double offset = event.at - start;
    if (offset > done + margin) {
      advance(start + done, offset - done);
      done = offset;
    }
    take_effect(event);
  }
  advance(start + done, length - done);
}

/// What forces were before says nothing of what they are now.
void World::take_effect(const Event& event) {
  if (event.impulse) {
    const Impulse& impulse = *event.impulse;
    booked_jump(&LedgerBook::outside, [&] { kick(place_of(impulse.id), impulse.J, impulse.offset); });
  }
  forget_rates();
}

/// Motion over h, from the time `from`.
void World::advance(double from, double h) {
  activate_windows(from, h);
  if (impulse_) return contact_substeps(from, h);
  const bool whole = h == step_, multistep = row_->family == Family::multistep;
  if (!multistep && whole) {
    report_non_finite(smooth_motion(method_, from));  // no copy of it: that takes as long as a pass over few bodies
  } else if (!multistep) {
    report_non_finite(smooth_motion(method_over(h), from));
  } else if (!whole) {
    report_non_finite(smooth_motion(method_for(*find_row(starter_name), h), from));
  } else {
    const bool starts = known_sets_ < method_.history;
    report_non_finite(smooth_motion(starts ? starter_ : method_, from));
    known_sets_ += starts;
    turn_rates();
  }
}

Moved World::smooth_motion(const Method& method, double from) {
  set_time(from);
  if (implicit_) return implicit_step(method);
  if (fixed_point_) return fixed_point_step(method, from);
  counters_.force_evaluations += static_cast<std::uint64_t>(method.phases - method.first_known);
  return fused_ ? fused_pass(method, 1) : staged_step(method, from);
}

/// The row, scaled by the step.
Method World::method_over(double h) const {
  const Method method = method_for(*row_, h, rotation_);
  return not_differentiated_.empty() ? method : FixedPoint::phases_of(method);
}

/// contacts found -> for each substep: smooth motion as a trial -> impacts reflected -> solve -> relax
void World::contact_substeps(double from, double h) {
  const int count = impulse_->substeps;
  const double substep = h / count;
  const Method method = h == step_ ? contact_method_ : method_over(substep);
  for (int i = 0; i < count; ++i) {
    const double at = from + i * substep;
    timed("read_contacts", [&] {
      if (i == 0) impulse_->solver.sort_bodies();
      impulse_->read_start(groups_, workers_);
    });
    if (i == 0) timed("find_contacts", [&] { impulse_->solver.find(at, static_cast<Real>(h), workers_); });
    if (books()) book_->add_work(read_energy(), substep / 2);
    report_non_finite(smooth_motion(method, at));
    if (books()) book_->add_work(read_energy(), substep / 2);
    booked_jump(&LedgerBook::contacts, [&] {
      timed("read_contacts", [&] { impulse_->read_trial(groups_, workers_); });
      timed("reflect_impacts", [&] { impulse_->solver.reflect(at, static_cast<Real>(substep), workers_); });
      timed("solve_contacts", [&] { impulse_->solver.solve(workers_); });
      timed("relax_contacts", [&] { impulse_->solver.relax(workers_); });
      timed("write_contacts", [&] { impulse_->write(groups_, workers_); });
    });
  }
}

Counters World::counters() const {
  Counters all = counters_;
  if (contacts_) contacts_->add_counters(all);
  return all;
}

void World::activate_windows(double from, double h) {
  const double middle = from + h / 2;
  for (Group& group : groups_) {
    for (std::size_t e = 0; e < group.effects.size(); ++e) {
      std::vector<std::byte>& instances = group.effects[e];
      if (instances.empty()) continue;
      const EffectInfo& info = local_effects()[e];
      if (!info.window) continue;
      for (std::size_t at = 0; at < instances.size(); at += info.constants_size) {
        Window& window = *info.window(instances.data() + at);
        window.active = window.at <= middle && middle < window.until;
      }
    }
  }
}

/// Of the next step's start, for what flows.
void World::set_time(double from) {
  for (Group& group : groups_) group.kernel.forces.start = from;
}

const FamilyKernels& World::kernels_of(const Group& group, const Method& method) const {
  return kernels_->family(method.family, group.kernel.carry != nullptr);
}

Moved World::fused_pass(const Method& method, int steps) {
  return moving_pass(whole_, "fused_step", [&](const Group& group, const Block& block) {
    FusedStep* kernel = kernels_of(group, method).fused[static_cast<int>(group.motion)];
    Moved moved = kernel(group.kernel, method, block.first, block.last);
    for (int s = 1; s < steps; ++s) moved.finite = kernel(group.kernel, method, block.first, block.last).finite;
    return moved;
  });
}

/// Contacts stiffen as bodies are pressed together: a step that was stable may be so no longer.
void World::watch_contact_stiffness() {
  const PenaltyCounters& now = penalty_->penalty.counters();
  const double spring = static_cast<double>(now.spring), damping = static_cast<double>(now.damping);
  if (status_.code >= Status::Code::stability) return;
  if (spring <= 1.001 * watched_stiffness_.spring && damping <= 1.001 * watched_stiffness_.damping) return;
  watched_stiffness_ = {std::max(spring, watched_stiffness_.spring), std::max(damping, watched_stiffness_.damping)};
  judge_contacts(watched_stiffness_);
}

/// The first body in the order of ids that is not finite. Only the first such step of a run is looked at.
void World::report_non_finite(const Moved& moved) {
  if (moved.finite || status_.code == Status::Code::non_finite) return;
  std::optional<std::size_t> first;
  for (const Group& group : groups_) {
    for (std::size_t row = 0; row < group.live; ++row) {
      if (!group.presence.has(row) || is_finite(group, row)) continue;
      const std::size_t id = id_of(group, row);
      if (!first || id < *first) first = id;
    }
  }
  if (!first) return;  // values so large that their sum overflowed, each still finite
  std::string sentence = "body " + std::to_string(*first) + " is no longer finite";
  if (status_.code != Status::Code::ok) sentence += "; " + status_.sentence;
  status_ = {Status::Code::non_finite, std::move(sentence), *first, counters_.steps + 1, time() + step_};
}

/// Keeps events in the order of their times; one that is already over takes part in the next step.
void World::add_event(const Event& event) {
  const auto later = [](double at, const Event& e) { return at < e.at; };
  const auto begin = events_.begin() + static_cast<std::ptrdiff_t>(next_event_);
  events_.insert(std::upper_bound(begin, events_.end(), event.at, later), event);
}

void World::record(const char* name, double seconds) {
  for (std::size_t p = 0; p < pass_times_.size(); ++p) {
    if (pass_times_[p].name != name) continue;
    ++pass_times_[p].calls;
    pass_times_[p].seconds += seconds;
    pass_times_[p].bytes += bytes_per_call_[p];
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
