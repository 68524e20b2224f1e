// What goes wrong in a run is said, and hurts nobody else.
#include <cmath>
#include <limits>

#include "tests/catch.h"
#include "tests/determinism/body_bits.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::Path;
using ballpark::Precision;
using ballpark::Status;
using ballpark::World;

namespace {

/// Bodies 0 to 99 about a centre of attraction; body `doomed` falls straight into it, at its third step.
Scene through_the_centre(std::size_t doomed, bool dooms) {
  Scene scene = scene_of({particles("p", 100)}, {effect("central_gravity", {{"strength", 1e-300}})});
  scene.run.integrator = "semi_implicit_euler";
  if (dooms) {
    scene.bodies[0].position[doomed] = {3 * scene.run.step, 0, 0};
    scene.bodies[0].velocity[doomed] = {-1, 0, 0};
  }
  return scene;
}

Scene spring_scene(double stiffness, double step, const std::string& integrator) {
  Scene scene =
      scene_of({particles("p", 2)}, {effect("spring", {{"anchor", Vector3d(0, 0, 0)}, {"stiffness", stiffness}})});
  scene.bodies[0].mass = {1};
  scene.run.step = step;
  scene.run.integrator = integrator;
  return scene;
}

double limit_of(const std::string& integrator) {
  for (const ballpark::IntegratorDescription& row : ballpark::integrators()) {
    if (row.name == integrator) return row.imaginary_limit;
  }
  return 0;
}

}  // namespace

TEST_CASE("Status: the first body, step and time that are not finite are named, and no other body changes",
          "[status]") {
  for (const Path path : {Path::fused, Path::staged}) {
    for (const std::size_t doomed : {0u, 41u, 99u}) {
      World sick(through_the_centre(doomed, true), {.path = path});
      World well(through_the_centre(doomed, false), {.path = path});
      CAPTURE(doomed);
      sick.step(3);
      CHECK(sick.status().code == Status::Code::ok);
      sick.step(7);
      well.step(10);
      CHECK(sick.status().code == Status::Code::non_finite);
      CHECK(sick.status().body == doomed);
      CHECK(sick.status().step == 4);
      CHECK(sick.status().time == 4 * sick.time() / 10);
      CHECK(sick.status().sentence == "body " + std::to_string(doomed) + " is no longer finite");
      CHECK(sick.totals().non_finite_bodies == 1);
      CHECK(std::isfinite(sick.totals().energy()));
      for (std::size_t id = 0; id < 100; ++id) {
        CHECK((body_bits::of(sick, id) == body_bits::of(well, id)) == (id != doomed));
      }
    }
  }
}

TEST_CASE("Status: of several bodies the one of least id, whatever the rows", "[status]") {
  BodyGroup turning = bricks("b", 3), still = particles("p", 3);  // particles have the first rows
  turning.position[1] = still.position[0] = {0, 0, 0};
  World world(scene_of({turning, still}, {effect("central_gravity", {{"strength", 1.0}})}), {.copies = 2});
  world.step();
  CHECK(world.status().code == Status::Code::non_finite);
  CHECK(world.status().body == 1);
  CHECK(world.status().step == 1);
  CHECK(world.totals().non_finite_bodies == 4);
}

TEST_CASE("Status: large numbers whose sum overflows are still finite", "[status]") {
  Scene scene = scene_of({particles("p", 1)});
  scene.bodies[0].position = {{1.5e308, 1.5e308, 1.5e308}};
  World world(scene);
  world.step(2);
  CHECK(world.status().code == Status::Code::accuracy);  // too far out for its speed, and that is all
}

TEST_CASE("Status: the hash of a state that is not finite is the same for all targets and paths", "[status]") {
  const auto hash = [](const Options& options) {
    World world(through_the_centre(41, true), options);
    world.step(10);
    return world.state_hash();
  };
  for (const Precision precision : {Precision::single_, Precision::double_}) {
    const std::uint64_t expected = hash({.target = "base", .precision = precision});
    for (const ballpark::NamedDescription& target : ballpark::targets()) {
      if (!target.available) continue;
      CHECK(hash({.target = target.name, .precision = precision}) == expected);
      CHECK(hash({.target = target.name, .precision = precision, .path = Path::staged}) == expected);
    }
  }
}

