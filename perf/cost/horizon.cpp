// How long a trajectory means something: two runs that start almost alike, and how fast they part.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/horizon.h"

namespace ballpark::cost {

namespace {

constexpr double nudge = 1e-10;  ///< relative change of the twin's start
constexpr double lost = 1e8;     ///< growth that takes half of double's digits
constexpr std::size_t looks = 200;

/// Largest distance of the twins' bodies.
double apart(const World& twins) {
  const std::size_t bodies = twins.body_count() / 2, stride = std::max<std::size_t>(1, bodies / 500);
  double most = 0;
  for (std::size_t id = 0; id < bodies; id += stride) {
    most = std::max(most, (twins.body(id).position - twins.body(id + bodies).position).norm());
  }
  return most;
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

std::optional<Horizon> find_horizon(const Scene& scene, const Options& options, const GoOn& go_on) {
  Options twins = options;
  twins.copies = 2;
  twins.perturb = nudge;
  twins.precision.reset();
  World world(scene, twins);
  const double duration = scene.run.duration, first = apart(world);
  if (!(first > 0)) return std::nullopt;
  std::vector<double> times, logs;
  double last = 0;
  for (std::size_t k = 1; k <= looks && go_on(); ++k) {
    const double t = duration * static_cast<double>(k) / looks;
    while (world.time() < t - 1e-9 * duration && go_on()) {
      const double before = world.time();
      world.advance_to(t, 1000);
      if (world.time() == before) break;
    }
    const double growth = apart(world) / first;
    if (!std::isfinite(growth)) break;
    last = t;
    if (growth > 1) {
      times.push_back(t);
      logs.push_back(std::log(growth));
    }
    if (growth > lost) break;
  }
  if (logs.empty() || logs.back() < std::log(lost)) return std::nullopt;  // twins stay together to the end
  times.insert(times.begin(), 0);
  logs.insert(logs.begin(), 0);
  const auto [rate, error] = slope(times, logs);
  Horizon horizon{last, 1 / rate, error / (rate * rate), ""};
  horizon.sentence = fmt::format(
      "Chaotic: runs that start a relative {:g} apart are {:.0e} times farther apart at {:.3g} s (Lyapunov time "
      "{:.2g} s, +- {:.1g} s). Beyond that horizon no path means anything.",
      nudge, std::exp(logs.back()), last, horizon.lyapunov_time, horizon.uncertainty);
  return horizon;
}

}  // namespace ballpark::cost
