// Copies in a batch keep the bits of their solo runs; perturbation moves starts, deterministically.
#include "tests/catch.h"
#include "tests/determinism/body_bits.h"
#include "tests/determinism/scenarios.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::Precision;
using ballpark::World;

namespace {

/// Copy k of the batch beside a run of its own with seed + k.
void check_copies(const Scene& scene, Options options, std::uint64_t steps) {
  World batch(scene, options);
  batch.step(steps);
  const std::size_t per_copy = batch.body_count() / static_cast<std::size_t>(options.copies);
  for (int k = 0; k < options.copies; ++k) {
    Scene own = scene;
    own.run.seed += static_cast<std::uint64_t>(k);
    World solo(own, {.threads = 1, .precision = options.precision, .perturb = options.perturb});
    solo.step(steps);
    CAPTURE(scene.name, k);
    CHECK((body_bits::of(batch, static_cast<std::size_t>(k) * per_copy, per_copy) == body_bits::of(solo, 0, per_copy)));
  }
}

Scene fewer(Scene scene, std::size_t bodies) {
  for (BodyGroup& group : scene.bodies) {
    if (group.generate && group.generate->kind == "random") group.generate->count[0] = bodies;
  }
  return scene;
}

Scene random_mix() {
  Scene scene = scene_of({particles("p", 3), spinning(balls("s", 2)), bricks("b", 5)},
                         {effect("gravity"), effect("magnus", {{"coefficient", 0.1}}, {"s"})});
  BodyGroup cloud = particles("cloud", 0);
  cloud.generate = ballpark::Generate{
      .kind = "random", .count = {101}, .lower = {-1, -1, -1}, .upper = {1, 2, 3}, .velocity_spread = {1, 1, 1}};
  scene.bodies.insert(scene.bodies.begin() + 1, cloud);
  scene.impulses = {{.at = 0.01, .id = 104, .J = {1, 2, 3}, .offset = {0, 0.1, 0}}};
  return scene;
}

/// Bodies of different masses that attract each other; two of them begin at one place.
Scene attracted(std::size_t bodies, double softening) {
  BodyGroup group{.name = "stars", .mass = {}};
  for (std::size_t i = 0; i < bodies; ++i) {
    const double t = static_cast<double>(i == 4 ? 3 : i);
    group.mass.push_back(1 + 0.3 * static_cast<double>(i));
    group.position.push_back({std::sqrt(2 + t), t * (t - 2), 0.1 * t});
    group.velocity.push_back({0.1 * t, 0.2, -0.05 * t});
  }
  Scene scene = scene_of({group}, {effect("gravity"), effect("linear_drag", {{"coefficient", 0.2}})});
  scene.effects.push_back(effect("mutual_gravity", {{"strength", 1.0}, {"softening", softening}}));
  return scene;
}

}  // namespace

TEST_CASE("Copies: each keeps the bits of its solo run, in every scenario", "[bits]") {
  for (const std::string& file : scenarios::files()) {
    const Scene scene = fewer(scenarios::small(file), 1237);
    for (const Precision precision : {Precision::double_, Precision::single_}) {
      check_copies(scene, {.threads = 2, .precision = precision, .copies = 5}, 20);
      check_copies(scene, {.threads = 2, .precision = precision, .copies = 3, .perturb = 1e-3}, 20);
    }
  }
}

TEST_CASE("Copies: groups of all motions, with an impulse", "[bits]") {
  check_copies(random_mix(), {.threads = 2, .copies = 4}, 20);
  check_copies(random_mix(), {.threads = 2, .copies = 3, .perturb = 0.1}, 20);
}

TEST_CASE("Copies: woven ones, beside those that fill no vector", "[bits]") {
  for (const Precision precision : {Precision::double_, Precision::single_}) {
    for (const std::size_t bodies : {1u, 2u, 7u, 32u, 33u}) {
      const Scene scene = attracted(bodies, bodies == 7 ? 0 : 0.1);
      for (const std::string& target : scenarios::available_targets()) {
        check_copies(scene, {.threads = 2, .target = target, .precision = precision, .copies = 19, .perturb = 1e-2},
                     20);
      }
      check_copies(scene, {.threads = 1, .precision = precision, .copies = 16}, 3);
    }
  }
  for (const char* integrator : {"yoshida6", "ab4", "dormand_prince5", "taylor2"}) {
    Scene scene = attracted(5, 0.1);
    if (integrator == std::string("taylor2") || integrator == std::string("yoshida6")) scene.effects.resize(1);
    scene.run.integrator = integrator;
    check_copies(scene, {.threads = 2, .copies = 21, .perturb = 1e-2}, 20);
  }
}

