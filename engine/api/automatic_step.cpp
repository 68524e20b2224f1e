// The step of a scene that leaves it to the engine.
#include <algorithm>
#include <cmath>
#include <limits>

#include "ballpark/catalogue.h"
#include "ballpark/world.h"

namespace ballpark {

namespace {

/// Of the largest stable step. What is merely stable is not yet accurate; explicit discrete-element codes take 0.1 to
/// 0.2 of it.
constexpr double safety = 0.1;
/// Of the duration: a step at which limits are asked for, which do not depend on it. Long ones may be refused.
constexpr double short_enough = 1e-9;

/// The largest stable step of all that has one; 0 if something has none, infinity if nothing needs one.
StepLimitReport tightest(const Explanation& explanation) {
  StepLimitReport least{"", std::numeric_limits<double>::infinity()};
  const auto consider = [&](const std::string& whose, double largest) {
    if (largest < least.largest) least = {whose, largest};
  };
  for (const StepLimitReport& limit : explanation.step_limits) consider(limit.of, limit.largest);
  if (explanation.contact.kind == "penalty") consider("contacts", explanation.contact.largest_step);
  return least;
}

}  // namespace

double automatic_step(const Scene& scene) {
  Scene any_step = scene;
  any_step.run.automatic_step = false;
  any_step.run.step = short_enough * (scene.run.duration > 0 ? scene.run.duration : 1);
  const StepLimitReport least = tightest(World(any_step, {.threads = 1}).explain());
  if (std::isinf(least.largest)) {
    const auto row = std::find_if(integrators().begin(), integrators().end(),
                                  [&](const auto& each) { return each.name == scene.run.integrator; });
    const std::string why = row->implicit ? "limits a step of " + row->name + ", which is implicit"
                                          : "limits a step (no spring, damper or penalty contact)";
    throw SceneError("run.step", "\"auto\" finds nothing that " + why + "; expected a number > 0 [s]");
  }
  if (!(least.largest > 0)) {
    throw SceneError("run.step", "\"auto\" finds no stable step for " + scene.run.integrator + " on " + least.of +
                                     "; expected a number > 0 [s], or another integrator");
  }
  const double step = safety * least.largest;
  return scene.run.duration > 0 ? scene.run.duration / std::ceil(scene.run.duration / step) : step;
}

}  // namespace ballpark
