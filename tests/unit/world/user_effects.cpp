// Forces of the user: they see the columns of their groups at each evaluation, and what they add acts.
#include <atomic>
#include <memory>

#include "tests/catch.h"
#include "tests/determinism/body_bits.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::BodyBlock;
using ballpark::Precision;
using ballpark::World;

namespace {

/// The catalogue's linear drag and gravity, as user effects.
template <class Real>
void drag(const BodyBlock<Real>& block) {
  for (int c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < block.count; ++i) block.force[c][i] -= Real(0.25) * block.velocity[c][i];
  }
}
template <class Real>
void weight(const BodyBlock<Real>& block) {
  for (std::size_t i = 0; i < block.count; ++i) block.force[2][i] += block.mass[i] * Real(-9.81);
}

UserEffect drag_effect(std::vector<std::string> groups = {}) {
  UserEffect made = user_effect("drag", drag<double>);
  made.run_single = drag<float>;
  made.groups = std::move(groups);
  return made;
}
UserEffect weight_effect() {
  UserEffect made = user_effect("weight", weight<double>);
  made.run_single = weight<float>;
  made.reads_velocity = false;
  return made;
}

/// Turns bodies against their spin, and counts what it was given.
struct Brake {
  std::atomic<std::size_t> bodies{0}, without_torque{0}, with_orientation{0};
  void operator()(const BodyBlock<double>& block) {
    bodies += block.count;
    with_orientation += block.orientation[0] ? block.count : 0;
    if (!block.torque[0]) {
      without_torque += block.count;
      return;
    }
    for (int c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < block.count; ++i) block.torque[c][i] -= 0.5 * block.angular_velocity[c][i];
    }
  }
};

}  // namespace

TEST_CASE("User effects: give the motion that the same built-in effects give", "[user]") {
  for (const ballpark::IntegratorDescription& integrator : ballpark::integrators()) {
    if (integrator.implicit) continue;  // iterates: fixed_point.cpp
    if (integrator.name == "taylor2" ||
        (integrator.family == "splitting" && (integrator.order > 2 || integrator.turns_velocity)))
      continue;  // refused
    BodyGroup mixed = particles("p", 37);
    for (std::size_t i = 0; i < 37; ++i) mixed.mass.resize(i + 1, 1.0 + 0.1 * static_cast<double>(i));
    Scene own = scene_of({mixed, bricks("b", 4099)});
    own.run.integrator = integrator.name;
    Scene built_in = own;
    built_in.effects = {effect("gravity"), effect("linear_drag", {{"coefficient", 0.25}})};
    World a(own, {.threads = 2}, {weight_effect(), drag_effect()}), b(built_in);
    a.step(40);
    b.step(40);
    CAPTURE(integrator.name);
    for (const std::size_t id : {0u, 36u, 37u, 38u, 4135u}) {
      CHECK(close(a.body(id).position, b.body(id).position));
      CHECK(close(a.body(id).velocity, b.body(id).velocity));
    }
  }
}

TEST_CASE("User effects: same bits for any number of threads and target, in both precisions", "[user]") {
  const Scene scene = scene_of({particles("p", 9001), bricks("b", 13)}, {effect("gravity")});
  for (const Precision precision : {Precision::double_, Precision::single_}) {
    const auto hash = [&](int threads, const std::string& target) {
      World world(scene, {.threads = threads, .target = target, .precision = precision}, {drag_effect({"p"})});
      world.step(5);
      return world.state_hash();
    };
    const std::uint64_t expected = hash(1, "base");
    for (const int threads : {1, 2, 3, 5, 8}) CHECK(hash(threads, "auto") == expected);
    for (const ballpark::NamedDescription& target : ballpark::targets()) {
      if (target.available) CHECK(hash(2, target.name) == expected);
    }
  }
}

TEST_CASE("User effects: one that adds nothing changes no bit", "[user]") {
  const Scene scene = scene_of({particles("p", 9), bricks("b", 5)}, {effect("gravity")});
  World plain(scene), watched(scene, {}, {user_effect("none", [](const BodyBlock<double>&) {})});
  plain.step(20);
  watched.step(20);
  CHECK(plain.state_hash() == watched.state_hash());
}

TEST_CASE("User effects: act on their groups alone", "[user]") {
  const Scene scene = scene_of({particles("p", 9), particles("q", 5)});
  World world(scene, {}, {drag_effect({"q"})}), free(scene);
  world.step(20);
  free.step(20);
  CHECK((body_bits::of(world, 0, 9) == body_bits::of(free, 0, 9)));
  CHECK(world.body(9).velocity.norm() < 0.99 * free.body(9).velocity.norm());
}

TEST_CASE("User effects: are given each group's columns, and torques turn bodies", "[user]") {
  const auto brake = std::make_shared<Brake>();
  const auto run = [brake](const BodyBlock<double>& block) { (*brake)(block); };
  Scene scene = scene_of({particles("p", 9), balls("s", 5), bricks("b", 3)});
  scene.run.integrator = "euler";
  UserEffect effect = user_effect("brake", run);
  effect.needs_rotation = true;
  World world(scene, {}, {effect});
  const Vector3d spin = world.body(14).angular_velocity;
  world.step(2);
  CHECK(brake->bodies == 2 * 17);
  CHECK(brake->without_torque == 2 * 9);
  CHECK(brake->with_orientation == 2 * 3);
  CHECK(world.body(9).has_angular_velocity);
  CHECK(world.body(14).angular_velocity.norm() < spin.norm());
}

TEST_CASE("User effects: the time is that of the evaluation", "[user]") {
  const auto times = std::make_shared<std::vector<double>>();
  Scene scene = scene_of({particles("p", 1)});
  scene.run.integrator = "rk4";
  const double h = scene.run.step;
  const auto clock = [times](const BodyBlock<double>& block) { times->push_back(block.time); };
  World world(scene, {.threads = 1}, {user_effect("clock", clock)});
  world.step(2);
  CHECK(*times == std::vector<double>{0, h / 2, h / 2, h, h, 1.5 * h, 1.5 * h, 2 * h});
}

TEST_CASE("User effects: explain says that the path is staged and why", "[user]") {
  const World world(scene_of({particles("p", 1)}), {}, {drag_effect()});
  const ballpark::Explanation all = world.explain();
  CHECK(all.path == "staged");
  CHECK(contains(all.path_reason, "user effects"));
  CHECK(contains(all.groups[0].effects, "drag"));
  CHECK_FALSE(contains(all.off, "force sums"));
}
