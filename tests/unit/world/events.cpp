// Impulses and loads at their times, whole or within a step, and changes between steps.
#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::BodyState;
using ballpark::World;

namespace {

constexpr double h = 1.0 / 128;

/// 2 kg at the origin, in nothing.
Scene still(std::vector<Effect> effects = {}) {
  Scene scene = scene_of({particles("p", 1)}, std::move(effects));
  scene.bodies[0].position = {{0, 0, 0}};
  scene.bodies[0].velocity = {{0, 0, 0}};
  return scene;
}

/// A solid sphere of 2 kg and 0.5 m: 0.2 kg m^2.
BodyGroup ball() {
  BodyGroup group = balls("s", 1);
  group.position = {{1, 0, 0}};
  group.velocity = {{0, 0, 0}};
  group.radius = {0.5};
  return group;
}

BodyGroup turned(BodyGroup group) {
  group.orientation = {{0.6, 0, 0.8, 0}};
  return group;
}

double apart(const ballpark::Quaternion& a, const ballpark::Quaternion& b) {
  return std::abs(a.w - b.w) + std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

}  // namespace

TEST_CASE("Events: an impulse within a step acts at its very time", "[events]") {
  for (const ballpark::IntegratorDescription& integrator : ballpark::integrators()) {
    Scene scene = still();
    scene.run.integrator = integrator.name;
    scene.impulses = {{.at = 10.25 * h, .id = 0, .J = {1, 0, 0}}};
    World world(scene);
    world.step(10);
    CHECK(world.body(0).velocity.x() == 0);
    world.step(6);
    CAPTURE(integrator.name);
    CHECK(world.body(0).velocity.x() == 0.5);
    CHECK(close(world.body(0).position.x(), 0.5 * 5.75 * h, 1e-15));
    CHECK(world.time() == 16 * h);
    CHECK(world.steps() == 16);
    if (integrator.implicit) continue;  // iterates
    // Ten steps, one in two parts, five steps; multistep methods begin twice by rk4, which also takes the parts.
    const int evaluations = integrator.evaluations, begin = integrator.start_steps;
    const int parts = begin > 0 ? 2 * 4 : 2 * evaluations;
    CHECK(world.counters().force_evaluations ==
          static_cast<std::uint64_t>(15 * evaluations + 2 * begin * (4 - evaluations) + parts));
  }
}

TEST_CASE("Events: impulses at the start, at one time, and on a step split nothing", "[events]") {
  Scene scene = still();
  for (const double at : {0.0, 0.0, 4 * h, 4 * h}) scene.impulses.push_back({.at = at, .id = 0, .J = {1, 0, 0}});
  World world(scene);
  world.step(4);
  CHECK(world.body(0).velocity.x() == 1);
  CHECK(close(world.body(0).position.x(), 4 * h, 1e-15));
  world.step(4);
  CHECK(world.body(0).velocity.x() == 2);
  CHECK(close(world.body(0).position.x(), 12 * h, 1e-15));
  CHECK(world.counters().force_evaluations == 4 * 8);
}

TEST_CASE("Events: a force acts from its first to its last moment, within steps too", "[events]") {
  const Effect push = effect("force", {{"force", Vector3d(4, 0, 0)}, {"at", 2.5 * h}, {"until", 7.75 * h}});
  World from_scene(still({push})), asked(still());
  asked.apply_force(0, {4, 0, 0}, 2.5 * h, 7.75 * h);
  for (World* world : {&from_scene, &asked}) {
    world->step(2);
    CHECK(world->body(0).velocity.x() == 0);
    world->step(18);
    CHECK(close(world->body(0).velocity.x(), 2 * 5.25 * h, 1e-15));
    const double drift = 12.25 * h, pushed = 5.25 * h;
    CHECK(close(world->body(0).position.x(), pushed * pushed + 2 * pushed * drift, 1e-15));
  }
  CHECK(from_scene.state_hash() == asked.state_hash());
}

TEST_CASE("Events: an impulse off the centre turns the body", "[events]") {
  World world(scene_of({spinning(ball())}));
  const Vector3d before = world.body(0).angular_velocity;
  world.apply_impulse(0, {0, 2, 0}, {0.5, 0, 0});
  CHECK(close(world.body(0).velocity, {0, 1, 0}));
  CHECK(close(world.body(0).angular_velocity - before, {0, 0, 5}));
  CHECK(close(world.body(0).position, {1, 0, 0}));
}

TEST_CASE("Events: a body at rest that is made to spin turns from then on", "[events]") {
  const Vector3d J(0, 2, 0), lever(0.5, 0, 0);
  Scene heavy = scene_of({turned(particles("b", 1))});
  heavy.bodies[0].inertia = {{0.1, 0.2, 0.25}};
  for (const Scene& scene : {scene_of({turned(ball())}), heavy}) {
    CAPTURE(scene.bodies[0].name);
    World kicked(scene), set(scene), pushed(scene), scheduled(scene);
    const ballpark::Quaternion start = kicked.body(0).orientation;
    REQUIRE(kicked.body(0).has_orientation);
    kicked.apply_impulse(0, J, lever);
    BodyState state = set.body(0);
    state.angular_velocity = {0, 0, 5};
    set.set(0, state);
    pushed.apply_torque(0, {0, 0, 1}, 0, 1);
    scheduled.apply_impulse_at(2 * h, 0, J, lever);
    for (World* world : {&kicked, &set, &pushed, &scheduled}) {
      world->step(20);
      CHECK(world->body(0).angular_velocity.norm() > 0.1);
      CHECK(apart(world->body(0).orientation, start) > 0.01);
    }
  }
}

TEST_CASE("Events: a torque on a ball whose spin nobody read so far", "[events]") {
  Scene scene = scene_of({spinning(ball()), particles("p", 3)});
  for (const ballpark::Path path : {ballpark::Path::fused, ballpark::Path::staged}) {
    World world(scene, {.path = path});
    world.step(3);
    const Vector3d before = world.body(0).angular_velocity;
    world.apply_torque(0, {0, 0, 0.4}, world.time(), world.time() + 10 * h);
    world.step(20);
    CHECK(close(world.body(0).angular_velocity - before, {0, 0, 0.4 * 10 * h / 0.2}));
    const Vector3d first = world.body(0).angular_velocity;
    world.apply_torque(0, {0, 0, 0.4}, world.time(), world.time() + 10 * h);
    world.step(20);
    CHECK(close(world.body(0).angular_velocity - first, {0, 0, 0.4 * 10 * h / 0.2}));
  }
}

TEST_CASE("Events: a pivoted body answers to the moment of an impulse about its pivot", "[events]") {
  World world(scene_of({ball()}, {effect("pivot", {{"point", Vector3d(0, 0, 0)}})}));
  world.apply_impulse(0, {0, 2, 0});
  const double spin = 2 * 1 / (0.2 + 2);  // J l / (I + m l^2)
  CHECK(close(world.body(0).angular_velocity, {0, 0, spin}));
  CHECK(close(world.body(0).velocity, {0, spin, 0}));
  world.apply_impulse(0, {0, 0, 3}, {-1, 0, 0});  // at the pivot itself
  CHECK(close(world.body(0).angular_velocity, {0, 0, spin}));
}

TEST_CASE("Events: set changes one body, and what is not given stays", "[events]") {
  World world(scene_of({particles("p", 3), bricks("b", 2)}));
  const BodyState neighbour = world.body(2), before = world.body(3);
  BodyState state = before;
  state.position = {7, 8, 9};
  state.velocity = {-1, -2, -3};
  state.has_orientation = false;
  state.has_angular_velocity = false;
  world.set(3, state);
  CHECK(world.body(3).position == Vector3d(7, 8, 9));
  CHECK(world.body(3).velocity == Vector3d(-1, -2, -3));
  CHECK(close(world.body(3).angular_velocity, before.angular_velocity));
  CHECK(apart(world.body(3).orientation, before.orientation) == 0);
  CHECK(world.body(2).position == neighbour.position);
  state.orientation = {0.6, 0.8, 0, 0};
  state.has_orientation = true;
  world.set(3, state);
  CHECK(close(world.body(3).angular_velocity, before.angular_velocity));
  CHECK(world.body(3).orientation.x == 0.8);
}

TEST_CASE("Events: in copies, an impulse of the scene strikes each", "[events]") {
  Scene scene = still();
  scene.impulses = {{.at = 2.5 * h, .id = 0, .J = {1, 0, 0}}};
  World world(scene, {.copies = 3});
  world.apply_impulse_at(2.5 * h, 1, {0, 1, 0});
  world.step(5);
  for (std::size_t id = 0; id < 3; ++id) CHECK(world.body(id).velocity == Vector3d(0.5, id == 1 ? 0.5 : 0, 0));
}

TEST_CASE("Events: a compensated world forgets what rounding took when a body is set", "[events]") {
  Scene scene = scene_of({particles("p", 2)}, {effect("gravity")});
  scene.run.compensated = true;
  World fresh(scene), moved(scene);
  moved.step(7);
  const ballpark::Snapshot later = moved.snapshot();
  World other(scene);
  other.step(5);
  for (World* world : {&moved, &other}) {
    BodyState state;
    state.position = {0.1, 0.2, 0.3};
    world->set(0, state);
  }
  moved.step(9);
  other.step(9);
  CHECK(moved.body(0).position == other.body(0).position);
  CHECK(moved.body(0).velocity == other.body(0).velocity);
}
