// The scenarios of touching balls beyond their own expectations: symmetry of the break, and what bounds its energy.
#include <cmath>

#include "ballpark/scenes.h"
#include "tests/catch.h"
#include "tests/physics/contact_scenes.h"

using namespace contact_scenes;

namespace {

Scene scenario(const std::string& name) {
  return ballpark::scenes::load(std::string(BALLPARK_SCENARIOS_FOLDER) + "/" + name + ".toml").scene;
}

/// Largest distance of a racked ball from the mirror image of its partner, in radii; y -> -y.
double asymmetry(const World& world, double radius) {
  double most = std::abs(world.body(0).position.y());
  std::size_t first = 1;  // of a row of the rack
  for (std::size_t row = 1; row <= 5; first += row++) {
    for (std::size_t k = 0; k < row; ++k) {
      Vector3d image = world.body(first + row - 1 - k).position;
      image.y() = -image.y();
      most = std::max(most, off(world.body(first + k).position, image));
    }
  }
  return most / radius;
}

}  // namespace

TEST_CASE("Break: mirror symmetric until a ball reaches a cushion, ideal or real", "[physics]") {
  for (const bool ideal : {true, false}) {
    Scene scene = scenario("break");
    if (ideal) scene.materials["ball"] = {1, 0};
    const double radius = 0.028575;
    World world(scene);
    bool at_cushion = false, broken = false;
    while (!at_cushion && world.time() < 1) {
      CAPTURE(ideal, world.time());
      REQUIRE(asymmetry(world, radius) <= 1e-9);
      world.step();
      for (std::size_t id = 0; id < 16; ++id) {
        const Vector3d x = world.body(id).position;
        at_cushion |= std::abs(x.y()) > 0.635 - 1.01 * radius || x.x() > 2.54 - 1.01 * radius;
      }
      broken |= world.body(15).velocity.norm() > 1;
    }
    CHECK(at_cushion);
    CHECK(broken);
  }
}

TEST_CASE("Break: energy only falls, and no ball leaves the table", "[physics]") {
  for (const char* name : {"break", "ball_rain"}) {
    Scene scene = scenario(name);
    if (scene.bodies[0].generate) scene.bodies[0].generate->count = {10, 10, 10};
    World world(scene);
    const double start = world.totals().energy(), scale = world.totals().kinetic + std::abs(start);
    for (int i = 0; i < 40; ++i) {
      world.step(scene.bodies[0].generate ? 15 : 50);
      const ballpark::Totals now = world.totals();
      CAPTURE(name, world.time());
      CHECK(now.energy() <= start + 1e-3 * scale);
      CHECK(now.bodies_outside == 0);
      CHECK(now.non_finite_bodies == 0);
    }
    CHECK(world.totals().energy() < start);
  }
}
