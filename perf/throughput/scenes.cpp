#include "perf/throughput/scenes.h"

namespace ballpark::perf {

namespace {

constexpr double gravity = 9.81, mass = 0.5, drag = 0.01, step = 1e-4;

BodyGroup scattered(std::size_t bodies) {
  BodyGroup group;
  group.name = "bodies";
  group.mass = {mass};
  group.generate = Generate{};
  group.generate->kind = "random";
  group.generate->count = {bodies};
  group.generate->upper = Vector3d(100, 100, 100);
  group.generate->velocity_spread = Vector3d(20, 20, 20);
  return group;
}

Scene scene_of(BodyGroup group, const std::string& integrator) {
  Scene scene;
  scene.run.step = step;
  scene.run.integrator = integrator;
  scene.bodies = {std::move(group)};
  scene.effects = {{.kind = "gravity", .groups = {}, .parameters = {{"acceleration", Vector3d(0, 0, -gravity)}}}};
  return scene;
}

}  // namespace

Scene falling_particles(std::size_t bodies, const std::string& integrator) {
  Scene scene = scene_of(scattered(bodies), integrator);
  scene.effects.push_back({.kind = "quadratic_drag", .groups = {}, .parameters = {{"coefficient", drag}}});
  return scene;
}

Effect force_that_is_over() {
  return {.kind = "force", .groups = {}, .parameters = {{"force", Vector3d(1, 2, 3)}, {"at", -1.0}, {"until", 0.0}}};
}

Scene tumbling_bodies(std::size_t bodies) {
  BodyGroup group = scattered(bodies);
  group.inertia = {Vector3d(1e-4, 2e-4, 2.5e-4)};
  group.generate->random_orientation = true;
  group.generate->angular_velocity_spread = Vector3d(10, 10, 10);
  return scene_of(std::move(group), "rk4");
}

Scene falling_spheres(std::size_t bodies) {
  BodyGroup group = scattered(bodies);
  group.shape = "sphere";
  group.radius = {0.05};
  return scene_of(std::move(group), "rk4");
}

Start start_of_falling_particles(std::size_t bodies) {
  return {.problem = {.gravity = gravity, .drag_over_mass = drag / mass, .step = step},
          .columns = state_of(World(falling_particles(bodies)))};
}

}  // namespace ballpark::perf
