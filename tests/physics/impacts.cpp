// Impacts under `impulse`, in worlds: the worked cases of two balls, simultaneous impacts, rows of balls, and bodies
// too fast for their step.
#include <cmath>

#include "tests/catch.h"
#include "tests/physics/contact_scenes.h"

using namespace contact_scenes;

namespace {

struct Ball {
  double mass, radius;
  Vector3d velocity, spin;
};

/// Ball 1 touches ball 2, or (mass 0) a wall, in the direction n; one step.
std::pair<BodyState, BodyState> after_impact(const Ball& one, const Ball& two, const Vector3d& n, const Law& law) {
  Scene scene = touching_scene(1e-9, law);
  const Vector3d unit = n.normalized();
  BodyGroup group = ball_group({{0, 0, 0}}, {one.velocity}, one.radius, one.mass);
  group.angular_velocity = {one.spin};
  if (two.mass > 0) {
    group.position.push_back((one.radius + two.radius) * unit);
    group.velocity.push_back(two.velocity);
    group.angular_velocity.push_back(two.spin);
    group.radius = {one.radius, two.radius};
    group.mass = {one.mass, two.mass};
  } else {
    scene.boundaries = {plane(one.radius * unit, -unit)};
  }
  scene.bodies = {group};
  World world(scene);
  world.step();
  return {world.body(0), world.body(two.mass > 0 ? 1 : 0)};
}

void check(const BodyState& state, const Vector3d& v, const Vector3d& w) {
  CHECK(off(state.velocity, v) <= 1e-12);
  CHECK(off(state.angular_velocity, w) <= 1e-12 * std::max(1.0, w.norm()));
}

}  // namespace

TEST_CASE("Impacts: two balls that slide, stick, and differ, and a ball and a wall", "[physics]") {
  const Ball still{1, 0.5, {0, 0, 0}, {0, 0, 0}};
  auto [a1, a2] = after_impact({1, 0.5, {2, 1, 0}, {0, 0, 3}}, still, {1, 0, 0}, {0.9, 0.1});
  check(a1, {.1, .81, 0}, {0, 0, 2.05});
  check(a2, {1.9, .19, 0}, {0, 0, -.95});
  auto [b1, b2] = after_impact({1, 0.5, {2, .3, 0}, {0, .4, .2}}, still, {1, 0, 0}, {0.9, 0.3});
  check(b1, {.1, 1.7 / 7, .2 / 7}, {0, 1.8 / 7, -.6 / 7});
  check(b2, {1.9, .4 / 7, -.2 / 7}, {0, -1.0 / 7, -2.0 / 7});
  auto [c1, c2] =
      after_impact({2, .1, {1, -.5, .25}, {5, -3, 8}}, {.5, .063, {-.4, .2, .1}, {-2, 12, 7}}, {2, 1, 2}, {.75, .2});
  check(c1, {.77177863071391, -.571997893767394, .0942203161697874},
        {4.9018008642048, -4.20736142426463, 8.70187984792752});
  check(c2, {.512885477144362, .487991575069576, .72311873532085},
        {-2.62348657647748, 4.33421317927219, 11.4563799868414});
  auto [d, same] = after_impact({.17, .028575, {1.5, -2, 0}, {10, 0, -40}}, {}, {0, -1, 0}, {.85, .2});
  check(d, {1.398, 1.7, .0816428571428572}, {2.85714285714286, 0, -48.9238845144357});
}

TEST_CASE("Impacts: one ball into two that touch is simultaneous", "[physics]") {
  Scene scene = touching_scene(1e-9, {1, 0});
  const double x = std::sqrt(0.75);
  scene.bodies = {ball_group({{0, 0, 0}, {x, 0.5, 0}, {x, -0.5, 0}}, {{1, 0, 0}, {0, 0, 0}, {0, 0, 0}})};
  World world(scene);
  world.step();
  const double speed = 0.692820323027551;
  CHECK(off(world.body(0).velocity, {-0.2, 0, 0}) <= 1e-12);
  CHECK(off(world.body(1).velocity, {speed * x, speed / 2, 0}) <= 1e-12);
  CHECK(off(world.body(2).velocity, {speed * x, -speed / 2, 0}) <= 1e-12);
}

TEST_CASE("Impacts: touching rows of any length pass the velocity to the last ball", "[physics]") {
  for (const std::size_t count : {2u, 3u, 5u, 40u, 300u}) {
    Scene scene = touching_scene(1e-3, {1, 0});
    std::vector<Vector3d> positions, velocities(count, Vector3d(0, 0, 0));
    for (std::size_t i = 0; i < count; ++i) positions.push_back({static_cast<double>(i), 0, 0});
    velocities[0] = {1, 0, 0};
    scene.bodies = {ball_group(positions, velocities)};
    World world(scene);
    world.step(3);
    CAPTURE(count);
    for (std::size_t i = 0; i < count; ++i) {
      CHECK(off(world.body(i).velocity, {i + 1 == count ? 1.0 : 0.0, 0, 0}) <= 1e-12);
    }
  }
}

TEST_CASE("Impacts: a moving ball and a resting one exchange velocities, slow or fast", "[physics]") {
  for (const double speed : {1e-9, 1e-3, 0.1, 10.0, 1e4}) {
    Scene scene = touching_scene(1e-3, {1, 0});
    const double gap = 0.37 * speed * scene.run.step;
    scene.bodies = {ball_group({{0, 0, 0}, {1 + gap, 0, 0}}, {{speed, 0, 0}, {0, 0, 0}})};
    World world(scene);
    world.step(2);
    CAPTURE(speed);
    CHECK(off(world.body(0).velocity, {0, 0, 0}) <= 1e-12 * speed);
    CHECK(off(world.body(1).velocity, {speed, 0, 0}) <= 1e-12 * speed);
  }
}

