// The penalty formulation: closed forms of spring-dashpot contacts, what they keep, and the largest stable step.
#include <cmath>

#include "tests/catch.h"
#include "tests/integrators.h"
#include "tests/physics/contact_scenes.h"

using namespace ballpark;
using namespace contact_scenes;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double stiffness = 1e6;  // N/m, for balls of 1 kg and 0.5 m

Scene soft(double step, const Law& law, const std::string& integrator = "rk4") {
  Scene scene = touching_scene(step, law, integrator);
  scene.contact.kind = "penalty";
  scene.contact.stiffness = stiffness;
  return scene;
}

std::vector<std::string> one_step_integrators() {
  std::vector<std::string> names;
  Scene scene = soft(1e-3, {0.5, 0.3});
  scene.bodies = {ball_group({{0, 0, 0}})};
  for (const IntegratorDescription& row : ballpark::tests::integrators_for(scene)) names.push_back(row.name);
  return names;
}

/// Two balls of 1 kg meet head on at a relative speed of 1 m/s; steps for each undamped contact.
struct Impact {
  double restitution, longest, deepest;
};
Impact impact(double e, bool pull, const std::string& integrator, double steps) {
  const double contact = pi * std::sqrt(0.5 / stiffness), h = contact / steps;
  Scene scene = soft(h, {e, 0}, integrator);
  scene.contact.pull = pull;
  scene.bodies = {ball_group({{0, 0, 0}, {1 + 0.37 * h, 0, 0}}, {{1, 0, 0}, {0, 0, 0}})};
  World world(scene);
  double touched = 0;
  for (int i = 0; i < 3 * steps; ++i) {
    world.step(1);
    touched += world.body(1).position.x() - world.body(0).position.x() < 1 ? h : 0;
  }
  return {world.body(1).velocity.x() - world.body(0).velocity.x(), touched, world.counters().max_penetration};
}

}  // namespace

TEST_CASE("Penalty: an impact ends with the restitution of its materials, under every integrator", "[physics]") {
  for (const std::string& integrator : one_step_integrators()) {
    for (const double e : {0.05, 0.4509754529, 0.9}) {
      for (const bool pull : {false, true}) {
        CAPTURE(integrator, e, pull);
        // The dashpot's jump at the first touch leaves first order.
        for (const double steps : {1000, 8000}) {
          CHECK(std::abs(impact(e, pull, integrator, steps).restitution - e) < 5 / steps);
        }
      }
    }
  }
}

TEST_CASE("Penalty: an elastic impact is half a swing, of energy kept", "[physics]") {
  const double w = std::sqrt(stiffness / 0.5);
  const Impact made = impact(1, false, "velocity_verlet", 2000);
  CHECK(std::abs(made.restitution - 1) < 1e-6);
  CHECK(std::abs(made.longest - pi / w) < 2e-3 * pi / w);
  CHECK(std::abs(made.deepest - 1 / w) < 1e-5 / w);
}

TEST_CASE("Penalty: a damped contact goes as deep as its closed form says", "[physics]") {
  // At b = 0.3, from x'' = -w^2 x - 2 b w x', x'(0) = v: exp(-b/s atan(s/b)) v/w, s = sqrt(1 - b^2).
  const double b = 0.3, s = std::sqrt(1 - b * b), w = std::sqrt(stiffness / 0.5);
  const Impact made = impact(0.4509754529, false, "rk4", 4000);
  CHECK(std::abs(made.deepest - std::exp(-b / s * std::atan2(s, b)) / w) < 1e-3 / w);
}

TEST_CASE("Penalty: steep sliding impacts give friction mu times the whole push", "[physics]") {
  // Without damping a contact slips from beginning to end if slip / approach > 7/2 mu (tangential stiffness 2/7).
  const double h = 2e-6, mu = 0.1;
  Scene scene = soft(h, {1, mu});
  scene.contact.stiffness = 1e8;
  scene.bodies = {ball_group({{0, 0, 0.5 + 0.3 * h}}, {{3, 0, -1}})};
  scene.boundaries = {plane()};
  World world(scene);
  world.step(2000);
  const BodyState end = world.body(0);
  CHECK(std::abs(end.velocity.z() - 1) < 1e-4);
  CHECK(std::abs(end.velocity.x() - (3 - 2 * mu)) < 1e-3);
  CHECK(std::abs(end.angular_velocity.y() - 2 * mu / (0.4 * 0.5)) < 4e-3);
}

TEST_CASE("Penalty: a contact that sticks turns the slip round, under every integrator", "[physics]") {
  // Both springs swing alike at a tangential stiffness of 2/7: the slip u leaves as -u, by an impulse of 2 (2/7) m u.
  for (const std::string& integrator : one_step_integrators()) {
    if (integrator == "euler") continue;  // gains energy in every contact that nothing damps
    const double h = 2e-6;
    Scene scene = soft(h, {1, 2}, integrator);
    scene.contact.stiffness = 1e8;
    scene.bodies = {ball_group({{0, 0, 0.5 + 0.3 * h}}, {{1, 0, -1}})};
    scene.boundaries = {plane()};
    World world(scene);
    world.step(2000);
    const BodyState end = world.body(0);
    CAPTURE(integrator);
    CHECK(std::abs(end.velocity.x() - (1 - 4.0 / 7)) < 4e-3);
    CHECK(std::abs(end.velocity.x() - end.angular_velocity.y() * 0.5 + 1) < 1e-2);
  }
}

