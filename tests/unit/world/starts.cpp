// Where bodies are at the start: lists, generators, frames; and scenes with no body or one.
#include <set>

#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::Generate;
using ballpark::Precision;
using ballpark::World;

namespace {

BodyGroup generated(const std::string& name, const Generate& how) {
  BodyGroup group;
  group.name = name;
  group.mass = {1};
  group.inertia = {{1, 2, 2.5}};
  group.generate = how;
  return group;
}

const Generate box{.kind = "random",
                   .count = {2000},
                   .lower = {-1, 2, 10},
                   .upper = {1, 2, 14},
                   .velocity_spread = {1, 0, 3},
                   .angular_velocity_spread = {0, 5, 0},
                   .random_orientation = true};

double length(const ballpark::Quaternion& q) {
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

}  // namespace

TEST_CASE("Starts: a lattice, x fastest", "[start]") {
  BodyGroup group = particles("p", 0);
  group.generate = Generate{.kind = "lattice", .count = {3, 2, 4}, .origin = {1, 2, 3}, .spacing = 0.5};
  group.velocity = {{1, 0, 0}};
  const World world(scene_of({group}));
  REQUIRE(world.body_count() == 24);
  CHECK(world.body(0).position == Vector3d(1, 2, 3));
  CHECK(world.body(1).position == Vector3d(1.5, 2, 3));
  CHECK(world.body(3).position == Vector3d(1, 2.5, 3));
  CHECK(world.body(6).position == Vector3d(1, 2, 3.5));
  CHECK(world.body(23).position == Vector3d(2, 2.5, 4.5));
  CHECK(world.body(23).velocity == Vector3d(1, 0, 0));
}

TEST_CASE("Starts: random bodies fill the box and the spreads, and no more", "[start]") {
  BodyGroup group = generated("g", box);
  group.velocity = {{10, 0, 0}};
  const World world(scene_of({group}));
  Vector3d sum(0, 0, 0), least(99, 99, 99), most(-99, -99, -99), least_v = least, most_v = most;
  std::set<double> heights;
  for (std::size_t id = 0; id < 2000; ++id) {
    const ballpark::BodyState body = world.body(id);
    sum += body.position;
    least = least.cwiseMin(body.position);
    most = most.cwiseMax(body.position);
    least_v = least_v.cwiseMin(body.velocity);
    most_v = most_v.cwiseMax(body.velocity);
    heights.insert(body.position.z());
    CHECK(close(length(body.orientation), 1));
    CHECK(std::abs(body.angular_velocity.x()) < 1e-13);
    CHECK(std::abs(body.angular_velocity.y()) <= 5 * (1 + 1e-13));
  }
  CHECK(heights.size() == 2000);
  CHECK(least.x() >= -1);
  CHECK(least.x() < -0.99);
  CHECK(most.z() <= 14);
  CHECK(most.z() > 13.98);
  CHECK(least.y() == 2);
  CHECK(most.y() == 2);
  CHECK(close(sum / 2000, {0, 2, 12}, 0.1));
  CHECK(least_v.x() > 9);
  CHECK(most_v.z() > 2.98);
  CHECK(most_v.y() == 0);
}

TEST_CASE("Starts: body i of a group depends on seed, group and i alone", "[start]") {
  Generate more = box;
  more.count = {2500};
  const World few(scene_of({generated("g", box)})), many(scene_of({generated("g", more), generated("h", box)}));
  for (const std::size_t id : {0u, 1u, 999u, 1999u}) CHECK(few.body(id).position == many.body(id).position);
  CHECK(many.body(0).position != many.body(2500).position);
  Scene other = scene_of({generated("g", box)});
  other.run.seed = 2;
  CHECK(World(other).body(0).position != few.body(0).position);
}

TEST_CASE("Starts: a spin in the body frame turns with the orientation", "[start]") {
  BodyGroup group = particles("b", 1);
  group.inertia = {{1, 2, 2.5}};
  group.orientation = {{std::sqrt(0.5), 0, 0, std::sqrt(0.5)}};  // a quarter about z
  group.angular_velocity = {{1, 0, 3}};
  const World world(scene_of({group}));
  group.angular_velocity_frame = "body";
  const World body(scene_of({group}));
  CHECK(close(world.body(0).angular_velocity, {1, 0, 3}));
  CHECK(close(body.body(0).angular_velocity, {0, 1, 3}));
}

TEST_CASE("Starts: a pivoted body given a velocity turns with it", "[start]") {
  BodyGroup bob = particles("bob", 1);
  bob.position = {{2, 0, 0}};
  bob.velocity = {{0, 3, 0}};
  const World world(scene_of({bob}, {effect("pivot", {{"point", Vector3d(0, 0, 0)}})}));
  CHECK(close(world.body(0).angular_velocity, {0, 0, 1.5}));
  CHECK(close(world.body(0).velocity, {0, 3, 0}));
}

TEST_CASE("Starts: no body at all", "[start]") {
  for (const Scene& scene : {scene_of({}), scene_of({}, {effect("gravity")}), scene_of({particles("p", 0)})}) {
    for (const ballpark::Path path : {ballpark::Path::fused, ballpark::Path::staged}) {
      World world(scene, {.threads = 2, .copies = 3, .path = path});
      world.step(5);
      CHECK(world.body_count() == 0);
      CHECK(world.time() == 5 * scene.run.step);
      CHECK(world.totals().energy() == 0);
      CHECK(world.explain().passes.empty());
      CHECK(world.explain().bytes_per_body_step == 0);
      CHECK(world.status().code == ballpark::Status::Code::ok);
      world.restore(world.snapshot());
    }
  }
}

TEST_CASE("Starts: an empty group of each kind, alone and beside others", "[start]") {
  BodyGroup spun = balls("s", 0), turned = bricks("b", 0), pivoted = particles("v", 0);
  spun.angular_velocity = {{1, 2, 3}};
  turned.orientation = {{}};
  turned.angular_velocity = {{1, 2, 3}};
  const std::vector<Effect> effects{effect("gravity"), effect("pivot", {{"point", Vector3d(1, 0, 0)}}, {"v"}),
                                    effect("spring", {{"anchor", Vector3d(1, 0, 0)}, {"stiffness", 1.0}})};
  for (const bool alone : {true, false}) {
    for (const ballpark::Path path : {ballpark::Path::fused, ballpark::Path::staged}) {
      for (const bool compensated : {false, true}) {
        Scene scene = scene_of({spun, turned, pivoted}, effects);
        if (!alone) scene.bodies.insert(scene.bodies.begin() + 1, particles("p", 3));
        scene.run.compensated = compensated;
        World world(scene, {.path = path});
        world.step(5);
        CHECK(world.body_count() == (alone ? 0 : 3));
        CHECK(world.explain().groups.size() == (alone ? 0 : 1));
        CHECK(world.totals().non_finite_bodies == 0);
        world.restore(world.snapshot());
      }
    }
  }
}

TEST_CASE("Starts: one body", "[start]") {
  World world(scene_of({particles("p", 1)}, {effect("gravity")}), {.threads = 3});
  world.step(128);
  CHECK(close(world.body(0).velocity.z(), 0.3 - 9.81));
  CHECK(close(world.body(0).position.z(), 2 + 0.3 - 9.81 / 2));
}

TEST_CASE("Starts: precision is the scene's, or the option's", "[start]") {
  Scene scene = scene_of({particles("p", 1)});
  CHECK(World(scene).precision() == Precision::double_);
  CHECK(World(scene, {.precision = Precision::single_}).precision() == Precision::single_);
  scene.run.precision = Precision::extended;
  CHECK(World(scene).precision() == Precision::extended);
  CHECK(World(scene).target() == "base");
  CHECK(World(scene, {.threads = 3}).threads() == 3);
}
