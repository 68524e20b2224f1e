// What has nothing to do with a body changes none of its bits.
#include "tests/catch.h"
#include "tests/determinism/body_bits.h"
#include "tests/integrators.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::Path;
using ballpark::World;

namespace {

World stepped(const Scene& scene, const Options& options = {}) {
  World world(scene, options);
  world.step(50);
  return world;
}

std::vector<Effect> plain_effects() {
  return {effect("gravity"),
          effect("linear_drag", {{"coefficient", 0.2}}),
          effect("spring", {{"anchor", Vector3d(1, 1, 1)}, {"stiffness", 3.0}, {"rest_length", 0.5}}),
          effect("harmonic_trap", {{"stiffness", Vector3d(0.1, 0.7, 0.3)}}),
          effect("wind", {{"velocity", Vector3d(0.1, 0.7, 0.3)}, {"shear", Vector3d(0.3, 0.1, 0)}}),
          effect("gusts", {{"speed", 0.7}, {"velocity", Vector3d(0.1, 0.7, 0.3)}})};
}

}  // namespace

TEST_CASE("Unrelated: more bodies and groups change no bit of the others", "[bits]") {
  for (const ballpark::IntegratorDescription& integrator : ballpark::integrators()) {
    Scene few =
        ballpark::tests::run_by(scene_of({particles("p", 3), bricks("b", 5)}, plain_effects()), integrator.name);
    const World alone = stepped(few);
    Scene many = few;
    many.bodies.insert(many.bodies.begin(), particles("far", 1000));
    many.bodies.insert(many.bodies.begin() + 2, spinning(balls("s", 33)));
    many.bodies.push_back(bricks("more", 17));
    many.effects.push_back(effect("magnus", {{"coefficient", 0.3}}, {"s"}));
    many = ballpark::tests::run_by(many, integrator.name);
    const World crowd = stepped(many, {.threads = 2});
    CAPTURE(integrator.name);
    CHECK((body_bits::of(crowd, 1000, 3) == body_bits::of(alone, 0, 3)));
    CHECK((body_bits::of(crowd, 1036, 5) == body_bits::of(alone, 3, 5)));
  }
}

TEST_CASE("Unrelated: more bodies of the same group", "[bits]") {
  for (const std::size_t count : {2u, 3u, 4u, 7u, 8u, 9u, 15u, 16u, 17u, 4097u}) {
    const World alone = stepped(scene_of({bricks("b", 1)}, plain_effects()));
    const World crowd = stepped(scene_of({bricks("b", count)}, plain_effects()));
    CAPTURE(count);
    CHECK((body_bits::of(crowd, 0) == body_bits::of(alone, 0)));
  }
}

TEST_CASE("Unrelated: constants as a column or as one value", "[bits]") {
  BodyGroup equal = bricks("b", 9);
  BodyGroup listed = equal, different = equal;
  listed.mass.assign(9, 2);
  different.mass = listed.mass;
  different.mass[8] = 3;
  const World one = stepped(scene_of({equal}, plain_effects()));
  const World row_by_row = stepped(scene_of({listed}, plain_effects()));
  const World column = stepped(scene_of({different}, plain_effects()));
  CHECK(one.state_hash() == row_by_row.state_hash());
  CHECK((body_bits::of(one, 0, 8) == body_bits::of(column, 0, 8)));
  CHECK((body_bits::of(one, 8) != body_bits::of(column, 8)));
}

TEST_CASE("Unrelated: the order in which effects of different kinds are listed", "[bits]") {
  std::vector<Effect> effects = plain_effects();
  effects.push_back(effect("quadratic_drag", {{"coefficient", 0.1}}));
  effects.push_back(effect("magnus", {{"coefficient", 0.1}}));
  effects.push_back(effect("central_gravity", {{"strength", 2.0}}));
  effects.push_back(effect("force", {{"force", Vector3d(0.1, 0.7, 0.3)}, {"offset", Vector3d(0.1, 0, 0.2)}}));
  effects.push_back(effect("torque", {{"torque", Vector3d(0.1, 0.01, 0.3)}}));
  effects.push_back(effect("magnetic_field", {{"charge", 0.7}, {"field", Vector3d(0.3, 0.1, -1)}}));
  effects.push_back(effect("electric_field", {{"charge", 0.3}, {"field", Vector3d(0.3, 0.1, -1)}}));
  for (const std::string centrifugal : {"off", "on"}) {
    effects.push_back(
        effect("rotating_frame", {{"angular_velocity", Vector3d(0.1, 0.3, 0.7)}, {"centrifugal", centrifugal}}));
  }
  const std::uint64_t expected = stepped(scene_of({bricks("b", 9)}, effects)).state_hash();
  for (std::size_t turn = 1; turn < effects.size(); ++turn) {
    std::rotate(effects.begin(), effects.begin() + 1, effects.end());
    CHECK(stepped(scene_of({bricks("b", 9)}, effects)).state_hash() == expected);
  }
  std::reverse(effects.begin(), effects.end());
  CHECK(stepped(scene_of({bricks("b", 9)}, effects)).state_hash() == expected);
}