TEST_CASE("Penalty: what slips a little on a floor comes to rest, up to the stable step", "[physics]") {
  // z = h sqrt(k / m), below the limit of each: the tangential spring swings as the normal one does.
  const double lever = 0.5 - 9.81 / stiffness;
  for (const char* integrator : {"semi_implicit_euler", "velocity_verlet", "rk4"}) {
    for (const double z : {0.3, 1.2}) {
      Scene scene = soft(z / std::sqrt(stiffness), {0.7, 0.5}, integrator);
      scene.bodies = {ball_group({{0, 0, 0.5 - 9.81 / stiffness}}, {{1e-6, 0, 0}})};
      scene.boundaries = {plane()};
      scene.effects = {gravity()};
      World world(scene);
      world.step(2000);
      const BodyState end = world.body(0);
      CAPTURE(integrator, z);
      CHECK(std::abs(end.velocity.x() - end.angular_velocity.y() * lever) < 1e-12);
      CHECK(world.status().code == Status::Code::ok);
    }
  }
}

TEST_CASE("Penalty: oblique impacts keep momentum and angular momentum", "[physics]") {
  Scene scene = soft(1e-5, {0.7, 0.4}, "velocity_verlet");
  scene.bodies = {
      ball_group({{0, 0, 0}, {1.01, 0.3, 0.1}, {0.2, 1.1, -0.2}}, {{1, 0.4, 0}, {-1, 0, 0.2}, {0, -1.5, 0.3}})};
  scene.bodies[0].angular_velocity = {{3, -2, 10}, {0, 4, -6}, {1, 1, 1}};
  World world(scene);
  const Totals before = world.totals();
  world.step(40000);
  const Totals after = world.totals();
  CHECK(world.counters().contacts > 100);
  CHECK((after.momentum - before.momentum).norm() < 1e-13 * before.momentum_scale);
  CHECK((after.angular_momentum - before.angular_momentum).norm() < 1e-12 * before.angular_momentum_scale);
  CHECK(after.energy() < before.energy());
}

TEST_CASE("Penalty: a ball on a slope rolls or slides as its friction lets it", "[physics]") {
  const double angle = 20 * pi / 180, g = 9.81, h = 1e-4;
  for (const double mu : {0.3, 0.05}) {
    CAPTURE(mu);
    Scene scene = soft(h, {0.3, mu});
    const Vector3d down(std::cos(angle), 0, -std::sin(angle)), normal(std::sin(angle), 0, std::cos(angle));
    const double sunk = g * std::cos(angle) / stiffness;
    scene.bodies = {ball_group({(0.5 - sunk) * normal})};
    scene.boundaries = {plane({0, 0, 0}, normal)};
    scene.effects = {gravity({0, 0, -g})};
    World world(scene);
    world.step(5000);
    const BodyState first = world.body(0);
    world.step(5000);
    const BodyState second = world.body(0);
    const double time = 5000 * h;
    const double a = (second.velocity - first.velocity).dot(down) / time;
    const double turning = (second.angular_velocity - first.angular_velocity).y() / time;
    const bool rolls = mu > 2.0 / 7 * std::tan(angle);
    const double exact = rolls ? 5.0 / 7 * g * std::sin(angle) : g * (std::sin(angle) - mu * std::cos(angle));
    const double exact_turning = rolls ? exact / 0.5 : 2.5 * mu * g * std::cos(angle) / 0.5;
    CHECK(std::abs(a - exact) < 1e-4 * exact);
    CHECK(std::abs(turning - exact_turning) < 1e-4 * exact_turning);
  }
}

TEST_CASE("Penalty: a column at rest presses the floor with its weight", "[physics]") {
  const std::size_t count = 5;
  Scene scene = soft(2e-4, {0.1, 0.5}, "velocity_verlet");
  std::vector<Vector3d> places;
  for (std::size_t i = 0; i < count; ++i) places.push_back({0, 0, 0.5 + static_cast<double>(i)});
  scene.bodies = {ball_group(places)};
  scene.boundaries = {plane()};
  scene.effects = {gravity()};
  World world(scene);
  world.step(20000);
  double below = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = world.body(i).position.z(), depth = i == 0 ? 0.5 - z : 1 - (z - below);
    below = z;
    const double weight = 9.81 * static_cast<double>(count - i);
    CHECK(std::abs(depth * stiffness - weight) < 1e-6 * weight);
    CHECK(world.body(i).velocity.norm() < 1e-9);
  }
}

