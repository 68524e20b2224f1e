// Implicit integrators whose forces give no derivatives: what is refused, what they tell, and on whom bits depend.
#include <algorithm>

#include "tests/catch.h"
#include "tests/determinism/body_bits.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::BodyBlock;
using ballpark::IdPair;
using ballpark::Precision;
using ballpark::Status;
using ballpark::World;

namespace {

template <class Real>
void pull_back(const BodyBlock<Real>& block, double stiffness) {
  for (int c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < block.count; ++i) {
      block.force[c][i] -= Real(stiffness) * block.position[c][i] + Real(0.5) * block.velocity[c][i];
    }
  }
}

/// A damped spring.
UserEffect holder(double stiffness = 30, std::vector<std::string> groups = {}) {
  UserEffect made = user_effect("holder", [=](const BodyBlock<double>& block) { pull_back(block, stiffness); });
  made.run_single = [=](const BodyBlock<float>& block) { pull_back(block, stiffness); };
  made.groups = std::move(groups);
  return made;
}

Scene by(const std::string& integrator, Scene scene) {
  scene.run.integrator = integrator;
  return scene;
}

/// Of 2 kg under a spring of 800 N/m: 20 rad/s.
Scene sprung(const std::string& integrator, double step) {
  Scene scene = by(integrator, scene_of({particles("p", 2)},
                                        {effect("spring", {{"anchor", Vector3d(0, 0, 0)}, {"stiffness", 800.0}})}));
  scene.run.step = step;
  return scene;
}

Scene elastic(const std::string& integrator, double restitution, double friction) {
  Scene scene = by(integrator, scene_of({balls("b", 2)}));
  scene.contact.kind = "penalty";
  scene.contact.stiffness = 1e4;
  scene.materials[""] = {restitution, friction};
  scene.run.step = 1e-3;
  return scene;
}

}  // namespace

TEST_CASE("Fixed point: a step that would diverge is refused, with the largest that would not", "[implicit]") {
  // 0.8 over the frequency and the largest eigenvalue of a: 1, 1/2, 1/sqrt(12).
  const std::vector<std::pair<const char*, double>> largest{
      {"backward_euler", 0.04}, {"implicit_midpoint", 0.08}, {"gauss4", 0.04 * std::sqrt(12.0)}};
  for (const auto& [name, step] : largest) {
    CAPTURE(name);
    const auto found = problems_of(sprung(name, 1.01 * step), {}, {holder(0)});
    REQUIRE(found.size() == 1);
    CHECK(found[0].path == "run.step");
    CHECK(contains(found[0].message, "fixed-point iteration"));
    CHECK(contains(found[0].message, "user effect \"holder\" gives no derivatives"));
    CHECK(contains(found[0].message, "multiplies their error by 0.808 (on group p)"));
    CHECK(contains(found[0].message, std::string(name) == "gauss4" ? "at most 0.1386 s" : "at most 0.0"));
    CHECK(problems_of(sprung(name, 0.99 * step), {}, {holder(0)}).empty());
    CHECK(problems_of(sprung(name, 10 * step)).empty());  // by Newton's method
    World world(sprung(name, 0.99 * step), {}, {holder(0)});
    world.step(50);
    CHECK(world.status().sentence == "ok");
  }
}

TEST_CASE("Fixed point: penalty contacts that jump or remember are refused, others are not", "[implicit]") {
  for (const char* name : {"backward_euler", "implicit_midpoint", "gauss4"}) {
    for (const auto& [restitution, friction] : {std::pair{0.9, 0.0}, std::pair{1.0, 0.1}}) {
      const auto found = problems_of(elastic(name, restitution, friction));
      REQUIRE(found.size() == 1);
      CHECK(found[0].path == "run.integrator");
      CHECK(contains(found[0].message, "restitution below 1"));
      CHECK(contains(found[0].message, "rk4"));
    }
    CHECK(problems_of(elastic(name, 1, 0)).empty());
    Scene stiff = elastic(name, 1, 0);
    stiff.contact.stiffness = 1e8;  // swings at 1e4 rad/s
    const auto found = problems_of(stiff);
    REQUIRE(found.size() == 1);
    CHECK(contains(found[0].message, "penalty contacts give no derivatives"));
    CHECK(contains(found[0].message, "(on contacts)"));
    Scene automatic = elastic(name, 1, 0);  // a tenth of what can be iterated
    automatic.run.step = 0, automatic.run.automatic_step = true;
    World world(automatic);
    CHECK(contains(world.explain().stages, "contraction 0.08 (contacts)"));
    world.step(1);
    CHECK(world.status().code == Status::Code::ok);
  }
}

