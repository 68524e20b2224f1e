#include "perf/cost/order.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ballpark/catalogue.h"
#include "perf/timing.h"

namespace ballpark::cost {

namespace {

using perf::seconds_now;

/// Errors this small, over the scene's scale, show rounding rather than the method.
constexpr double rounding = 1e-13;
/// Of how far things go: larger errors show nothing of a method's order.
constexpr double sensible = 0.05;

/// Two slopes in a row this near to each other are a power law.
constexpr double alike = 0.12;
/// Slopes below it are rounding's.
constexpr double falling = 0.3;

/// Of the slopes down to the error `least`: the finest two in a row that agree, else the two that agree best.
std::optional<double> settled(const ObservedOrder& order, double least) {
  std::optional<double> best;
  double closest = std::numeric_limits<double>::infinity();
  for (std::size_t k = order.slopes.size(); k-- > 1;) {
    const double finer = order.slopes[k], coarser = order.slopes[k - 1], apart = std::abs(finer - coarser);
    if (order.errors[k + 1] < least || !std::isfinite(finer) || finer < falling || coarser < falling ||
        apart >= closest)
      continue;
    closest = apart;
    best = (finer + coarser) / 2;
    if (apart < alike) break;
  }
  return best;
}

/// Halves the step until rounding or the time ends it.
ObservedOrder halved(const Ground& ground, const IntegratorDescription& row, double seconds, const GoOn& go_on) {
  ObservedOrder order{row.name, row.order, {}, {}, {}, {}, ""};
  Setting setting = setting_of(ground.scene);
  setting.integrator = row.name;
  setting.tolerance = 0;
  setting.precision = Precision::double_;
  const double scale = ground.about.reference.scale[static_cast<std::size_t>(ground.measure.quantity)];
  const double least = std::max(ground.about.floor, rounding * scale);
  const double begin = seconds_now();
  double last = 0;
  for (auto steps = static_cast<double>(ground.samples.times.size()); go_on(); steps *= 2) {
    if (seconds_now() - begin + 4.4 * last > seconds && order.errors.size() > 2) break;
    setting.step = ground.scene.run.duration / steps;
    if (!check(scene_with(ground.scene, setting)).empty()) break;
    const Point point = measured_point(ground, setting, go_on);
    last = point.seconds.minimum;
    order.trouble = point.trouble;
    if (!point.trouble.empty() || point.error > sensible * scale) {
      if (seconds_now() - begin > seconds) break;
      continue;
    }
    order.steps.push_back(setting.step);
    order.errors.push_back(point.error);
    if (point.error < least || point.error == 0) break;
  }
  for (std::size_t k = 1; k < order.errors.size(); ++k) {
    order.slopes.push_back(std::log2(order.errors[k - 1] / order.errors[k]));
  }
  order.observed = settled(order, least);
  if (!order.errors.empty()) order.trouble.clear();
  return order;
}

}  // namespace

std::optional<OrderStudy> observed_orders(const Scene& scene, const Request& request, const Progress& progress) {
  const GroundRequest wanted{request.measure, request.reference, request.seconds / 4, {}, request.options};
  const auto ground = ground_for(scene, wanted, [&] { return progress("reference", 1); });
  if (!ground) return std::nullopt;
  OrderStudy study{ground->about, {}};
  Axes axes = request.axes;
  axes.precisions = {Precision::double_};
  axes.steps = {ground->samples.times.front()};
  if (axes.integrators.empty()) {
    for (const IntegratorDescription& row : integrators()) axes.integrators.push_back(row.name);
  }
  if (axes.rotations.empty()) axes.rotations = {ground->scene.run.rotation};
  axes.contacts = {setting_of(ground->scene).contact};
  axes.openings = {setting_of(ground->scene).opening_angle};
  const std::vector<Candidate> list = candidates(ground->scene, axes, 1, study.about.left_out);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const GoOn go_on = [&] { return progress("sweep", static_cast<double>(i) / static_cast<double>(list.size())); };
    const auto& rows = integrators();
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](auto& r) { return r.name == list[i].curve.integrator; });
    study.rows.push_back(halved(*ground, *row, 0.75 * request.seconds / static_cast<double>(list.size()), go_on));
    if (!go_on()) return std::nullopt;
  }
  return study;
}

}  // namespace ballpark::cost