TEST_CASE("Penalty: the largest stable step is that of the contact, and exceeding it is reported", "[physics]") {
  // Undamped, velocity Verlet: 2 / w, w^2 = k (1/m + 1/m); rk4: 2.828427 / w.
  const double w = std::sqrt(2 * stiffness);
  const auto code = [&](double zw, const std::string& integrator, std::vector<Vector3d> places) {
    Scene scene = soft(zw / w, {1, 0}, integrator);
    scene.bodies = {ball_group(places)};
    World world(scene);
    const double limit = integrator == "rk4" ? 2 * std::sqrt(2.0) : integrator == "euler" ? 0 : 2;
    CHECK(std::abs(world.explain().contact.largest_step * w - limit) < 1e-6);
    world.step(3);
    return world.status().code;
  };
  const std::vector<Vector3d> two{{0, 0, 0}, {0.999, 0, 0}}, three{{0, 0, 0}, {0.999, 0, 0}, {1.998, 0, 0}};
  CHECK(code(1.99, "velocity_verlet", two) == Status::Code::ok);
  CHECK(code(2.01, "velocity_verlet", two) == Status::Code::stability);
  CHECK(code(2.82, "rk4", two) == Status::Code::ok);
  CHECK(code(2.84, "rk4", two) == Status::Code::stability);
  // Three in a row: w^2 = 3 k / m, found when they touch.
  CHECK(code(1.6, "velocity_verlet", three) == Status::Code::ok);
  CHECK(code(1.8, "velocity_verlet", three) == Status::Code::stability);
  // Explicit Euler gains energy in every contact that nothing damps.
  CHECK(code(0.1, "euler", two) == Status::Code::stability);
}

TEST_CASE("Penalty: the skin changes no bit, only how often neighbours are searched", "[physics]") {
  const auto run = [](double margin) {
    Scene scene = soft(1e-4, {0.5, 0.4}, "velocity_verlet");
    scene.contact.margin = margin;
    BodyGroup balls = ball_group({});
    balls.generate = Generate{.kind = "lattice",
                              .count = {4, 4, 4},
                              .origin = {0.6, 0.6, 0.6},
                              .spacing = 1.05,
                              .velocity_spread = {2, 2, 2},
                              .angular_velocity_spread = {3, 3, 3}};
    scene.bodies = {balls};
    Boundary box;
    box.shape = "box", box.point = {2.3, 2.3, 2.3}, box.size = {4.6, 4.6, 4.6}, box.material = "ball";
    scene.boundaries = {box};
    scene.effects = {gravity()};
    World world(scene);
    world.step(3000);
    CHECK(world.counters().contacts > 10000);
    return std::pair(world.state_hash(), world.counters().neighbour_lists);
  };
  const auto thin = run(0.01), thick = run(0.5);
  CHECK(thin.first == thick.first);
  CHECK(thin.second > 5 * thick.second);
}

TEST_CASE("Penalty: no contact gains energy, in a box that is shut and one that repeats", "[physics]") {
  for (const bool repeats : {false, true}) {
    Scene scene = soft(5e-5, {repeats ? 1.0 : 0.6, repeats ? 0.0 : 0.5}, "velocity_verlet");
    BodyGroup balls = ball_group({});
    balls.generate = Generate{
        .kind = "lattice", .count = {5, 5, 5}, .origin = {0.6, 0.6, 0.6}, .spacing = 1.1, .velocity_spread = {2, 2, 2}};
    scene.bodies = {balls};
    Boundary space;
    space.shape = repeats ? "periodic" : "box", space.point = {2.8, 2.8, 2.8}, space.size = {5.6, 5.6, 5.6};
    if (!repeats) space.material = "ball";
    scene.boundaries = {space};
    World world(scene);
    const Totals before = world.totals();
    double most = 0;
    for (int i = 0; i < 40; ++i) {
      world.step(200);
      most = std::max(most, world.totals().energy());
    }
    const Totals after = world.totals();
    CAPTURE(repeats, before.energy(), after.energy());
    CHECK(world.counters().contacts > 1000);
    CHECK(most < before.energy() * (1 + 1e-3));
    CHECK(after.bodies_outside == 0);
    if (!repeats) continue;
    CHECK(std::abs(after.energy() - before.energy()) < 1e-3 * before.energy());
    CHECK((after.momentum - before.momentum).norm() < 1e-12 * before.momentum_scale);
  }
}

TEST_CASE("Penalty: a conveyor and a moving wall carry balls along", "[physics]") {
  Scene scene = soft(1e-4, {0.3, 0.5});
  scene.bodies = {ball_group({{0, 0, 0.5}})};
  scene.boundaries = {plane()};
  scene.boundaries[0].surface_velocity = {1, 0, 0};
  scene.boundaries[0].motion = Motion{.velocity = {0, 0.5, 0}};
  scene.effects = {gravity()};
  World world(scene);
  world.step(10000);
  // It slides, then rolls: 2/7 of the surface's speed for a ball that did not turn.
  CHECK((world.body(0).velocity - Vector3d(2.0 / 7, 1.0 / 7, 0)).norm() < 1e-3);
}

TEST_CASE("Penalty: bodies that go farther than their radius in a step are counted", "[physics]") {
  Scene scene = soft(1e-4, {1, 0});
  scene.bodies = {ball_group({{0, 0, 0}, {40, 0, 0}}, {{8000, 0, 0}, {0, 0, 0}})};
  World world(scene);
  world.step(50);
  CHECK(world.counters().missed > 0);
}
