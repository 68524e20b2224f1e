// The world as it will be at a time between two steps of the run, which takes them as if nobody looked. The way there
// is gone aside, by parts of steps of the same method: as accurate as the run, whatever the method, the forces and the
// way that bodies turn, for the price of a step a look.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// A run takes a step that ends this little beyond a time, in steps.
constexpr double on_the_step = 1e-9;
/// What rounding leaves open of a time.
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();

}  // namespace

bool World::approach(double t, double end, std::uint64_t most_steps) {
  t = std::min(t, end);
  if (!adaptive_) {
    advance_to(t, most_steps);
    return time() + step_ * (1 - on_the_step) > t * (1 - rounding);
  }
  const auto there = [&] {
    const double left = elapsed_.until(t);
    return left <= 0 || (t < end && planned_step() > left);
  };
  for (std::uint64_t i = 0; i < most_steps && !stuck_; ++i) {
    if (there()) return true;
    run(1, end);
  }
  return there();
}

void World::look_ahead(double t, FunctionRef<void()> look) {
  if (!std::isfinite(t)) throw SceneError("look_ahead", fmt::format("{} s is no time; expected a finite one", t));
  const double near = adaptive_ ? 0 : rounding * t;
  if (t <= time() + near && t >= time() - near - on_the_step * step_) return look();
  if (!(t > time())) {
    throw SceneError("look_ahead",
                     fmt::format("{} s is before {} s, where the world is; expected a later time", t, time()));
  }
  const Snapshot now = snapshot();
  const Stiffness watched = watched_stiffness_;
  const bool profiling = std::exchange(profiling_, false);
  ++looks_;
  const auto come_back = [&] {
    --looks_;
    return_to(now);
    watched_stiffness_ = watched;
    profiling_ = profiling;
  };
  try {
    go_aside(t);
    look();
  } catch (...) {
    come_back();
    throw;
  }
  come_back();
}

void World::go_aside(double t) {
  if (adaptive_) return run(std::numeric_limits<std::uint64_t>::max(), t);
  step(static_cast<std::uint64_t>((t - time() + rounding * t) / step_));
  const double rest = t - time();
  if (!(rest > rounding * t)) return;
  part_of_step(rest);
  part_ += rest;
}

}  // namespace ballpark::BALLPARK_PRECISION
