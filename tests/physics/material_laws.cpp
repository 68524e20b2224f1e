// What materials do beyond one restitution and friction: restitution by speed, and surfaces that cling.
#include <cmath>

#include "tests/catch.h"
#include "tests/physics/contact_scenes.h"

using namespace ballpark;
using namespace contact_scenes;

namespace {

constexpr double pi = 3.14159265358979323846;

/// McNamara and Falcon 2005, eq. 1.
double restitution_at(double e, double v0, double v) {
  return v > v0 ? e * std::pow(v / v0, -0.25) : 1 - (1 - e) * std::pow(v / v0, 0.2);
}

constexpr double stiffness = 1e4, adhesion = 0.8;  // N/m, J/m^2

/// Balls of 1 kg that touch, or one on a plane, held by cohesion alone.
Scene clinging(std::vector<Vector3d> positions, double e, double step, const std::vector<double>& radius = {0.5}) {
  Scene scene = touching_scene(step, {e, 0});
  scene.contact.kind = "penalty";
  scene.contact.stiffness = stiffness;
  scene.contact.pull = true;
  scene.materials["ball"].cohesion = adhesion;
  scene.bodies = {ball_group(positions)};
  scene.bodies[0].radius = radius;
  return scene;
}

/// Two balls at the overlap where spring and cohesion balance are drawn apart by this force for a while.
double gap_after_pull(double force) {
  const double holds = 2 * pi * adhesion * 0.25;
  Scene scene = clinging({{0, 0, 0}, {1 - holds / stiffness, 0, 0}}, 0.1, 1e-3);
  World world(scene);
  world.apply_force(0, {-force, 0, 0}, 0, 1);
  world.apply_force(1, {force, 0, 0}, 0, 1);
  world.advance_to(1);
  return (world.body(1).position - world.body(0).position).norm() - 1;
}

}  // namespace

TEST_CASE("Material: restitution depends on the speed of the impact, viscoelastic below, plastic above", "[physics]") {
  const double e = 0.7, v0 = 0.5;
  for (const double v : {1e-6, 0.01, 0.3, 0.5, 0.6, 8.0, 1000.0}) {
    Scene scene = touching_scene(1e-9, {e, 0});
    scene.materials["ball"].restitution_speed = v0;
    scene.bodies = {ball_group({{0, 0, 0.5}}, {{0, 0, -v}})};
    scene.boundaries = {plane()};
    World wall(scene);
    wall.step();
    CAPTURE(v);
    CHECK(std::abs(wall.body(0).velocity.z() / (v * restitution_at(e, v0, v)) - 1) < 1e-12);

    scene.boundaries.clear();
    scene.bodies = {ball_group({{0, 0, 0}, {1, 0, 0}}, {{v, 0, 0}, {0, 0, 0}})};
    scene.bodies[0].mass = {1, 3};
    World pair(scene);
    pair.step();
    const Vector3d one = pair.body(0).velocity, two = pair.body(1).velocity;
    CHECK(std::abs((two.x() - one.x()) / (v * restitution_at(e, v0, v)) - 1) < 1e-12);
    CHECK(std::abs(one.x() + 3 * two.x() - v) < 1e-15 * (1 + v));
  }
}

TEST_CASE("Material: two laws by speed mean their geometric mean, and a pair may say otherwise", "[physics]") {
  Scene scene = touching_scene(1e-9, {0.9, 0});
  scene.materials["ball"].restitution_speed = 4;
  scene.materials["floor"] = {0.4, 0, 1, 0};
  scene.bodies = {ball_group({{0, 0, 0.5}}, {{0, 0, -0.25}})};
  scene.boundaries = {plane()};
  scene.boundaries[0].material = "floor";
  const auto after = [&] {
    World world(scene);
    world.step();
    return world.body(0).velocity.z() / 0.25;
  };
  CHECK(std::abs(after() - restitution_at(0.6, 2, 0.25)) < 1e-12);
  scene.material_pairs = {{{"ball", "floor"}, 0.5, 0, 0.125, 0}};
  CHECK(std::abs(after() - restitution_at(0.5, 0.125, 0.25)) < 1e-12);
}

