// What implicit steps tell, what they refuse, and that no body's bits depend on others that do not pull at it.
#include <algorithm>

#include "tests/catch.h"
#include "tests/determinism/body_bits.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::IdPair;
using ballpark::Precision;
using ballpark::Status;
using ballpark::World;

namespace {

Scene by(const std::string& integrator, Scene scene) {
  scene.run.integrator = integrator;
  return scene;
}

Effect bonds(std::vector<IdPair> pairs, double stiffness = 1000) {
  return effect("bonds", {{"pairs", std::move(pairs)}, {"stiffness", stiffness}, {"damping", 1.0}});
}

/// Falls to a centre that it passes in a hundredth of this step.
Scene absurd(const std::string& integrator) {
  Scene scene = scene_of({particles("p", 3)}, {effect("central_gravity", {{"strength", 1.0}})});
  scene.bodies[0].position[1] = {1e-4, 2e-5, 0};
  scene.bodies[0].velocity[1] = {3, 50, 0};
  scene.run.step = 0.5;
  return by(integrator, scene);
}

}  // namespace

TEST_CASE("Implicit: stages that Newton's method does not find are reported with the body", "[implicit]") {
  std::size_t failed = 0;
  for (const char* name : {"backward_euler", "implicit_midpoint", "gauss4"}) {
    World world(absurd(name));
    world.step(3);
    CAPTURE(name, world.status().sentence);
    if (world.status().code == Status::Code::stability) {  // of the orbit alone
      CHECK(world.counters().newton_residual < 1e-12);
      continue;
    }
    ++failed;
    CHECK((world.status().code == Status::Code::unconverged || world.status().code == Status::Code::non_finite));
    CHECK(world.status().body == 1);
    CHECK(contains(world.status().sentence, "Newton's method"));
    CHECK(contains(world.status().sentence, "for body 1"));
    CHECK(world.counters().newton_residual > 1e-9);
  }
  CHECK(failed > 0);
  CHECK(std::string(name(Status::Code::unconverged)) == "unconverged");
}

TEST_CASE("Implicit: no step is chosen by a tolerance", "[implicit]") {
  Scene tolerated = by("gauss4", scene_of({particles("p", 2)}));
  tolerated.run.tolerance = 1e-6, tolerated.run.step = 0;
  CHECK(contains(problems_of(tolerated).at(0).message, "no estimate of its error"));
}

TEST_CASE("Implicit: attraction is solved by Newton's method up to a hundred bodies of two stages", "[implicit]") {
  const Scene scene = by("gauss4", scene_of({particles("p", 100)}, {effect("mutual_gravity")}));
  CHECK(World(scene).explain().path == "implicit");
}

TEST_CASE("Implicit: same bits for any number of threads, and beside other bodies", "[implicit]") {
  for (const char* name : {"backward_euler", "gauss4"}) {
    const auto scene = [&](std::size_t more) {
      std::vector<IdPair> pairs;
      for (std::size_t i = 0; i + 1 < 40; ++i) {
        if (i % 20 != 19) pairs.push_back({i, i + 1});
      }
      Scene made = scene_of({particles("chain", 40), bricks("b", 5), particles("more", more)},
                            {effect("gravity"), bonds(pairs), effect("quadratic_drag", {{"coefficient", 0.3}})});
      return by(name, made);
    };
    World one(scene(0), {.threads = 1});
    one.step(20);
    CHECK(one.status().sentence == "ok");
    for (const int threads : {2, 3, 5}) {
      World other(scene(5000), {.threads = threads});
      other.step(20);
      for (std::size_t id = 0; id < 45; ++id) REQUIRE(body_bits::of(other, id) == body_bits::of(one, id));
    }
    World copied(scene(0), {.threads = 2, .copies = 3});
    copied.step(20);
    for (std::size_t id = 0; id < 45; ++id) REQUIRE(body_bits::of(copied, 90 + id) == body_bits::of(one, id));
  }
}

TEST_CASE("Implicit: single, double and extended precision agree, plain and compensated", "[implicit]") {
  for (const char* name : {"backward_euler", "implicit_midpoint", "gauss4"}) {
    Scene scene =
        by(name, scene_of({bricks("b", 2), particles("p", 2)},
                          {effect("gravity"), bonds({{2, 3}}), effect("linear_drag", {{"coefficient", 0.2}})}));
    World exact(scene, {.precision = Precision::extended});
    exact.step(100);
    for (const bool compensated : {false, true}) {
      for (const Precision precision : {Precision::single_, Precision::double_}) {
        scene.run.compensated = compensated;
        World world(scene, {.precision = precision});
        world.step(100);
        CAPTURE(name, compensated, precision == Precision::single_, world.status().sentence);
        CHECK(world.status().code == Status::Code::ok);
        const double tolerance = precision == Precision::single_ ? 2e-5 : 1e-13;
        for (std::size_t id = 0; id < 4; ++id) {
          CHECK((world.body(id).position - exact.body(id).position).norm() < tolerance);
        }
      }
    }
  }
}

TEST_CASE("Implicit: a snapshot returns to the same steps and counters", "[implicit]") {
  World world(by("gauss4", scene_of({particles("p", 5)}, {effect("gravity"), bonds({{0, 1}, {3, 4}})})));
  world.step(3);
  const ballpark::Snapshot middle = world.snapshot();
  world.step(5);
  const std::uint64_t hash = world.state_hash(), iterations = world.counters().newton_iterations;
  world.restore(middle);
  world.step(5);
  CHECK(world.state_hash() == hash);
  CHECK(world.counters().newton_iterations == iterations);
  CHECK(iterations > 0);
}

TEST_CASE("Implicit: balls bounce by impulses between implicit steps", "[implicit]") {
  BodyGroup ball = balls("b", 1);
  ball.position = {{0, 0, 1}};
  ball.velocity = {{0, 0, 0}};
  Scene scene = by("implicit_midpoint", scene_of({ball}, {effect("gravity")}));
  ballpark::Boundary ground;
  ground.shape = "plane";
  scene.boundaries = {ground};
  scene.materials[""] = {0.5, 0};
  scene.contact.kind = "impulse";
  scene.run.step = 1e-3;
  World world(scene);
  double highest = 0;  // between the first impact and the second
  for (int n = 0; n < 700; ++n) {
    world.step();
    if (world.counters().impacts > 0) highest = std::max(highest, world.body(0).position.z());
  }
  CHECK(world.status().sentence == "ok");
  const double radius = ball.radius[0], fall = 1 - radius;
  CHECK(std::abs(highest - (radius + 0.25 * fall)) < 0.005);
}
