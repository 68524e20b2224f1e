// How long a trajectory means something: two runs that start almost alike, and how fast they part.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/horizon.h"

namespace ballpark::cost {

namespace {

constexpr double nudge = 1e-10;  ///< relative change of the twin's start
constexpr std::size_t looks = 200;

/// Largest distance of the bodies of two worlds.
double apart(const World& a, const World& b) {
  const std::size_t bodies = a.body_count(), stride = std::max<std::size_t>(1, bodies / 500);
  double most = 0;
  for (std::size_t id = 0; id < bodies; id += stride) {
    most = std::max(most, (a.body(id).position - b.body(id).position).norm());
  }
  return most;
}

/// To the time, in pieces. False if it was stopped, or gets no farther.
bool advance(World& world, double t, const GoOn& go_on) {
  const std::uint64_t steps = steps_at_once(world.body_count());
  while (world.time() < t) {
    const double before = world.time();
    world.advance_to(t, steps);
    if (!go_on()) return false;
    if (world.time() == before) break;  // within a step of it
  }
  return world.status().code == Status::Code::ok;
}

/// Numerical instability must not pass for chaos: as accurate as the scene allows.
Scene accurately(const Scene& scene) {
  Setting setting = setting_of(scene);
  setting.integrator = "dormand_prince8";
  setting.step = 0;
  setting.tolerance = 1e-10;
  setting.precision = Precision::double_;
  const Scene accurate = scene_with(scene, allowed(scene, setting));
  return check(accurate).empty() ? accurate : scene;
}

/// Least-squares line y = a + b x: b and its standard error.
std::pair<double, double> slope(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, rest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  const double b = xy / xx;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = y[i] - mean_y - b * (x[i] - mean_x);
    rest += off * off;
  }
  return {b, std::sqrt(rest / std::max(n - 2, 1.0) / xx)};
}

}  // namespace

std::optional<Horizon> find_horizon(const Scene& scene, const Options& options, const GoOn& go_on, double growth) {
  Options nudged = options;
  nudged.perturb = nudge;
  const Scene accurate = accurately(scene);
  World world(accurate, options), twin(accurate, nudged);
  const double duration = scene.run.duration;
  double first = apart(world, twin), last = 0;
  std::vector<double> times{0}, logs{0};
  for (std::size_t k = 1; k <= looks && logs.back() < std::log(growth); ++k) {
    last = duration * static_cast<double>(k) / looks;
    if (!advance(world, last, go_on) || !advance(twin, last, go_on)) return std::nullopt;
    const double now = apart(world, twin);
    if (first == 0) first = now;  // velocities alone were nudged
    if (!(now > first) || !std::isfinite(now)) continue;
    times.push_back(last);
    logs.push_back(std::log(now / first));
  }
  if (logs.back() < std::log(growth)) return std::nullopt;  // twins stay together to the end
  const auto [rate, error] = slope(times, logs);
  Horizon horizon{last, 1 / rate, error / (rate * rate), growth, ""};
  horizon.sentence = fmt::format(
      "Chaotic: runs that start a relative {:g} apart are {:.0e} times farther apart at {:.3g} s (Lyapunov time "
      "{:.2g} s, +- {:.1g} s). {}",
      nudge, std::exp(logs.back()), last, horizon.lyapunov_time, horizon.uncertainty,
      growth < lost ? "Then errors of steps reach the size of the path, and no run can be their reference."
                    : "Beyond that horizon no path means anything.");
  return horizon;
}

}  // namespace ballpark::cost
