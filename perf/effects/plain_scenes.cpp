// The plainest bodies that an effect acts on.
#include <cmath>

#include "perf/effects/prices.h"
#include "perf/effects/sample.h"

namespace ballpark::cost {

namespace {

constexpr double step = 1e-4;  ///< [s]
constexpr double side = 100;   ///< of the cube that bodies are spread in [m]

/// Of forces that end: within it, each body has some fifty others, as in a liquid.
double cutoff_among(std::size_t bodies) {
  constexpr double others = 50, four_thirds_pi = 4.18879;
  return side * std::cbrt(others / (four_thirds_pi * static_cast<double>(bodies)));
}

BodyGroup particles(std::size_t bodies) {
  BodyGroup group;
  group.name = "bodies";
  group.mass = {0.5};
  group.generate = Generate{};
  group.generate->kind = "random";
  group.generate->count = {bodies};
  group.generate->upper = Vector3d(side, side, side);
  group.generate->velocity_spread = Vector3d(20, 20, 20);
  return group;
}

BodyGroup balls(std::size_t bodies) {
  BodyGroup group = particles(bodies);
  group.shape = "sphere";
  group.radius = {0.05};
  group.generate->angular_velocity_spread = Vector3d(10, 10, 10);
  return group;
}

BodyGroup rigid_bodies(std::size_t bodies) {
  BodyGroup group = particles(bodies);
  group.inertia = {Vector3d(1e-4, 2e-4, 2.5e-4)};
  group.generate->angular_velocity_spread = Vector3d(10, 10, 10);
  group.generate->random_orientation = true;
  return group;
}

struct Kind {
  const char* name;
  BodyGroup (*group)(std::size_t bodies);
};
constexpr Kind kinds[] = {{"particles", particles}, {"balls", balls}, {"rigid bodies", rigid_bodies}};

}  // namespace

std::optional<PlainScenes> plain_scenes(const EffectDescription& effect, std::size_t bodies, std::uint64_t steps,
                                        std::string& why) {
  for (const Kind& kind : kinds) {
    PlainScenes scenes{.bodies = kind.name};
    scenes.without.run.step = step;
    scenes.without.run.duration = step * static_cast<double>(steps);
    scenes.without.run.integrator = "rk4";
    scenes.without.bodies = {kind.group(bodies)};
    scenes.with = scenes.without;
    scenes.with.effects = {perf::sample_of(effect, bodies)};
    std::map<std::string, Value>& parameters = scenes.with.effects[0].parameters;
    if (parameters.count("cutoff") > 0) parameters["cutoff"] = cutoff_among(bodies);
    const std::vector<Problem> problems = check(scenes.with);
    if (problems.empty()) return scenes;
    why = problems.front().path + ": " + problems.front().message;
  }
  return std::nullopt;
}

}  // namespace ballpark::cost
