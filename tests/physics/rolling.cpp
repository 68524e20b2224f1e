// Lasting contact under `impulse`: rest, the bouncing ball's end, rolling and slipping, moving boundaries.
#include <Eigen/Geometry>
#include <cmath>

#include "tests/catch.h"
#include "tests/physics/contact_scenes.h"

using namespace contact_scenes;

namespace {

constexpr double g = 9.81;
const std::vector<std::string> all_integrators{"euler", "semi_implicit_euler", "velocity_verlet", "midpoint", "rk4"};

/// A ball of radius R on the plane z = 0, under gravity that may lean.
Scene ball_on_table(double step, double mu, const Vector3d& velocity, const Vector3d& spin, double radius,
                    const Vector3d& pull = {0, 0, -g}, const std::string& integrator = "rk4") {
  Scene scene = touching_scene(step, {0.5, mu}, integrator);
  BodyGroup group = ball_group({{0, 0, radius}}, {velocity}, radius, 0.17);
  group.angular_velocity = {spin};
  scene.bodies = {group};
  scene.boundaries = {plane()};
  scene.effects = {gravity(pull)};
  return scene;
}

BodyState after(const Scene& scene, double time) {
  World world(scene);
  world.step(static_cast<std::uint64_t>(std::llround(time / scene.run.step)));
  return world.body(0);
}

}  // namespace

TEST_CASE("Rest: a ball on a floor has no velocity and does not move, under every integrator", "[physics]") {
  for (const std::string& integrator : all_integrators) {
    for (const double step : {1e-4, 1e-2, 1.0 / 60}) {
      const Scene scene = ball_on_table(step, 0.3, {0, 0, 0}, {0, 0, 0}, 0.1, {0, 0, -g}, integrator);
      World world(scene);
      for (int i = 0; i < 50; ++i) {
        world.step();
        CAPTURE(integrator, step, i);
        REQUIRE(world.body(0).velocity.norm() <= 1e-15);
        REQUIRE(std::abs(world.body(0).position.z() - 0.1) <= 1e-15);
      }
    }
  }
}

TEST_CASE("Rest: a bouncing ball comes to rest when theory says, having gone as far", "[physics]") {
  for (const double step : {1e-4, 1e-5}) {
    Scene scene = touching_scene(step, {0.8, 0});
    scene.bodies = {ball_group({{0, 0, 1.1}}, {}, 0.1)};
    scene.boundaries = {plane()};
    scene.effects = {gravity()};
    World world(scene);
    double path = 0, height = 1.1, last_moving = 0;
    while (world.time() < 4.2) {
      world.step();
      const BodyState ball = world.body(0);
      path += std::abs(ball.position.z() - height);
      height = ball.position.z();
      if (ball.velocity.z() != 0) last_moving = world.time();
    }
    CAPTURE(step);
    CHECK(std::abs(last_moving - 4.0637127688715781) <= 50 * step);
    CHECK(std::abs(path - 4.5555555555555556) <= 50 * step);
    CHECK(std::abs(height - 0.1) <= 1e-6);
    if (step <= 1e-5) CHECK((std::abs(last_moving - 4.0637127688715781) <= 1e-3 && std::abs(path - 41.0 / 9) <= 1e-3));
  }
}

TEST_CASE("Rolling: a sliding ball slows, spins up, and rolls on with 5/7 of its speed", "[physics]") {
  const double mu = 0.2, radius = 0.028575, rolls_at = 2 * 2 / (7 * mu * g), distance = 12 * 4 / (49 * mu * g);
  for (const double step : {1e-3, 1e-4}) {
    const Scene scene = ball_on_table(step, mu, {2, 0, 0}, {0, 0, 0}, radius);
    const BodyState sliding = after(scene, 0.2);
    CHECK(std::abs(sliding.velocity.x() - (2 - mu * g * 0.2)) <= 1e-9);
    CHECK(std::abs(sliding.angular_velocity.y() - 2.5 * mu * g * 0.2 / radius) <= 1e-9);
    const BodyState rolling = after(scene, 0.5);
    CHECK(std::abs(rolling.velocity.x() - 10.0 / 7) <= 1e-9);
    CHECK(std::abs(rolling.velocity.x() - radius * rolling.angular_velocity.y()) <= 1e-12);
    CHECK(std::abs(rolling.position.x() - (distance + 10.0 / 7 * (0.5 - rolls_at))) <= step);
  }
}