TEST_CASE("Status: a step beyond the stability limit is reported with the limit", "[status]") {
  const double omega = 2000;
  for (const std::string integrator : {"rk4", "semi_implicit_euler", "velocity_verlet"}) {
    const double limit = limit_of(integrator) / omega;
    CAPTURE(integrator, limit);
    CHECK(World(spring_scene(omega * omega, 0.99 * limit, integrator)).status().code == Status::Code::ok);
    const World beyond(spring_scene(omega * omega, 1.01 * limit, integrator));
    CHECK(beyond.status().code == Status::Code::stability);
    CHECK(contains(beyond.status().sentence, "the stability limit of " + integrator + " on group p"));
    char number[32];
    std::snprintf(number, sizeof number, "exceeds %g s", limit);
    CHECK(contains(beyond.status().sentence, number));
  }
}

TEST_CASE("Status: single precision has the same limits as double", "[status]") {
  for (const ballpark::IntegratorDescription& integrator : ballpark::integrators()) {
    for (const double z : {0.05, 0.2, 1.0, 1.9, 2.1, 2.9}) {
      Scene scene = spring_scene(100, z / 10, integrator.name);
      scene.run.duration = 10 * scene.run.step;
      CAPTURE(integrator.name, z);
      const World wide(scene), narrow(scene, {.precision = Precision::single_});
      CHECK(wide.status().code == narrow.status().code);
    }
  }
}

TEST_CASE("Status: growth at any step is reported when the run makes it matter", "[status]") {
  Scene scene = spring_scene(100, 0.001, "euler");
  scene.run.duration = 0.001;
  CHECK(World(scene).status().code == Status::Code::ok);
  scene.run.duration = 10;
  const World grows(scene);
  CHECK(grows.status().code == Status::Code::stability);
  CHECK(contains(grows.status().sentence, "no step is stable for euler on group p"));
}

TEST_CASE("Status: the lightest body sets the limit, damping has one too", "[status]") {
  Scene scene = spring_scene(100, 0.25, "velocity_verlet");
  CHECK(World(scene).status().code == Status::Code::stability);
  scene.run.step = 0.19;
  CHECK(World(scene).status().code == Status::Code::ok);
  scene.bodies[0].mass = {1, 0.5};
  CHECK(World(scene).status().code == Status::Code::stability);
  Scene drag = scene_of({particles("p", 1)}, {effect("linear_drag", {{"coefficient", 200.0}})});
  drag.bodies[0].mass = {1};
  drag.run.step = 0.0099;
  drag.run.integrator = "midpoint";
  CHECK(World(drag).status().code == Status::Code::ok);
  drag.run.step = 0.0101;
  CHECK(World(drag).status().code == Status::Code::stability);
}

TEST_CASE("Status: a step too long for the nearest point of an orbit is reported before the run", "[status]") {
  Scene scene = scene_of({particles("p", 1)}, {effect("central_gravity", {{"strength", 1.0}})});
  scene.bodies[0].position = {{1.999, 0, 0}};  // apocentre of e = 0.999, a = 1
  scene.bodies[0].velocity = {{0, std::sqrt(0.001 / 1.999), 0}};
  const double swing = std::pow(0.001, 1.5);  // sqrt(r^3 / mu) at the pericentre, 0.001
  const auto status = [&](const std::string& integrator, double step, double duration) {
    scene.run.integrator = integrator, scene.run.step = step, scene.run.duration = duration;
    return World(scene).status();
  };
  for (const std::string integrator : {"rk4", "velocity_verlet"}) {
    const double limit = limit_of(integrator) * swing;
    CAPTURE(integrator, limit);
    CHECK(status(integrator, 0.99 * limit, 4).code == Status::Code::ok);
    CHECK(status(integrator, 1.01 * limit, 4).code == Status::Code::stability);
    CHECK(status(integrator, 1.01 * limit, 3.1).code == Status::Code::ok);  // half a turn takes pi
  }
  CHECK(status("euler", 1.01 * swing, 4).code == Status::Code::stability);
  CHECK(contains(status("rk4", 1e-3, 4).sentence, "at the nearest point of the orbit of body 0, at 0.001 m"));
  scene.bodies[0].position.insert(scene.bodies[0].position.begin(), {1, 0, 0});
  scene.bodies[0].velocity.insert(scene.bodies[0].velocity.begin(), {0, 1, 0});
  CHECK(status("rk4", 1e-3, 4).body == 1);
  scene.effects[0].parameters["softening"] = 0.5;
  CHECK(status("rk4", 1e-3, 4).code == Status::Code::ok);
  scene.effects = {effect("mutual_gravity", {{"strength", 0.25}})};
  scene.bodies[0].mass = {1, 3};
  scene.bodies[0].position = {{-0.75 * 1.999, 0, 0}, {0.25 * 1.999, 0, 0}};
  const double v = std::sqrt(0.001 / 1.999);
  scene.bodies[0].velocity = {{0, -0.75 * v, 0}, {0, 0.25 * v, 0}};
  const double limit = limit_of("rk4") * swing;
  CHECK(status("rk4", 0.99 * limit, 4).code == Status::Code::ok);
  CHECK(status("rk4", 1.01 * limit, 4).code == Status::Code::stability);
}