TEST_CASE("Copies: woven ones of all sizes, in a fluid that flows", "[bits]") {
  Scene scene = attracted(7, 0.1);
  for (int i = 0; i < 7; ++i) scene.bodies[0].radius.push_back(0.3 - 0.03 * i);
  const Vector3d breeze(3, -1, 0.5);
  for (const Effect& made :
       {effect("buoyancy", {{"density", 500.0}}), effect("added_mass", {{"density", 500.0}}),
        effect("reynolds_drag", {{"density", 500.0}, {"viscosity", 0.1}}), effect("wind", {{"velocity", breeze}}),
        effect("gusts", {{"speed", 0.5}, {"velocity", breeze}})}) {
    scene.effects.push_back(made);
  }
  for (const Precision precision : {Precision::double_, Precision::single_}) {
    check_copies(scene, {.threads = 2, .precision = precision, .copies = 19, .perturb = 1e-2}, 20);
  }
  scene.run.step = 100;  // beyond the limit of drag, which the smallest body sets
  scene.run.duration = 1000;
  const ballpark::Status alone = World(scene).status();
  CHECK(alone.code == ballpark::Status::Code::stability);
  CHECK(World(scene, {.copies = 19}).status().sentence == alone.sentence);
}

TEST_CASE("Copies: what is told of woven ones, and done to them, is that of each alone", "[bits]") {
  const Scene scene = attracted(7, 0);
  World batch(scene, {.copies = 19, .perturb = 1e-2});
  batch.apply_impulse(7 * 11 + 2, {1, 2, 3});
  const ballpark::Snapshot start = batch.snapshot();
  batch.step(20);
  const ballpark::View<double> x = batch.view<double>("position");
  double potential = 0;
  for (std::size_t k = 0; k < 19; ++k) {
    Scene own = scene;
    own.run.seed += k;
    World solo(own, {.perturb = 1e-2});
    if (k == 11) solo.apply_impulse(2, {1, 2, 3});
    solo.step(20);
    potential += solo.totals().potential;
    for (std::size_t id = 0; id < 7; ++id) {
      CHECK(batch.body(7 * k + id).position == solo.body(id).position);
      CHECK(x[0][batch.row_of(7 * k + id)] == solo.body(id).position.x());
    }
  }
  CHECK(std::abs(batch.totals().potential / potential - 1) < 1e-13);
  const std::uint64_t hash = batch.state_hash();
  batch.restore(start);
  batch.step(20);
  CHECK(batch.state_hash() == hash);
}

TEST_CASE("Copies: one copy is the scene itself", "[bits]") {
  const Scene scene = random_mix();
  CHECK(World(scene, {.copies = 1}).state_hash() == World(scene).state_hash());
  CHECK(World(scene, {.copies = 2}).state_hash() != World(scene).state_hash());
}

TEST_CASE("Copies: differ by their seeds where anything is random", "[bits]") {
  const Scene scene = random_mix();
  World batch(scene, {.copies = 2});
  const std::size_t n = batch.body_count() / 2;
  CHECK((body_bits::of(batch, 0) == body_bits::of(batch, n)));
  CHECK((body_bits::of(batch, 3) != body_bits::of(batch, n + 3)));  // the cloud's first
}

TEST_CASE("Perturbation: relative, of positions and velocities, in each copy its own", "[bits]") {
  const Scene scene = scene_of({spinning(balls("s", 7))});
  const double size = 1e-3;
  const World plain(scene, {.copies = 3}), moved(scene, {.copies = 3, .perturb = size});
  bool differs = false;
  for (std::size_t id = 0; id < 21; ++id) {
    const ballpark::BodyState a = plain.body(id), b = moved.body(id);
    for (int c = 0; c < 3; ++c) {
      CHECK(std::abs(b.position[c] - a.position[c]) <= size * std::abs(a.position[c]) * (1 + 1e-9));
      CHECK(std::abs(b.velocity[c] - a.velocity[c]) <= size * std::abs(a.velocity[c]) * (1 + 1e-9));
    }
    CHECK(b.position != a.position);
    CHECK(b.velocity != a.velocity);
    CHECK(b.angular_velocity == a.angular_velocity);
    differs = differs || (id >= 7 && moved.body(id).position != moved.body(id % 7).position);
  }
  CHECK(differs);
  CHECK(moved.state_hash() == World(scene, {.copies = 3, .perturb = size}).state_hash());
  CHECK(plain.state_hash() == World(scene, {.copies = 3, .perturb = 0}).state_hash());
}
