// What contacts do to each body: forces that statics and rolling give, and no trace of having been asked.
#include <cmath>

#include "tests/catch.h"
#include "tests/physics/contact_scenes.h"

using namespace ballpark;
using namespace contact_scenes;

namespace {

constexpr double g = 9.81;

Scene on_floor(const std::string& kind, const std::vector<Vector3d>& positions, const Vector3d& pull = {0, 0, -g}) {
  Scene scene = touching_scene(1e-3, {0.2, 0.5});
  scene.bodies = {ball_group(positions, {}, 0.5, 2)};
  scene.boundaries = {plane()};
  scene.effects = {gravity(pull)};
  scene.contact.kind = kind;
  if (kind == "penalty") scene.contact.stiffness = 1e5;
  return scene;
}

/// As long as dashpots need.
std::vector<ContactLoad> settled(const Scene& scene) {
  World world(scene);
  world.step(3000);
  return world.contact_loads();
}

}  // namespace

TEST_CASE("A ball at rest is held by its weight, one in flight by nothing", "[physics]") {
  for (const char* kind : {"impulse", "penalty"}) {
    CAPTURE(kind);
    Scene scene = on_floor(kind, {{0, 0, 0.5}, {3, 0, 90}});
    const std::vector<ContactLoad> loads = settled(scene);
    REQUIRE(loads.size() == 2);
    CHECK(loads[0].contacts == 1);
    CHECK(off(loads[0].force, {0, 0, 2 * g}) < 1e-6);
    CHECK(loads[1].contacts == 0);
    CHECK(loads[1].force == Vector3d::Zero());
  }
}

TEST_CASE("In a stack each ball has its neighbours as contacts, whose forces are its weight", "[physics]") {
  for (const char* kind : {"impulse", "penalty"}) {
    CAPTURE(kind);
    Scene scene = on_floor(kind, {{0, 0, 2.5}, {0, 0, 0.5}, {0, 0, 1.5}});
    if (scene.contact.kind == "impulse") scene.contact.iterations = 200;
    const std::vector<ContactLoad> loads = settled(scene);
    const std::uint32_t neighbours[] = {1, 2, 2};
    for (std::size_t id = 0; id < 3; ++id) {
      CAPTURE(id);
      CHECK(loads[id].contacts == neighbours[id]);
      CHECK(off(loads[id].force, {0, 0, 2 * g}) < 1e-3);
    }
  }
}

TEST_CASE("A ball that rolls down a slope is held back by 2/7 of the pull along it", "[physics]") {
  const double slope = 0.3;
  const Vector3d pull(g * std::sin(slope), 0, -g * std::cos(slope));
  World world(on_floor("impulse", {{0, 0, 0.5}}, pull));
  world.step(500);
  const ContactLoad load = world.contact_loads()[0];
  CHECK(load.contacts == 1);
  CHECK(off(load.force, 2 * Vector3d(-2.0 / 7 * pull.x(), 0, -pull.z())) < 1e-6);
}

TEST_CASE("Forces between two bodies are opposite", "[physics]") {
  for (const char* kind : {"impulse", "penalty"}) {
    CAPTURE(kind);
    Scene scene = on_floor(kind, {{0, 0, 0}, {0.99, 0, 0}});
    scene.boundaries.clear();
    scene.effects = {
        {.kind = "central_gravity", .groups = {}, .parameters = {{"centre", Vector3d(0, 0, 0)}, {"strength", 5.0}}}};
    scene.bodies[0].position = {{-0.495, 0.1, 0}, {0.495, -0.1, 0}};
    World world(scene);
    world.step(20);
    const std::vector<ContactLoad> loads = world.contact_loads();
    CHECK(loads[0].contacts == loads[1].contacts);
    CHECK(loads[0].force == -loads[1].force);
  }
}

TEST_CASE("Who asks for loads changes no bit, and a snapshot keeps them", "[physics]") {
  for (const char* kind : {"impulse", "penalty"}) {
    CAPTURE(kind);
    Scene scene = on_floor(kind, {{0, 0, 0.5}, {0.3, 0.1, 1.6}, {-0.5, 0.1, 2.9}, {0.2, 0.7, 0.6}});
    scene.bodies[0].velocity = {{1, 0.2, 0}, {-1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    World watched(scene), alone(scene);
    for (int i = 0; i < 300; ++i) {
      watched.step();
      watched.contact_loads();
    }
    alone.step(300);
    CHECK(watched.state_hash() == alone.state_hash());
    const Snapshot snapshot = alone.snapshot();
    const std::vector<ContactLoad> before = alone.contact_loads();
    alone.step(100);
    alone.restore(snapshot);
    const std::vector<ContactLoad> after = alone.contact_loads();
    for (std::size_t id = 0; id < before.size(); ++id) {
      CHECK(after[id].contacts == before[id].contacts);
      CHECK(off(after[id].force, before[id].force) <= 1e-9);
    }
    alone.step(50);
    watched.step(50);
    CHECK(watched.state_hash() == alone.state_hash());
  }
}

TEST_CASE("Loads go by id over groups and copies, and exist only where bodies touch", "[physics]") {
  Scene scene = on_floor("impulse", {{0, 0, 0.5}});
  BodyGroup points;
  points.name = "points";
  points.mass = {1};
  points.position = {{0, 0, 50}, {1, 0, 50}};
  scene.bodies.insert(scene.bodies.begin(), points);
  Options options;
  options.copies = 2;
  World world(scene, options);
  CHECK(world.contact_loads()[2].contacts == 0);  // no step was taken
  world.step(100);
  const std::vector<ContactLoad> loads = world.contact_loads();
  REQUIRE(loads.size() == 6);
  for (std::size_t id = 0; id < 6; ++id) CHECK(loads[id].contacts == (id % 3 == 2 ? 1 : 0));
  scene.contact.kind.clear();
  CHECK_THROWS_AS(World(scene).contact_loads(), SceneError);
}