TEST_CASE("Status: what flies by without a turn needs no short step", "[status]") {
  Scene scene = scene_of({particles("p", 1)}, {effect("central_gravity", {{"strength", 1e-6}})});
  scene.bodies[0].position = {{-1, 1e-3, 0}};
  scene.bodies[0].velocity = {{1, 0, 0}};
  scene.run.step = 0.1, scene.run.duration = 2;
  CHECK(World(scene).status().code == Status::Code::ok);
  scene.effects[0].parameters["strength"] = 1.0;
  CHECK(World(scene).status().code == Status::Code::stability);
  scene.bodies[0].velocity = {{-1, 0, 0}};  // outward, to turn round far away
  scene.run.duration = 0.1;
  CHECK(World(scene).status().code == Status::Code::ok);
}

TEST_CASE("Status: a scene too far from the origin for its precision is reported", "[status]") {
  const auto code = [](double x, double apart, Precision precision) {
    Scene scene = scene_of({particles("p", 2)});
    scene.bodies[0].position = {{x, 0, 0}, {x + apart, 0, 0}};
    scene.bodies[0].velocity = {{0, 0, 0}};
    return World(scene, {.precision = precision}).status().code;
  };
  const double narrow = std::sqrt(std::numeric_limits<double>::epsilon()), wide = 1 / narrow;  // 2^-26
  CHECK(code(wide, 1.01, Precision::double_) == Status::Code::ok);
  CHECK(code(2 * wide, 1, Precision::double_) == Status::Code::accuracy);
  CHECK(code(-2 * wide, 1, Precision::double_) == Status::Code::accuracy);
  CHECK(code(2 * wide, 2.01, Precision::double_) == Status::Code::ok);
  CHECK(code(1e6, 1, Precision::double_) == Status::Code::ok);
  CHECK(code(1e6, 1, Precision::single_) == Status::Code::accuracy);
  CHECK(code(1e9, 1, Precision::double_) == Status::Code::accuracy);
  CHECK(code(1e9, 1, Precision::extended) == Status::Code::ok);
  CHECK(code(0, 1, Precision::single_) == Status::Code::ok);
}

TEST_CASE("Status: how far a body falls, and from what, counts into the width of its scene", "[status]") {
  Scene bead = scene_of({balls("b", 1)});
  bead.bodies[0].radius = {1e-3};
  bead.bodies[0].position = {{0, 0, 10}};
  bead.bodies[0].velocity = {{0, 0, 0}};
  bead.run.duration = 1;
  const auto code = [](const Scene& scene) { return World(scene, {.precision = Precision::single_}).status().code; };
  CHECK(code(bead) == Status::Code::accuracy);  // it hangs there: 2 mm wide, 10 m from the origin
  Scene falls = bead, above = bead, pulled = bead;
  falls.effects = {effect("gravity")};
  above.boundaries.resize(1);
  above.boundaries[0].shape = "plane";
  above.contact.kind = "impulse";
  pulled.effects = {effect("central_gravity", {{"strength", 1.0}})};
  CHECK(code(falls) == Status::Code::ok);
  CHECK(code(above) == Status::Code::ok);
  CHECK(code(pulled) == Status::Code::ok);
}

TEST_CASE("Status: an accepted limit is still reported, and the run goes on", "[status]") {
  Scene scene = spring_scene(100, 0.25, "velocity_verlet");
  scene.run.accept = {"stability"};
  World world(scene);
  world.step(3);
  CHECK(world.status().code == Status::Code::stability);
  CHECK(world.steps() == 3);
}

TEST_CASE("Status: codes have names", "[status]") {
  CHECK(std::string(name(Status::Code::ok)) == "ok");
  CHECK(std::string(name(Status::Code::stability)) == "stability");
  CHECK(std::string(name(Status::Code::non_finite)) == "non_finite");
}
