#include "perf/cost/ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/horizon.h"
#include "perf/machine.h"

namespace ballpark::cost {

namespace {

constexpr std::size_t look_count = 20, most_bodies = 256;

/// Do positions change along the path, or do bodies only turn?
Measure natural_measure(const Track& track) {
  const std::size_t bodies = track.states.size() / track.known.size();
  for (std::size_t i = bodies; i < track.states.size(); ++i) {
    const Vector3d &now = track.states[i].position, &before = track.states[i - bodies].position;
    if ((now - before).norm() > 1e-9 * std::max(1.0, now.norm())) return {Quantity::position, "maximum"};
  }
  const bool turns = std::any_of(track.states.begin(), track.states.end(), [](auto& s) { return s.has_orientation; });
  return {turns ? Quantity::orientation : Quantity::velocity, "maximum"};
}

std::string sentence(const Measure& measure) {
  const std::string what = std::string(name(measure.quantity)) + " error";
  if (measure.which == "end") return what + " at the end, of the body that is farthest off";
  if (measure.which == "rms") return "root mean square of the " + what + " along the path, over all bodies";
  return "largest " + what + " along the path, of all bodies";
}

/// What can be said of the scene at once.
void describe(Ground& ground) {
  const World world(ground.scene, ground.options);
  Result& about = ground.about;
  about.scenario = ground.scene.name;
  about.doc = ground.scene.doc;
  about.bodies = world.body_count();
  about.duration = ground.scene.run.duration;
  about.threads = world.threads();
  about.machine = perf::machine().processor;
  about.scene_setting = setting_of(ground.scene);
}

void look_at(Ground& ground) {
  ground.samples = samples_of(ground.scene.run.duration, ground.about.bodies, look_count, most_bodies);
  ground.about.compared = ground.samples.ids.size();
}

/// Where runs part, only the first part of the duration can be compared: a whole fraction of it, which steps that
/// fill it fill too.
void stay_inside_horizon(Ground& ground, const GoOn& go_on) {
  Result& about = ground.about;
  about.horizon = find_horizon(ground.scene, ground.options, go_on);
  if (!about.horizon) return;
  double& duration = ground.scene.run.duration;
  const double whole = duration;
  duration /= std::ceil(duration / about.horizon->time);
  about.horizon->sentence += fmt::format(" Compared: the first {:.3g} of {:.3g} s.", duration, whole);
  about.duration = duration;
  look_at(ground);
}

void settle_measure(Ground& ground, const std::optional<Measure>& asked) {
  ground.measure = asked ? *asked : natural_measure(ground.reference.track);
  const auto quantity = static_cast<std::size_t>(ground.measure.quantity);
  Result& about = ground.about;
  about.reference = ground.reference.about;
  about.quantity = ground.measure.quantity;
  about.which = ground.measure.which;
  about.measure = sentence(ground.measure);
  about.measure_unit = unit(ground.measure.quantity);
  about.floor = 10 * about.reference.error_bar[quantity];
  about.ceiling = std::max(about.floor, 0.1 * about.reference.scale[quantity]);
}

}  // namespace

std::optional<Ground> ground_for(const Scene& scene, const GroundRequest& request, const GoOn& go_on) {
  Ground ground;
  ground.scene = scene;
  ground.options = request.options;
  ground.options.precision.reset();
  describe(ground);
  look_at(ground);
  std::optional<ReferenceTrack> reference;
  if (request.reference == "best") reference = closed_form(scene, ground.samples, ground.options);
  if (!reference) {
    stay_inside_horizon(ground, go_on);
    const auto find = request.reference == "runs" ? finest_runs : numerical_reference;
    reference = find(ground.scene, ground.samples, ground.options, request.seconds, go_on);
  }
  if (!reference) return std::nullopt;
  ground.reference = std::move(*reference);
  settle_measure(ground, request.measure);
  return ground;
}

}  // namespace ballpark::cost
