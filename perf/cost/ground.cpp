#include "perf/cost/ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/horizon.h"
#include "perf/machine.h"
#include "perf/timing.h"

namespace ballpark::cost {

namespace {

using perf::seconds_now;

constexpr std::size_t usual_looks = 20, most_bodies = 256;

/// Do positions change along the path, or do bodies only turn?
Measure natural_measure(const Ground& ground, const std::string& which) {
  const auto size = size_of(ground.reference.track);
  const bool moves = size[1] * ground.scene.run.duration > 1e-9 * size[0];
  return {moves || size[3] == 0 ? Quantity::position : Quantity::orientation, which};
}

std::string sentence(const Measure& measure, bool all) {
  const std::string whom = all ? "all bodies" : "the bodies compared";
  const std::string what = std::string(name(measure.quantity)) + " error";
  if (measure.which == "end") return what + " at the end, of the body that is farthest off";
  if (measure.which == "rms") return "root mean square of the " + what + " along the path, over " + whom;
  return "largest " + what + " along the path, of " + whom;
}

/// A noise that is another one at each step leaves paths without a limit, and who is not there has none.
void refuse_pathless(const Scene& scene) {
  for (std::size_t i = 0; i < scene.effects.size(); ++i) {
    const std::string& kind = scene.effects[i].kind;
    const auto refuse = [&](const std::string& why) {
      throw SceneError(fmt::format("effects[{}].kind", i), why + "; expected a scene without it");
    };
    if (kind == "thermostat") {
      refuse("a thermostat's noise is another one for each step: paths have no limit to hold errors against");
    }
    if (kind == "emitter" || kind == "outlet" || kind == "absorbing_wall") {
      refuse(kind + ": bodies enter or leave when a step ends, so that their paths have gaps to compare");
    }
  }
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

/// Equal parts of the duration that whole steps fill, of the scene and of those asked for: 20 if that is possible.
std::size_t look_count(const Scene& scene, const std::vector<double>& steps) {
  std::vector<std::uint64_t> counts;
  for (const double step : steps) counts.push_back(steps_in(scene.run.duration, step));
  if (steps.empty() && scene.run.step > 0) counts.push_back(steps_in(scene.run.duration, scene.run.step));
  for (const std::size_t looks : {20, 25, 24, 16, 30, 32, 18, 15, 40, 12, 10, 22, 21, 28, 27, 14, 9, 8}) {
    if (std::all_of(counts.begin(), counts.end(), [&](auto n) { return n % looks == 0; })) return looks;
  }
  return usual_looks;
}

void look_at(Ground& ground, const GroundRequest& request) {
  const World world(ground.scene, ground.options);
  Samples& samples = ground.samples;
  samples =
      samples_of(ground.scene.run.duration, world.body_count(), look_count(ground.scene, request.steps), most_bodies);
  samples.events = request.events;
  for (const std::size_t id : samples.ids) samples.start.push_back(world.body(id));
  ground.about.compared = samples.ids.size();
}

/// Where runs part, only the first part of the duration can be compared: a whole fraction of it, so that its steps fill
/// the whole of it too.
void stay_inside_horizon(Ground& ground, const GroundRequest& request, const GoOn& go_on, double growth) {
  Result& about = ground.about;
  about.horizon = find_horizon(ground.scene, ground.options, go_on, growth);
  if (!about.horizon) return;
  double& duration = ground.scene.run.duration;
  duration /= std::ceil(duration / about.horizon->time);
  about.duration = duration;
  look_at(ground, request);
}

void settle_measure(Ground& ground, const GroundRequest& request) {
  ground.measure = request.measure.value_or(natural_measure(ground, request.which));
  const auto quantity = static_cast<std::size_t>(ground.measure.quantity);
  Result& about = ground.about;
  about.reference = ground.reference.about;
  about.events = ground.reference.track.events;
  about.quantity = ground.measure.quantity;
  about.which = ground.measure.which;
  about.measure = sentence(ground.measure, about.compared == about.bodies);
  about.measure_unit = unit(ground.measure.quantity);
  about.floor = 10 * about.reference.error_bar[quantity];
  about.ceiling = std::max(about.floor, 0.1 * about.reference.scale[quantity]);
}

/// Takes the reference, unless it may itself be wrong by more than such a share of how far things go.
bool refer(Ground& ground, std::optional<ReferenceTrack> reference, const GroundRequest& request, double share) {
  if (!reference) return false;
  ground.reference = std::move(*reference);
  settle_measure(ground, request);
  const auto quantity = static_cast<std::size_t>(ground.measure.quantity);
  return ground.about.floor <= 10 * share * ground.about.reference.scale[quantity];
}

/// A numerical one; before a horizon only as far as runs agree, whose own errors grow too.
bool refer_to_runs(Ground& ground, const GroundRequest& request, const GoOn& go_on) {
  constexpr int most_halvings = 4;
  constexpr double agreed = 0.01;
  const auto find = request.reference == "runs" ? finest_runs : numerical_reference;
  std::optional<Horizon>& horizon = ground.about.horizon;
  double& duration = ground.scene.run.duration;
  int halvings = 0;
  while (true) {
    const bool last = !horizon || halvings == most_halvings;
    const double seconds = halvings == 0 ? request.seconds : request.seconds / most_halvings;
    if (refer(ground, find(ground.scene, ground.samples, ground.options, seconds, go_on), request, last ? 1 : agreed)) {
      break;
    }
    if (last || !go_on()) return false;
    ++halvings;
    duration /= 2;
    ground.about.duration = duration;
    look_at(ground, request);
  }
  if (horizon) {
    horizon->sentence += fmt::format(" Paths are compared over the first {:.3g} of {:.3g} s{}.", duration, ground.whole,
                                     halvings > 0 ? ", as far as two fine runs agree" : "");
  }
  return true;
}

}  // namespace

std::optional<Ground> ground_for(const Scene& scene, const GroundRequest& request, const GoOn& go_on) {
  refuse_pathless(scene);
  Ground ground;
  ground.scene = scene;
  ground.whole = scene.run.duration;
  ground.options = request.options;
  ground.options.precision.reset();
  describe(ground);
  look_at(ground, request);
  if (request.reference == "best") {
    if (auto exact = closed_form(scene, ground.samples, ground.options)) {
      return refer(ground, std::move(exact), request, 1) ? std::optional(std::move(ground)) : std::nullopt;
    }
  }
  const double end = seconds_now() + request.seconds / 2;
  const GoOn in_time = [&] { return go_on() && seconds_now() < end; };
  stay_inside_horizon(ground, request, in_time, lost);
  if (!ground.about.horizon && seconds_now() >= end) {
    ground.about.left_out.push_back("whether runs part (chaos), and how soon: for want of time (more: --seconds)");
  }
  if (refer_to_runs(ground, request, go_on)) return ground;
  // Errors of a low order are the larger nudge: they grow to the size of the path first.
  if (ground.about.horizon || !go_on()) return std::nullopt;
  stay_inside_horizon(ground, request, go_on, std::sqrt(lost));
  if (!ground.about.horizon || !refer_to_runs(ground, request, go_on)) return std::nullopt;
  return ground;
}

}  // namespace ballpark::cost
