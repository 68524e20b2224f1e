// The public face: time, whole steps, totals, profiles, moves.
#include <utility>

#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::Totals;
using ballpark::World;

namespace {

/// Spinning balls of 2 kg and 0.1 m about the origin.
Scene spinners() {
  return scene_of({spinning(balls("s", 3)), particles("p", 2)}, {effect("gravity")});
}

struct Expected {
  double kinetic = 0, potential = 0;
  Vector3d momentum{0, 0, 0}, angular{0, 0, 0};
};

/// Summed by hand from what body() says.
Expected by_hand(const World& world) {
  Expected sum;
  for (std::size_t id = 0; id < world.body_count(); ++id) {
    const ballpark::BodyState b = world.body(id);
    const double mass = 2, inertia = b.has_angular_velocity ? 0.4 * mass * 0.01 : 0;
    sum.kinetic += mass * b.velocity.squaredNorm() / 2 + inertia * b.angular_velocity.squaredNorm() / 2;
    sum.potential += mass * 9.81 * b.position.z();
    sum.momentum += mass * b.velocity;
    sum.angular += inertia * b.angular_velocity;
    sum.angular.x() += mass * (b.position.y() * b.velocity.z() - b.position.z() * b.velocity.y());
    sum.angular.y() += mass * (b.position.z() * b.velocity.x() - b.position.x() * b.velocity.z());
    sum.angular.z() += mass * (b.position.x() * b.velocity.y() - b.position.y() * b.velocity.x());
  }
  return sum;
}

}  // namespace

TEST_CASE("World: time is the number of steps times the step", "[api]") {
  Scene scene = spinners();
  scene.run.step = 0.1;
  World world(scene);
  for (int i = 1; i <= 1000; ++i) {
    world.step();
    REQUIRE(world.time() == i * 0.1);
  }
  CHECK(world.steps() == 1000);
  CHECK(world.counters().steps == 1000);
  CHECK(world.counters().force_evaluations == 4000);
}

TEST_CASE("World: advance_to takes whole steps and keeps the remainder", "[api]") {
  Scene scene = spinners();
  scene.run.step = 0.1;
  World world(scene);
  world.advance_to(0.25);
  CHECK(world.steps() == 2);
  world.advance_to(0.29);
  CHECK(world.steps() == 2);
  world.advance_to(0.3);  // 0.1 * 3 > 0.3 in double: to a billionth of a step
  CHECK(world.steps() == 3);
  world.advance_to(0.2);
  CHECK(world.steps() == 3);
  for (int frame = 1; frame <= 600; ++frame) world.advance_to(0.3 + frame / 60.0);
  CHECK(world.steps() == 103);
}

TEST_CASE("World: totals are sums over bodies", "[api]") {
  World world(spinners(), {.copies = 2});
  for (int i = 0; i < 2; ++i) {
    const Totals totals = world.totals();
    const Expected expected = by_hand(world);
    CHECK(close(totals.kinetic, expected.kinetic));
    CHECK(close(totals.potential, expected.potential));
    CHECK(close(totals.energy(), expected.kinetic + expected.potential));
    CHECK(close(totals.momentum, expected.momentum));
    CHECK(close(totals.angular_momentum, expected.angular));
    CHECK(totals.momentum_scale >= totals.momentum.norm());
    CHECK(totals.angular_momentum_scale >= totals.angular_momentum.norm());
    CHECK(totals.non_finite_bodies == 0);
    world.step(50);
  }
}

TEST_CASE("World: totals do not depend on the number of threads", "[api]") {
  const Scene scene = scene_of({particles("p", 9001)}, {effect("gravity")});
  const Totals one = World(scene, {.threads = 1}).totals();
  for (const int threads : {2, 3, 5, 8}) {
    const Totals many = World(scene, {.threads = threads}).totals();
    CHECK(many.kinetic == one.kinetic);
    CHECK(many.potential == one.potential);
    CHECK(many.angular_momentum == one.angular_momentum);
  }
}

TEST_CASE("World: reading a world changes nothing", "[api]") {
  World world(spinners());
  world.step(3);
  const std::uint64_t hash = world.state_hash();
  world.totals();
  world.explain();
  world.snapshot();
  world.body(1);
  world.view<double>("position");
  CHECK(world.state_hash() == hash);
}

TEST_CASE("World: profiling counts calls and bytes, and changes no bit", "[api]") {
  World timed(spinners()), plain(spinners());
  timed.step(2);
  timed.profile(true);
  timed.step(10);
  plain.step(12);
  CHECK(timed.state_hash() == plain.state_hash());
  REQUIRE(timed.pass_times().size() == 1);
  const ballpark::PassTime pass = timed.pass_times()[0];
  CHECK(pass.name == "fused_step");
  CHECK(pass.calls == 10);
  CHECK(pass.seconds > 0);
  CHECK(pass.bytes == 10 * 5 * 96.0);
  timed.profile(false);
  timed.step(5);
  CHECK(timed.pass_times()[0].calls == 10);
  timed.profile(true);
  CHECK(timed.pass_times()[0].calls == 0);
  CHECK(plain.pass_times().empty());
}

TEST_CASE("World: moves from place to place, and goes on", "[api]") {
  World world(spinners()), other(spinners());
  world.step(3);
  World moved = std::move(world);
  moved.step(3);
  other = std::move(moved);
  other.step(3);
  World straight(spinners());
  straight.step(9);
  CHECK(other.state_hash() == straight.state_hash());
}

TEST_CASE("World: the state hash tells states apart", "[api]") {
  const World one(spinners());
  Scene scene = spinners();
  scene.bodies[0].angular_velocity[2].x() = 1;  // spin that no force reads
  CHECK(World(scene).state_hash() == one.state_hash());
  scene.bodies[0].position[2].x() += 1e-15;
  CHECK(World(scene).state_hash() != one.state_hash());
  scene = spinners();
  std::swap(scene.bodies[1].position[0], scene.bodies[1].position[1]);
  CHECK(World(scene).state_hash() != one.state_hash());
}