TEST_CASE("Fixed point: explain says how stages are solved", "[implicit]") {
  const Scene scene = sprung("implicit_midpoint", 0.02);
  CHECK(World(scene).explain().stages == "Newton's method");
  CHECK(World(by("rk4", scene)).explain().stages.empty());
  const World iterated(scene, {}, {holder(0)});
  const ballpark::Explanation all = iterated.explain();
  CHECK(contains(all.stages, "fixed-point iteration: contraction 0.2 (group p); user effect \"holder\""));
  CHECK(all.path == "staged");
  REQUIRE(all.step_limits.size() == 1);
  CHECK(std::abs(all.step_limits[0].largest - 0.08) < 1e-12);
  const Scene many = by("gauss4", scene_of({particles("p", 101)}, {effect("mutual_gravity", {{"softening", 0.1}})}));
  CHECK(contains(World(many).explain().stages, "mutual_gravity joins 1212 unknowns"));
  CHECK(contains(World(many).explain().stages, "not known before the run"));
}

TEST_CASE("Fixed point: what does not converge is reported with the body and its last change", "[implicit]") {
  for (const char* name : {"backward_euler", "implicit_midpoint", "gauss4"}) {
    Scene scene = by(name, scene_of({particles("soft", 3), particles("stiff", 1)}));
    scene.run.step = 0.5;
    World world(scene, {}, {holder(1e5, {"stiff"})});
    world.step(1);
    CAPTURE(name, world.status().sentence);
    CHECK(world.status().code >= Status::Code::unconverged);
    CHECK(contains(world.status().sentence, "fixed-point iteration"));
    CHECK(contains(world.status().sentence, "for body 3"));
    CHECK(world.status().body == 3);
    CHECK(world.status().step == 1);
    CHECK(world.counters().newton_residual > 1e-3);
  }
}

TEST_CASE("Fixed point: same bits for any number of threads, and beside other bodies", "[implicit]") {
  for (const char* name : {"backward_euler", "implicit_midpoint", "gauss4"}) {
    const auto scene = [&](std::size_t more) {
      return by(name, scene_of({particles("p", 40), bricks("b", 5), particles("more", more)},
                               {effect("gravity"), effect("quadratic_drag", {{"coefficient", 0.3}})}));
    };
    World one(scene(0), {.threads = 1}, {holder()});
    one.step(10);
    CHECK(one.status().sentence == "ok");
    for (const int threads : {2, 3}) {
      World other(scene(5000), {.threads = threads}, {holder()});
      other.step(10);
      for (std::size_t id = 0; id < 45; ++id) REQUIRE(body_bits::of(other, id) == body_bits::of(one, id));
    }
    World copied(scene(0), {.threads = 2, .copies = 30}, {holder()});
    copied.step(10);
    for (std::size_t id = 0; id < 45; ++id) REQUIRE(body_bits::of(copied, 29 * 45 + id) == body_bits::of(one, id));
    World profiled(scene(0), {.threads = 2, .copies = 30}, {holder()});
    profiled.profile(true);
    profiled.step(10);
    CHECK(profiled.state_hash() == copied.state_hash());
  }
}