TEST_CASE("Rolling: a ball that spins about another axis slides on a parabola", "[physics]") {
  const double mu = 0.2, radius = 0.028575, rolls_at = 0.260682813872375;
  double error[2];
  for (int k = 0; k < 2; ++k) {
    const double step = k == 0 ? 2e-4 : 1e-4;
    const Scene scene = ball_on_table(step, mu, {1, 0, 0}, {30, -20, 0}, radius);
    const double before = 0.2, slip = 1.7901088828616;
    const Vector3d u = Vector3d(1, 0, 0) + Vector3d(30, -20, 0).cross(Vector3d(0, 0, -radius));
    CHECK(std::abs(u.norm() - slip) <= 1e-12);
    CHECK(off(after(scene, before).velocity, Vector3d(1, 0, 0) - mu * g * before / slip * u) <= 1e-9);
    const BodyState end = after(scene, 0.3);
    const Vector3d rolling(.551, -.244928571428571, 0);
    CHECK(off(end.velocity, rolling) <= 1e-9);
    const Vector3d there = Vector3d(.202159522158027, -.0319243345988705, radius) + (0.3 - rolls_at) * rolling;
    error[k] = off(end.position, there);
    CHECK(error[k] <= 1e-3 * there.norm());
  }
  CHECK(error[1] <= error[0]);
}

TEST_CASE("Rolling: a slope, gripped or not", "[physics]") {
  const double angle = 0.34906585039886592, radius = 0.1;  // 20 degrees
  const Vector3d pull(g * std::sin(angle), 0, -g * std::cos(angle));
  for (const std::string& integrator : all_integrators) {
    CAPTURE(integrator);
    const double step = 1e-3;
    for (const double mu : {0.2, 0.3, 5.0}) {
      const BodyState rolls = after(ball_on_table(step, mu, {0, 0, 0}, {0, 0, 0}, radius, pull, integrator), 1);
      CHECK(std::abs(rolls.velocity.x() - 2.39658400430344) <= 1e-9);
      CHECK(std::abs(rolls.velocity.x() - radius * rolls.angular_velocity.y()) <= 1e-12);
      CHECK(std::abs(rolls.position.x() - 2.39658400430344 / 2) <= 2 * step);
    }
    const double mu = 0.05, slide = g * (std::sin(angle) - mu * std::cos(angle));
    const BodyState slips = after(ball_on_table(step, mu, {0, 0, 0}, {0, 0, 0}, radius, pull, integrator), 1);
    CHECK(std::abs(slips.velocity.x() - slide) <= 1e-9);
    CHECK(std::abs(slips.angular_velocity.y() - 2.5 * mu * g * std::cos(angle) / radius) <= 1e-8);
    CHECK(std::abs(slips.position.x() - slide / 2) <= 2 * step);
  }
}

TEST_CASE("Boundaries: a racket and a conveyor", "[physics]") {
  Scene racket = touching_scene(1e-3, {1, 0});
  racket.bodies = {ball_group({{0, 0, 0.6}}, {{0, 0, -1}})};
  racket.boundaries = {plane()};
  racket.boundaries[0].motion = ballpark::Motion{.velocity = {0, 0, 2}};
  CHECK(off(after(racket, 0.2).velocity, {0, 0, 5}) <= 1e-12);  // 2 V - v
  Scene belt = ball_on_table(1e-3, 0.2, {0, 0, 0}, {0, 0, 0}, 0.1);
  belt.boundaries[0].surface_velocity = {1, 0, 0};
  const BodyState carried = after(belt, 1);  // rolls against the belt: 2/7 of its speed
  CHECK(std::abs(carried.velocity.x() - 2.0 / 7) <= 1e-9);
  CHECK(std::abs(carried.velocity.x() - 0.1 * carried.angular_velocity.y() - 1) <= 1e-12);
}

TEST_CASE("Boundaries: a ball stays on a floor that swings gently, and is thrown by one that swings hard",
          "[physics]") {
  Scene scene = touching_scene(1e-3, {0.5, 0});
  scene.bodies = {ball_group({{0, 0, 0.5}})};
  scene.boundaries = {plane()};
  scene.effects = {gravity()};
  const double turn = 6.283185307179586, frequency = 5;
  for (const double of_g : {0.5, 0.9, 1.5}) {
    const double amplitude = of_g * g / (turn * turn * frequency * frequency);
    scene.boundaries[0].motion =
        ballpark::Motion{.amplitude = {0, 0, amplitude}, .frequency = frequency, .phase = turn / 4};
    World world(scene);
    double highest = 0;
    for (int i = 0; i < 1000; ++i) {
      world.step();
      const double floor = amplitude * (std::cos(turn * frequency * world.time()) - 1);
      highest = std::max(highest, world.body(0).position.z() - 0.5 - floor);
      REQUIRE(world.body(0).position.z() - 0.5 - floor >= -1e-9);
    }
    CAPTURE(of_g);
    if (of_g < 1) CHECK(highest <= 1e-4);
    if (of_g > 1) CHECK(highest >= 1e-3);
  }
}
