// The lecture's picture: Euler's path beside that of rk4 with the same step, and the true one.
#include <algorithm>

#include "perf/cost/choice.h"
#include "perf/cost/cost.h"

namespace ballpark::cost {

namespace {

constexpr std::size_t looks = 200;
constexpr double good = 0.01;  ///< of how far things go: what the eye takes for right

Path path_of(const Ground& ground, const Setting& setting, const std::string& label, std::size_t id,
             const GoOn& go_on) {
  Samples samples = samples_of(ground.scene.run.duration, 1, looks, 1);
  samples.ids = {id};
  Track track(samples);
  Subject subject(ground.scene, setting, ground.options);
  Path path{label, id, {}};
  const auto add = [&](double t, const Vector3d& x) { path.points.push_back({t, x.x(), x.y(), x.z()}); };
  add(0, subject.world().body(id).position);
  subject.follow(samples, track, go_on);
  for (std::size_t k = 0; k < looks; ++k) {
    if (track.known[k]) add(samples.times[k], track.states[k].position);
  }
  return path;
}

const Curve* curve_of(const Result& result, const std::string& label) {
  for (const Curve& curve : result.curves) {
    if (curve.label == label) return &curve;
  }
  return nullptr;
}

/// The coarsest of the curve that is good to the eye.
const Point* good_point(const Result& result, const Curve& curve) {
  for (const std::size_t i : curve.points) {
    const Point& point = result.points[i];
    if (counts(point) && point.error < good * 10 * result.ceiling) return &point;
  }
  return nullptr;
}

/// The body that this setting takes farthest from where it belongs.
std::size_t most_wrong(const Ground& ground, const Setting& setting, const GoOn& go_on) {
  Track track(ground.samples);
  Subject subject(ground.scene, setting, ground.options);
  subject.follow(ground.samples, track, go_on);
  const std::size_t bodies = ground.samples.ids.size();
  double most = -1;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < track.states.size(); ++i) {
    if (!track.known[i / bodies]) continue;
    const double off = (track.states[i].position - ground.reference.track.states[i].position).norm();
    if (!(off > most)) continue;
    most = off;
    worst = ground.samples.ids[i % bodies];
  }
  return worst;
}

}  // namespace

void add_paths(const Ground& ground, Result& result, const GoOn& go_on) {
  const Curve *euler = curve_of(result, "euler"), *rk4 = curve_of(result, "rk4");
  if (!euler || !rk4 || result.quantity != Quantity::position) return;
  const Point* right = good_point(result, *rk4);
  std::size_t finest = result.points.size();
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    if (result.points[i].front &&
        (finest == result.points.size() || result.points[i].error < result.points[finest].error)) {
      finest = i;
    }
  }
  if (!right || finest == result.points.size()) return;
  Setting wrong = right->setting;
  wrong.integrator = "euler";
  const std::size_t id = most_wrong(ground, wrong, go_on);
  result.paths.push_back(
      path_of(ground, result.points[finest].setting, "reference: " + text(result.points[finest].setting), id, go_on));
  result.paths.push_back(path_of(ground, right->setting, text(right->setting), id, go_on));
  result.paths.push_back(path_of(ground, wrong, text(wrong), id, go_on));
}

}  // namespace ballpark::cost