TEST_CASE("Material: clinging surfaces rest at w 2 pi R* / k, and part beyond that pull", "[physics]") {
  Scene two = clinging({{0, 0, 0}, {1, 0, 0}}, 0.1, 1e-3);
  two.bodies[0].velocity = {{1e-3, 0, 0}, {0, 0, 0}};
  two.run.duration = 5;
  World world(two);
  world.advance_to(5);
  const double overlap = 1 - (world.body(1).position - world.body(0).position).norm();
  CHECK(std::abs(overlap / (2 * pi * adhesion * 0.25 / stiffness) - 1) < 1e-9);

  Scene unequal = clinging({{0, 0, 0}, {0.7 - 1e-5, 0, 0}}, 0.1, 1e-3, {0.5, 0.2});
  World small(unequal);
  small.advance_to(5);
  const double small_overlap = 0.7 - (small.body(1).position - small.body(0).position).norm();
  CHECK(std::abs(small_overlap / (2 * pi * adhesion * (0.1 / 0.7) / stiffness) - 1) < 1e-9);

  Scene hanging = clinging({{0, 0, -0.5 + 1e-6}}, 0.1, 1e-3);  // under a ceiling, R* = R
  hanging.boundaries = {plane({0, 0, 0}, {0, 0, -1})};
  const double holds = 2 * pi * adhesion * 0.5;
  for (const double weight : {0.98, 1.02}) {
    hanging.effects = {gravity({0, 0, -weight * holds})};
    hanging.bodies[0].position = {{0, 0, -0.5 + (1 - weight) * holds / stiffness}};
    World ceiling(hanging);
    ceiling.advance_to(1);
    CAPTURE(weight);
    CHECK((ceiling.body(0).position.z() > -0.5) == (weight < 1));
  }

  const double pull = 2 * pi * adhesion * 0.25;
  CHECK(gap_after_pull(0.9 * pull) < 0);
  CHECK(gap_after_pull(1.1 * pull) > 0.01);
}

TEST_CASE("Material: an elastic impact of clinging balls keeps energy, potential of cohesion included", "[physics]") {
  double last = 0;
  for (const double step : {4e-4, 1e-4}) {
    Scene scene = clinging({{0, 0, 0}, {1.01, 0, 0}}, 1, step);
    scene.bodies[0].velocity = {{0.5, 0, 0}, {-0.5, 0, 0}};
    World world(scene);
    const double start = world.totals().energy();
    double most = 0;
    while (world.time() < 0.1) {
      world.step();
      most = std::max(most, std::abs(world.totals().energy() / start - 1));
    }
    CHECK(world.counters().max_penetration > 1e-3);
    CHECK(std::abs(world.body(1).velocity.x() - 0.5) < 1e-3);
    CAPTURE(step, most);
    CHECK(most < (last == 0 ? 2e-3 : last / 2));  // of first order: the force jumps where contacts begin
    last = most;
  }
}

TEST_CASE("Material: each formulation refuses what it does not have", "[physics]") {
  const auto problem = [](const Scene& scene) {
    const std::vector<Problem> problems = check(scene);
    return problems.empty() ? std::string() : problems.front().path + ": " + problems.front().message;
  };
  Scene hard = touching_scene(1e-3, {0.5, 0});
  hard.bodies = {ball_group({{0, 0, 0}})};
  hard.materials["ball"].restitution_speed = 1;
  CHECK(problem(hard).empty());
  hard.materials["ball"].cohesion = 1;
  CHECK(problem(hard).find("materials.ball.cohesion: is given, but impulses") == 0);
  Scene soft = clinging({{0, 0, 0}}, 0.5, 1e-3);
  CHECK(problem(soft).empty());
  soft.materials["ball"].restitution_speed = 1;
  CHECK(problem(soft).find("materials.ball.restitution_speed: is given, but springs") == 0);
  soft.materials["ball"].restitution_speed = -1;
  CHECK(problem(soft).find("restitution_speed") != std::string::npos);
}