TEST_CASE("Impacts: momentum and energy at e = 1, momentum alone below", "[physics]") {
  for (const double e : {1.0, 0.5, 0.0}) {
    Scene scene = touching_scene(1e-2, {e, 0});
    BodyGroup group = ball_group({}, {}, 0.05, 0.1);
    group.generate =
        ballpark::Generate{.kind = "lattice", .count = {6, 6, 6}, .spacing = 0.11, .velocity_spread = {1, 1, 1}};
    scene.bodies = {group};
    World world(scene);
    const ballpark::Totals before = world.totals();
    world.step(100);
    const ballpark::Totals after = world.totals();
    CAPTURE(e);
    CHECK(world.counters().impacts > 100);
    CHECK((after.momentum - before.momentum).norm() <= 1e-13 * before.momentum_scale);
    CHECK(after.kinetic <= before.kinetic * (1 + 1e-12));
    if (e == 1) CHECK(after.kinetic >= before.kinetic * (1 - 1e-12));
    if (e < 1) CHECK(after.kinetic < before.kinetic);
  }
}

TEST_CASE("Impacts: angular momentum is kept to the order of the step", "[physics]") {
  double drift[2];
  for (int k = 0; k < 2; ++k) {
    Scene scene = touching_scene(k == 0 ? 1e-3 : 1e-4, {1, 0.3});
    scene.bodies = {ball_group({{0, 0, 0}, {1.2003, 0.4, 0.1}}, {{5, 0, 0}, {-1, 0, 2}})};
    scene.bodies[0].angular_velocity = {{1, 2, 3}};
    World world(scene);
    const ballpark::Totals before = world.totals();
    world.step(k == 0 ? 100 : 1000);
    CHECK(world.counters().impacts == 1);
    drift[k] = (world.totals().angular_momentum - before.angular_momentum).norm() / before.angular_momentum_scale;
  }
  CHECK(drift[0] <= 5e-3);
  CHECK(drift[1] <= 5e-4);
}

TEST_CASE("Impacts: nothing tunnels at a thousand diameters a step", "[physics]") {
  const double speed = 1e6;  // balls of 1 m, steps of 1 ms
  const auto last = [&](const std::vector<Vector3d>& positions, const std::vector<Boundary>& walls) {
    Scene scene = touching_scene(1e-3, {1, 0});
    std::vector<Vector3d> velocities(positions.size(), Vector3d(0, 0, 0));
    velocities[0] = {speed, 0, 0};
    scene.bodies = {ball_group(positions, velocities)};
    scene.boundaries = walls;
    World world(scene);
    world.step();
    return std::pair{world.body(0).velocity, world.body(positions.size() - 1).velocity};
  };
  // A ball on the way, hit full, and at half a radius off the centre: n = (sqrt(15) / 4, 1 / 4, 0).
  CHECK(off(last({{0, 0, 0}, {500, 0, 0}}, {}).second, {speed, 0, 0}) <= 1e-9 * speed);
  const Vector3d n(std::sqrt(15.0) / 4, 0.25, 0);
  const auto [off_centre, struck] = last({{0, 0, 0}, {500, 0.25, 0}}, {});
  CHECK(off(struck, speed * n.x() * n) <= 1e-9 * speed);
  CHECK(off(off_centre, Vector3d(speed, 0, 0) - speed * n.x() * n) <= 1e-9 * speed);
  // One that is passed by is not touched.
  CHECK(last({{0, 0, 0}, {500, 1.001, 0}}, {}).second == Vector3d(0, 0, 0));
  // A plane, a thin plate, the inside of a tube.
  CHECK(off(last({{0, 0, 0}}, {plane({700, 0, 0}, {-1, 0, 0})}).first, {-speed, 0, 0}) <= 1e-9 * speed);
  Boundary plate;
  plate.shape = "box", plate.side = "outside", plate.point = {321, 0, 0}, plate.size = {1e-3, 2, 2};
  CHECK(off(last({{0, 0, 0}}, {plate}).first, {-speed, 0, 0}) <= 1e-9 * speed);
  Boundary tube;
  tube.shape = "tube", tube.normal = {0, 0, 2}, tube.radius = 1200.5, tube.point = {-700, 0, 5};
  CHECK(off(last({{0, 0, 0}}, {tube}).first, {-speed, 0, 0}) <= 1e-9 * speed);
}

TEST_CASE("Impacts: a ball that is struck does not pass through the next one", "[physics]") {
  // Ball 1 leaves at 10 m/s, which nobody foresaw when contacts were found; ball 2 is 3 diameters on, a step is 10.
  Scene scene = touching_scene(1, {1, 0});
  scene.bodies = {ball_group({{0, 0, 0}, {1.5, 0, 0}, {5, 0, 0}}, {{10, 0, 0}, {0, 0, 0}, {0, 0, 0}})};
  World world(scene);
  for (int i = 0; i < 6; ++i) {
    world.step();
    for (std::size_t id = 0; id < 2; ++id) {
      CHECK((world.body(id + 1).position - world.body(id).position).x() >= 1 - 1e-12);
    }
  }
  CHECK(off(world.body(2).velocity, {10, 0, 0}) <= 1e-9);
  CHECK(world.counters().missed == 0);
}
