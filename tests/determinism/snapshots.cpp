// A run that goes back to a snapshot repeats itself, bit by bit.
#include "tests/catch.h"
#include "tests/determinism/scenarios.h"
#include "tests/integrators.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::Path;
using ballpark::Precision;
using ballpark::Snapshot;
using ballpark::World;

namespace {

constexpr double h = 1.0 / 128;

/// Impulses and windows on the steps, between them, several in one, and at the very time of the snapshot.
Scene eventful() {
  Scene scene = scene_of({particles("p", 3), spinning(balls("s", 2)), bricks("b", 5)}, {effect("gravity")});
  scene.effects.push_back(effect("force", {{"force", Vector3d(1, 2, 3)}, {"at", 3.5 * h}, {"until", 20.25 * h}}));
  scene.effects.push_back(
      effect("torque", {{"torque", Vector3d(0.1, 0.2, 0.3)}, {"at", 10 * h}, {"until", 12 * h}}, {"b"}));
  for (const double at : {0.0, 2.0, 5.3, 5.3, 5.6, 10.0, 10.5, 17.0, 19.99}) {
    scene.impulses.push_back({.at = at * h, .id = 7, .J = {1, 0.1, 0.2}, .offset = {0, 0.1, 0}});
  }
  // A ball whose spin nothing reads, struck off its centre, and one that does not even spin.
  scene.bodies.push_back(balls("still", 2));
  scene.bodies.back().orientation = {{0.6, 0, 0.8, 0}};
  scene.impulses.push_back({.at = 4 * h, .id = 3, .J = {1, 0.1, 0.2}, .offset = {0, 0.1, 0}});
  scene.impulses.push_back({.at = 7.5 * h, .id = 11, .J = {1, 0.1, 0.2}, .offset = {0, 0.1, 0}});
  return scene;
}

/// Hashes after each of `count` steps.
std::vector<std::uint64_t> hashes(World& world, int count) {
  std::vector<std::uint64_t> all;
  for (int i = 0; i < count; ++i) {
    world.step();
    all.push_back(world.state_hash());
  }
  return all;
}

void check_return(const Scene& scene, const Options& options, std::uint64_t at) {
  World world(scene, options);
  world.step(at);
  const Snapshot snapshot = world.snapshot();
  const std::uint64_t hash = world.state_hash();
  const std::vector<std::uint64_t> first = hashes(world, 25);
  world.restore(snapshot);
  CAPTURE(scene.run.integrator, at, scene.run.compensated);
  CHECK(world.state_hash() == hash);
  CHECK(world.steps() == at);
  CHECK(world.time() == snapshot.time);
  CHECK(hashes(world, 25) == first);
  World fresh(scene, options);
  fresh.restore(snapshot);
  CHECK(hashes(fresh, 25) == first);
}

}  // namespace

TEST_CASE("Snapshots: a restored run repeats itself across impulses and windows", "[bits]") {
  for (const ballpark::IntegratorDescription& integrator : ballpark::integrators()) {
    for (const bool compensated : {false, true}) {
      Scene scene = ballpark::tests::run_by(eventful(), integrator.name);
      scene.run.compensated = compensated;
      for (const std::uint64_t at : {0u, 2u, 3u, 4u, 5u, 6u, 10u, 11u, 17u}) {
        check_return(scene, {.threads = 1}, at);
      }
      check_return(scene, {.threads = 2, .precision = Precision::single_, .path = Path::staged}, 5);
    }
  }
}

TEST_CASE("Snapshots: in every scenario", "[bits]") {
  for (const std::string& file : scenarios::files()) {
    check_return(scenarios::small(file), {.threads = 2}, 2);
    check_return(scenarios::small(file), {.threads = 2, .precision = Precision::single_}, 2);
  }
}

TEST_CASE("Snapshots: forces and impulses asked for during the run come again", "[bits]") {
  World world(eventful());
  world.step(2);
  const Snapshot before = world.snapshot();
  world.apply_impulse_at(6.5 * h, 1, {1, 2, 3});
  world.apply_force(4, {1, 2, 3}, 4.75 * h, 9 * h);
  world.apply_torque(8, {1, 2, 3}, 4.75 * h, 9.5 * h);
  world.step(3);
  const Snapshot middle = world.snapshot();
  const std::uint64_t hash = world.state_hash();
  const std::vector<std::uint64_t> tail = hashes(world, 20);
  world.restore(middle);
  CHECK(hashes(world, 20) == tail);
  world.restore(before);
  world.step(3);
  CHECK(world.state_hash() == hash);
  CHECK(hashes(world, 20) == tail);
}

TEST_CASE("Snapshots: a body struck by hand goes on turning, in this world and in a new one", "[bits]") {
  BodyGroup turned = balls("s", 2);
  turned.orientation = {{0.6, 0, 0.8, 0}};
  const Scene scene = scene_of({turned});
  World world(scene), fresh(scene);
  const Snapshot start = world.snapshot();
  const std::uint64_t first = world.state_hash();
  world.apply_impulse(1, {0, 1, 0}, {0.1, 0, 0});
  world.step(3);
  const Snapshot later = world.snapshot();
  const std::vector<std::uint64_t> tail = hashes(world, 5);
  const double turned_to = world.body(1).orientation.w;
  fresh.restore(later);
  CHECK(hashes(fresh, 5) == tail);
  CHECK(fresh.body(1).orientation.w == turned_to);
  world.restore(start);
  CHECK(world.state_hash() == first);
}

TEST_CASE("Snapshots: status and counters come back", "[bits]") {
  BodyGroup doomed = particles("p", 1);
  doomed.position = {{0, 0, 0}};
  World world(scene_of({particles("q", 2), doomed}, {effect("central_gravity", {{"strength", 1.0}}, {"p"})}));
  const Snapshot start = world.snapshot();
  world.step(3);
  const Snapshot lost = world.snapshot();
  CHECK(world.status().code == ballpark::Status::Code::non_finite);
  world.restore(start);
  CHECK(world.status().code == ballpark::Status::Code::ok);
  CHECK(world.counters().steps == 0);
  CHECK(world.counters().force_evaluations == 0);
  world.restore(lost);
  CHECK(world.status().code == ballpark::Status::Code::non_finite);
  CHECK(world.status().body == 2);
  CHECK(world.counters().force_evaluations == 12);
}

TEST_CASE("Snapshots: stepping in pieces is stepping at once", "[bits]") {
  World at_once(eventful()), pieces(eventful()), timed(eventful());
  at_once.step(30);
  for (const std::uint64_t n : {1u, 0u, 7u, 2u, 20u}) pieces.step(n);
  for (const double t : {0.01, 0.0101, 0.1, 0.2, 30 * h}) timed.advance_to(t);
  CHECK(pieces.state_hash() == at_once.state_hash());
  CHECK(timed.state_hash() == at_once.state_hash());
  CHECK(timed.steps() == 30);
}