TEST_CASE("Unrelated: balls of other sizes in the same fluid", "[bits]") {
  const std::vector<Effect> fluid = {
      effect("gravity"), effect("buoyancy", {{"density", 998.0}}), effect("added_mass", {{"density", 998.0}}),
      effect("reynolds_drag", {{"density", 998.0}, {"viscosity", 1e-3}}), effect("spin_decay", {{"coefficient", 0.1}})};
  BodyGroup group = spinning(balls("b", 9));
  group.radius.assign(9, 0.1);
  for (const std::string integrator : {"rk4", "velocity_verlet", "gauss4"}) {
    const auto after = [&](const BodyGroup& made) {
      return stepped(ballpark::tests::run_by(scene_of({made}, fluid), integrator));
    };
    BodyGroup different = group;
    different.radius[8] = 0.2;
    const World one = after(group), column = after(different);
    CAPTURE(integrator);
    CHECK((body_bits::of(one, 0, 8) == body_bits::of(column, 0, 8)));
    CHECK((body_bits::of(one, 8) != body_bits::of(column, 8)));
  }
}

TEST_CASE("Unrelated: the order of several effects of one kind", "[bits]") {
  std::vector<Effect> springs;
  for (const double x : {1.0, -0.3, 7.1, 0.77}) {
    springs.push_back(effect("spring", {{"anchor", Vector3d(x, 1 / x, x * x)}, {"stiffness", 3.0 + x}}));
  }
  const std::uint64_t expected = stepped(scene_of({particles("p", 9)}, springs)).state_hash();
  for (std::size_t turn = 1; turn < springs.size(); ++turn) {
    std::rotate(springs.begin(), springs.begin() + 1, springs.end());
    CHECK(stepped(scene_of({particles("p", 9)}, springs)).state_hash() == expected);
  }
}

TEST_CASE("Unrelated: the order of groups changes no body's bits", "[bits]") {
  const World one = stepped(scene_of({particles("p", 3), bricks("b", 5), balls("s", 2)}, plain_effects()));
  const World other = stepped(scene_of({balls("s", 2), bricks("b", 5), particles("p", 3)}, plain_effects()));
  CHECK((body_bits::of(one, 0, 3) == body_bits::of(other, 7, 3)));
  CHECK((body_bits::of(one, 3, 5) == body_bits::of(other, 2, 5)));
  CHECK((body_bits::of(one, 8, 2) == body_bits::of(other, 0, 2)));
}

TEST_CASE("Unrelated: an effect that is off", "[bits]") {
  const std::uint64_t expected = stepped(scene_of({bricks("b", 9)}, plain_effects())).state_hash();
  for (const auto& [at, until] : {std::pair(-2.0, -1.0), std::pair(100.0, 101.0)}) {
    for (const auto& [kind, load] : {std::pair("force", Vector3d(1, 2, 3)), std::pair("torque", Vector3d(3, 2, 1))}) {
      std::vector<Effect> effects = plain_effects();
      effects.push_back(effect(kind, {{kind, load}, {"at", at}, {"until", until}}));
      for (const Path path : {Path::fused, Path::staged}) {
        CAPTURE(kind, at);
        CHECK(stepped(scene_of({bricks("b", 9)}, effects), {.path = path}).state_hash() == expected);
      }
    }
  }
}

TEST_CASE("Unrelated: a force on one body leaves its neighbours", "[bits]") {
  const Scene scene = scene_of({bricks("b", 9)}, plain_effects());
  const World free = stepped(scene);
  World pushed(scene);
  pushed.apply_force(4, {1, 2, 3}, 0.0625, 0.125);  // whole steps: a split one would be split for all
  pushed.apply_torque(4, {3, 2, 1}, 0.09375, 0.25);
  pushed.step(50);
  for (std::size_t id = 0; id < 9; ++id) {
    CAPTURE(id);
    CHECK((body_bits::of(free, id) == body_bits::of(pushed, id)) == (id != 4));
  }
}
