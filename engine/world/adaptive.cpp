// Steps as large as a tolerance allows. A try moves the state and tells its error; if that is too large the state
// returns to where it was, and a smaller step is tried.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/world/local_step.h"
#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// The last steps to a time that must be met are made equal rather than one full and one tiny.
constexpr double nearly_there = 2;
/// Rows of a block from columns into others; those that do not exist stay out.
void copy_rows(const auto& from, const auto& to, const Block& block) {
  for (std::size_t c = 0; c < std::size(from); ++c) {
    if (from[c]) std::copy(from[c] + block.first, from[c] + padded(block.last), to[c] + block.first);
  }
}

/// The smallest step that still moves the time and, without denormals, a coefficient.
double least_step(double time) {
  const double smallest = std::max(static_cast<double>(std::numeric_limits<Real>::min()), 1e-307);
  return std::max(16 * std::numeric_limits<double>::epsilon() * time, 1e3 * smallest);
}

}  // namespace

/// To `limit` at most, in one accepted step.
void World::adaptive_step(double limit) {
  if (stuck_) return;
  due_events();
  if (next_event_ < events_.size()) limit = std::min(limit, events_[next_event_].at);
  planned_step();
  keep_carries();
  for (bool finite = true;;) {
    if (!(control_.step > least_step(time()))) return get_stuck(finite);
    const double left = elapsed_.until(limit);
    double h = duration_ > 0 ? std::min(control_.step, duration_) : control_.step;
    const bool lands = h >= left;
    if (lands) {
      h = left;
    } else if (nearly_there * h > left) {
      h = left / 2;
    }
    scale(unit_, h, method_);
    activate_windows(time(), h);
    const Moved moved = smooth_motion(method_, time());
    const double error = moved.finite ? std::max(std::sqrt(static_cast<double>(moved.over)), overstep())
                                      : std::numeric_limits<double>::infinity();
    const double planned = control_.step;
    if (control_.judge(h, error)) {
      if (lands) control_.step = std::max(control_.step, planned);  // a short step to land says little of the next
      elapsed_.advance(h, lands ? std::optional(limit) : std::nullopt);
      accept_try();
      return;
    }
    ++counters_.rejected_steps;
    finite = moved.finite;
    take_back();
  }
}

/// Penalty contacts do not see what a long step passes, and flight tells no error: no step takes a body farther than
/// its radius. As an error over the tolerance, so that the usual rule finds the next step.
double World::overstep() {
  if (!penalty_) return 0;
  const double stride = static_cast<double>(penalty_->stride(groups_, method_.step, workers_));
  double error = 1;
  for (int i = 0; i < control_.order; ++i) error *= stride;
  return error;
}

void World::due_events() {
  for (; next_event_ < events_.size() && events_[next_event_].at <= time(); ++next_event_) {
    take_effect(events_[next_event_]);
  }
}

void World::accept_try() {
  ++counters_.steps;
  method_.first_known = keeps_rates_;
  if (keeps_rates_) turn_rates();
}

/// Compensated summation: what rounding took so far, which a step that is taken back must find again.
void World::keep_carries() {
  if (std::all_of(groups_.begin(), groups_.end(), [](const Group& group) { return group.carry.empty(); })) return;
  pass(whole_, "keep_carries",
       [&](const Group& group, const Block& block) { copy_rows(group.carry, group.carry_before, block); });
}

/// The state returns to where the step began.
void World::take_back() {
  pass(whole_, "take_back", [&](const Group& group, const Block& block) {
    const StateColumns &to = group.kernel.state, &from = group.kernel.before;
    copy_rows(from.position, to.position, block);
    copy_rows(from.velocity, to.velocity, block);
    // What is carried and not integrated has not moved.
    if (group.motion != MotionKind::point) copy_rows(from.momentum, to.momentum, block);
    if (group.motion >= MotionKind::oriented) copy_rows(from.orientation, to.orientation, block);
    copy_rows(group.carry_before, group.carry, block);
  });
  if (penalty_) penalty_->penalty.take_back();
}

/// No step is small enough: the run ends here, and says why.
void World::get_stuck(bool finite) {
  stuck_ = true;
  if (!finite) {
    status_ = {Status::Code::non_finite, "forces are not finite, however small the step", 0, counters_.steps, time()};
    return;
  }
  status_ = {Status::Code::accuracy,
             "no step is small enough for run.tolerance: the run ends at " + std::to_string(time()) + " s", 0,
             counters_.steps, time()};
}

/// What is tried next.
double World::planned_step() {
  if (control_.step > 0) return control_.step;
  due_events();  // what acts from the start decides how it begins
  return control_.step = first_step();
}

/// 0.01 |y| / |y'| of the body that changes fastest. (HNW II.4, Starting step size, its first guess.)
double World::first_step() {
  scale(unit_, 1, method_);
  activate_windows(time(), 0);
  if (penalty_) penalty_->look(groups_, time(), workers_);
  evaluate_start();
  if (penalty_) penalty_->penalty.take_back();
  Real state = 0, rate = 0;
  for (const Group& group : groups_) {
    with_motion(group.motion, [&]<class M>() {
      for (std::size_t row = 0; row < group.live; ++row) {
        const auto c = M::template constants<Real>(group.kernel.constants, row);
        State<M, Real> now;
        M::load(group.kernel.state, row, now.y);
        Real values[M::size][max_errors] = {}, rates[M::size][max_errors] = {};
        for (int i = 0; i < M::size; ++i) {
          values[i][0] = now.y[i];
          rates[i][0] = group.rates[static_cast<std::size_t>(i)][row];
        }
        Method one = method_;
        one.errors = 1;
        state = std::max(state, over_tolerance(one, c, now.y, now, values));
        rate = std::max(rate, over_tolerance(one, c, now.y, now, rates));
      }
    });
  }
  const double d0 = std::sqrt(static_cast<double>(state)), d1 = std::sqrt(static_cast<double>(rate));
  const double guess = d0 > 1e-5 && d1 > 1e-5 ? 0.01 * d0 / d1 : 1e-6;
  return std::isfinite(guess) && guess > 0 ? guess : 1e-6;
}

/// Rates at the state as it is, into set 0.
void World::evaluate_start() {
  set_time(time());
  if (!fused_) {
    staged_phase(whole_, method_, 0, time());
  } else {
    pass(whole_, "evaluate", [&](const Group& group, const Block& block) {
      StepGroup at_state = group.kernel;
      at_state.trial = at_state.state;
      kernels_->evaluate[static_cast<int>(group.motion)](at_state, method_, 0, block.first, block.last);
    });
  }
  ++counters_.force_evaluations;
  method_.first_known = keeps_rates_;
}

}  // namespace ballpark::BALLPARK_PRECISION