TEST_CASE("Fixed point: bodies that pull at each other have the same bits for any threads and copies", "[implicit]") {
  Scene scene = scene_of({particles("a", 7), particles("b", 4)},
                         {effect("mutual_gravity", {{"softening", 0.5}}),
                          effect("bonds", {{"pairs", std::vector<IdPair>{{0, 1}, {2, 8}}}, {"stiffness", 20.0}})});
  scene = by("gauss4", scene);
  World one(scene, {.threads = 1}, {holder()});
  one.step(20);
  CHECK(one.status().sentence == "ok");
  for (const int threads : {1, 2, 3}) {
    World other(scene, {.threads = threads, .copies = 50}, {holder()});
    other.step(20);
    for (std::size_t id = 0; id < 11; ++id) REQUIRE(body_bits::of(other, 49 * 11 + id) == body_bits::of(one, id));
    CHECK(other.counters().newton_iterations == 50 * one.counters().newton_iterations);
    CHECK(other.counters().force_evaluations == one.counters().force_evaluations);
  }
}

TEST_CASE("Fixed point: counts iterations and evaluations, which a snapshot returns to", "[implicit]") {
  World world(by("gauss4", scene_of({particles("p", 5)}, {effect("gravity")})), {}, {holder()});
  world.step(3);
  const ballpark::Snapshot middle = world.snapshot();
  world.step(5);
  const std::uint64_t hash = world.state_hash(), iterations = world.counters().newton_iterations;
  CHECK(iterations > 5 * 8 * 3);
  CHECK(iterations < 5 * 8 * 30);
  CHECK(world.counters().force_evaluations >= 2 * iterations / 5);
  CHECK(world.counters().force_evaluations < 2 * 8 * 30);
  world.restore(middle);
  world.step(5);
  CHECK(world.state_hash() == hash);
  CHECK(world.counters().newton_iterations == iterations);
}

TEST_CASE("Fixed point: single and double precision agree, plain and compensated", "[implicit]") {
  for (const char* name : {"backward_euler", "implicit_midpoint", "gauss4"}) {
    Scene scene = by(name, scene_of({bricks("b", 2), particles("p", 2)}, {effect("gravity")}));
    World exact(scene, {}, {holder()});
    exact.step(100);
    for (const bool compensated : {false, true}) {
      for (const Precision precision : {Precision::single_, Precision::double_}) {
        scene.run.compensated = compensated;
        World world(scene, {.precision = precision}, {holder()});
        world.step(100);
        CAPTURE(name, compensated, precision == Precision::single_, world.status().sentence);
        CHECK(world.status().code == Status::Code::ok);
        const double tolerance = precision == Precision::single_ ? 2e-5 : 1e-13;
        for (std::size_t id = 0; id < 4; ++id)
          CHECK(close(world.body(id).position, exact.body(id).position, tolerance));
      }
    }
  }
}

TEST_CASE("Fixed point: events split steps, and impulse contacts come between", "[implicit]") {
  Scene scene = by("implicit_midpoint", scene_of({particles("p", 1)}, {effect("gravity")}));
  scene.impulses = {{.at = 0.5 / 128, .J = {2, 0, 0}}};
  Scene built_in = scene;
  built_in.effects.push_back(effect("spring", {{"anchor", Vector3d(0, 0, 0)}, {"stiffness", 30.0}, {"damping", 0.5}}));
  World iterated(scene, {}, {holder()}), solved(built_in);
  iterated.step(20);
  solved.step(20);
  CHECK(close(iterated.body(0).position, solved.body(0).position));
  BodyGroup ball = balls("b", 1);
  ball.position = {{0, 0, 1}}, ball.velocity = {{0, 0, -1}};
  Scene bouncing = by("implicit_midpoint", scene_of({ball}, {effect("gravity")}));
  ballpark::Boundary ground;
  ground.shape = "plane";
  bouncing.boundaries = {ground};
  bouncing.contact.kind = "impulse";
  World with_user(bouncing, {}, {holder(0)});
  with_user.step(128);
  CHECK(with_user.status().sentence == "ok");
  CHECK(with_user.counters().impacts > 0);
}
