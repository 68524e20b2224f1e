// Steps chosen by a tolerance: how the error follows it, and that runs land, repeat, split and end as they should.
#include "tests/catch.h"
#include "tests/methods/rows.h"
#include "tests/physics/problems.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

std::vector<std::string> pairs() {
  std::vector<std::string> names;
  for (const IntegratorDescription& row : integrators()) {
    if (row.adaptive) names.push_back(row.name);
  }
  return names;
}

Scene at_tolerance(Scene made, const std::string& integrator, double tolerance) {
  made.run.integrator = integrator;
  made.run.tolerance = tolerance;
  made.run.step = 0;
  return made;
}

World at_end(const Scene& made, const Options& options = {}) {
  World world(made, options);
  world.advance_to(made.run.duration);
  return world;
}

/// Slope of the least-squares line through points.
long double slope_of(const std::vector<long double>& x, const std::vector<long double>& y) {
  long double mean_x = 0, mean_y = 0, products = 0, squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / static_cast<long double>(x.size());
    mean_y += y[i] / static_cast<long double>(x.size());
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    products += (x[i] - mean_x) * (y[i] - mean_y);
    squares += (x[i] - mean_x) * (x[i] - mean_x);
  }
  return products / squares;
}

/// Of all quantities of the problem, over the largest value of each.
long double error_of(const ReferenceProblem& problem, const World& world) {
  long double worst = 0;
  for (const auto& quantity : problem.quantities) {
    const long double error = largest_difference(quantity.measure(world), quantity.exact) / largest(quantity.exact);
    worst = std::max(worst, error);
  }
  return worst;
}

Scene kicked_swing(const std::string& integrator) {
  Scene made = at_tolerance(scene(particle({1, 0, 0}), {spring(1)}, 2, 1), integrator, 1e-8);
  made.impulses = {{0.7, 0, {0.5, 0, 0}, Vector3d::Zero()}};
  return made;
}

BodyGroup many_balls() {
  BodyGroup group = ball();
  group.position.clear();
  for (int i = 0; i < 5000; ++i) group.position.push_back({0.01 * i, 1 + 0.001 * i, 2});
  group.velocity = {{3, 1, 4}};
  group.angular_velocity = {{0, 2, -1}};
  group.orientation = {{0.6, 0, 0.8, 0}};
  return group;
}

}  // namespace

TEST_CASE("tolerance: the global error follows it, with a slope near 1 and below a thousand times it", "[physics]") {
  for (const ReferenceProblem& problem : {p_k1_kepler(0.6), p_n1_pendulum(30), p_n1_pendulum(90)}) {
    for (const std::string& name : pairs()) {
      std::vector<long double> tolerances, errors;
      for (int exponent = 4; exponent <= 12; exponent += 2) {
        const double tolerance = std::pow(10.0, -exponent);
        const long double error = error_of(problem, at_end(at_tolerance(problem.scene, name, tolerance)));
        INFO(problem.name << ", " << name << " at " << tolerance << ": " << error);
        CHECK(error < (name == "dormand_prince5" ? 1000 : 1500) * tolerance);
        tolerances.push_back(std::log10(tolerance));
        errors.push_back(std::log10(error));
      }
      INFO(problem.name << ", " << name << ": slope " << slope_of(tolerances, errors));
      CHECK(std::abs(slope_of(tolerances, errors) - 1) < (name == "dormand_prince5" ? 0.2L : 0.3L));
    }
  }
}

TEST_CASE("tolerance: every reference problem is met by an adaptive row", "[physics]") {
  for (ReferenceProblem problem : reference_problems()) {
    // P-R2 multiplies errors by 1e8: they are left to compensated sums and to the row of the highest order.
    const bool unstable = problem.scene.run.compensated;
    const std::vector<const char*> fit{"dormand_prince5", "dormand_prince8"}, accurate{"gragg_bulirsch_stoer10"};
    for (const char* name : unstable ? accurate : fit) {
      problem.scene = at_tolerance(problem.scene, name, unstable ? 1e-14 : 1e-13);
      const Outcome outcome = run(problem);
      CHECK(outcome.status.sentence == "ok");
      for (std::size_t i = 0; i < problem.quantities.size(); ++i) {
        INFO(problem.name << ", " << name << ", " << problem.quantities[i].name << ": " << outcome.errors[i]);
        CHECK(outcome.errors[i] <= problem.tolerance);
      }
    }
  }
}

TEST_CASE("X13: Kepler's orbit at e = 0.999, by steps from 1e-6 to 1e-1 of a time unit", "[physics]") {
  const long double e = 0.999L, t = 20;
  long double anomaly = t;
  for (int i = 0; i < 200; ++i) anomaly -= (anomaly - e * std::sin(anomaly) - t) / (1 - e * std::cos(anomaly));
  for (const char* name : {"dormand_prince5", "dormand_prince8"}) {
    const World world = at_end(at_tolerance(orbit(0.999, 20, 1), name, 1e-11));
    const Numbers x = position(world);
    INFO(name << ": " << world.steps() << " steps");
    CHECK(std::abs(x[0] - (std::cos(anomaly) - e)) < 1e-6L);
    CHECK(std::abs(x[1] - std::sqrt(1 - e * e) * std::sin(anomaly)) < 1e-6L);
  }
}

TEST_CASE("tolerance: an impulse acts at its very time, and costs no accuracy", "[physics]") {
  for (const std::string& name : pairs()) {
    INFO(name);
    const World world = at_end(kicked_swing(name));
    const long double before = std::cos(0.7L), speed = -std::sin(0.7L) + 0.5L, left = 1.3L;
    CHECK(std::abs(position(world)[0] - (before * std::cos(left) + speed * std::sin(left))) < 1e-6L);
    CHECK(world.time() == 2);
  }
}

TEST_CASE("tolerance: same bits on both paths, for any number of threads and target, and after a snapshot",
          "[physics]") {
  for (const std::string& name : pairs()) {
    for (const Precision precision : {Precision::double_, Precision::single_}) {
      const Scene made = at_tolerance(
          scene(many_balls(), {gravity(), effect("linear_drag", 0.3), effect("magnus", 0.2), spring(4)}, 1, 1), name,
          1e-5);
      const World plain = at_end(made, {.threads = 1, .target = "base", .precision = precision});
      INFO(name << ", steps " << plain.steps() << ", rejected " << plain.counters().rejected_steps);
      for (const Options& options : {Options{.threads = 2, .precision = precision},
                                     Options{.threads = 3, .precision = precision, .path = Path::staged}}) {
        const World other = at_end(made, options);
        CHECK(other.state_hash() == plain.state_hash());
        CHECK(other.steps() == plain.steps());
      }
      World half(made, {.threads = 1, .precision = precision});
      half.step(3);
      World restored(made, {.threads = 2, .precision = precision, .path = Path::automatic});
      restored.restore(half.snapshot());
      CHECK(restored.time() == half.time());
      restored.advance_to(1);
      half.advance_to(1);
      CHECK(restored.state_hash() == half.state_hash());
      CHECK(half.state_hash() == plain.state_hash());
    }
  }
}

TEST_CASE("tolerance: rejected steps are counted and leave no trace", "[physics]") {
  const World world = at_end(at_tolerance(orbit(0.9, 10, 1), "dormand_prince5", 1e-6));
  CHECK(world.counters().rejected_steps > 0);
  CHECK(world.counters().force_evaluations == 6 * (world.steps() + world.counters().rejected_steps) + 1);
}

TEST_CASE("tolerance: where no step is small enough the run ends and says so", "[physics]") {
  BodyGroup falling = particle({1, 0, 0});  // straight into the centre of an attraction without softening
  World world(at_tolerance(scene(falling, {attraction()}, 10, 1), "dormand_prince5", 1e-10));
  world.advance_to(10);
  CHECK((world.status().code == Status::Code::accuracy || world.status().code == Status::Code::non_finite));
  INFO(world.status().sentence);
  CHECK(world.time() < 1.2);  // pi / sqrt(8) = 1.1107
  const double end = world.time();
  world.advance_to(10);
  CHECK(world.time() == end);
}

TEST_CASE("tolerance: a body that stands still and one that nothing moves are stepped at once", "[physics]") {
  const World still = at_end(at_tolerance(scene(particle({1, 2, 3}), {}, 5, 1), "tsitouras5", 1e-8));
  CHECK(still.time() == 5);
  CHECK(position(still) == Numbers{1, 2, 3});
  CHECK(still.steps() < 60);
}

TEST_CASE("tolerance: a rejected step leaves spin and orientation that nothing turns as they were", "[physics]") {
  for (const bool spins : {true, false}) {
    Scene made = orbit(0.9, 10, 1);
    made.bodies[0].shape = "sphere";
    made.bodies[0].radius = {0.01};
    if (spins) made.bodies[0].angular_velocity = {{1, 2, 3}};
    if (!spins) made.bodies[0].orientation = {{0.6, 0, 0.8, 0}};
    const World world = at_end(at_tolerance(made, "dormand_prince5", 1e-6));
    INFO((spins ? "spin" : "orientation"));
    CHECK(world.counters().rejected_steps > 0);
    const BodyState body = world.body(0);
    if (spins) CHECK((body.angular_velocity - Vector3d(1, 2, 3)).norm() < 1e-14);
    if (!spins) CHECK((body.orientation.w == 0.6 && body.orientation.y == 0.8));
  }
}

TEST_CASE("tolerance: rows beyond the bodies do not matter, wherever they go", "[physics]") {
  // Its own copies in the padding fall into the centre; the body itself is kicked onto a circle.
  Scene made = at_tolerance(scene(particle({1, 0, 0}), {attraction()}, 10, 1), "dormand_prince5", 1e-9);
  made.impulses = {{0, 0, {0, 1, 0}, Vector3d::Zero()}};
  const World world = at_end(made);
  CHECK(world.status().sentence == "ok");
  CHECK(std::abs(position(world)[0] - std::cos(10.0L)) < 1e-6L);
}

TEST_CASE("tolerance: a force that begins later is not felt before", "[physics]") {
  Scene made = at_tolerance(scene(particle(Vector3d::Zero()), {}, 2, 1), "dormand_prince5", 1e-3);
  made.effects.push_back({"force", {}, {{"force", Vector3d(3, 0, 0)}, {"at", 1.0}, {"until", 1.5}}});
  World world(made);
  world.advance_to(1);
  CHECK(velocity(world) == Numbers{0, 0, 0});
  world.advance_to(2);
  CHECK(std::abs(velocity(world)[0] - 1.5L) < 1e-12L);
}

TEST_CASE("tolerance: a force that is no number from the start ends the run", "[physics]") {
  UserEffect broken;
  broken.name = "broken";
  broken.run_double = [](const BodyBlock<double>& block) { block.force[0][0] = std::nan(""); };
  broken.run_single = [](const BodyBlock<float>& block) { block.force[0][0] = std::nanf(""); };
  for (const Precision precision : {Precision::single_, Precision::double_}) {
    World world(at_tolerance(scene(particle({1, 2, 3}), {}, 1, 1), "tsitouras5", 1e-5), {.precision = precision},
                {broken});
    world.advance_to(1);
    CHECK(world.status().code == Status::Code::non_finite);
    CHECK(world.time() < 1e-30);
    CHECK(position(world) == Numbers{1, 2, 3});
  }
}

TEST_CASE("abm4 moves balls whose spin nothing changes", "[physics]") {
  BodyGroup group = ball();
  group.velocity = {{1, 0, 3}};
  group.angular_velocity = {{1, 2, 3}};
  for (const Path path : {Path::fused, Path::staged}) {
    World world(scene(group, {gravity()}, 1, 0.01, "abm4"), {.path = path});
    world.step(100);
    CHECK(std::abs(position(world)[2] - (3 - 9.81L / 2)) < 1e-13L);
    CHECK((world.body(0).angular_velocity - Vector3d(1, 2, 3)).norm() < 1e-15);
  }
}

TEST_CASE("tolerance: penalty contacts from the first step on", "[physics]") {
  BodyGroup group = ball();  // just touches a soft floor, and so swings about its equilibrium
  group.position = {{0, 0, group.radius[0]}};
  Scene made = at_tolerance(scene(group, {gravity()}, 0.5, 1), "dormand_prince5", 1e-8);
  made.contact.kind = "penalty";
  made.contact.stiffness = 1e4;
  Boundary floor;
  floor.shape = "plane";
  made.boundaries = {floor};
  const double mass = World(made).constant("mass", made.bodies[0].name);
  const long double swing = std::sqrt(1e4L / mass), depth = mass * 9.81L / 1e4L;
  World world(made);
  world.advance_to(0.5);
  CHECK(world.status().sentence == "ok");
  CHECK(std::abs(position(world)[2] - (group.position[0].z() - depth * (1 - std::cos(swing * 0.5L)))) < 1e-6L);
}

TEST_CASE("tolerance: penalty contacts stop what comes out of a long flight", "[physics]") {
  BodyGroup group = ball();
  group.radius = {0.1};
  group.position = {{0, 0, 1.1}};
  Scene made = scene(group, {gravity()}, 4, 1);
  made.contact.kind = "penalty";
  made.contact.stiffness = 2e5;
  Boundary floor;
  floor.shape = "plane";
  made.boundaries = {floor};
  for (const char* name : {"bogacki_shampine3", "dormand_prince5", "dormand_prince8"}) {
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      World world(at_tolerance(made, name, tolerance));
      const double energy = world.totals().energy();
      double lowest = 1;
      for (int k = 1; k <= 100; ++k) {
        REQUIRE(world.approach(0.04 * k, 4));
        world.look_ahead(0.04 * k, [&] { lowest = std::min(lowest, world.body(0).position.z()); });
      }
      INFO(name << " at " << tolerance << ": " << world.steps() << " steps, lowest " << lowest);
      CHECK(world.status().sentence == "ok");
      CHECK(lowest > 0);
      CHECK(std::abs(world.totals().energy() / energy - 1) < 40 * std::pow(tolerance, 2.0 / 3));
      CHECK(world.counters().missed == 0);
    }
  }
}

TEST_CASE("tolerance: penalty contacts of balls that come from far away", "[physics]") {
  BodyGroup group = ball();
  group.position = {{-50, 0, 0}, {50, 0, 0}};
  group.velocity = {{20, 0, 0}, {-20, 0, 0}};
  group.radius = {0.1};
  Scene made = scene(group, {}, 5, 1);
  made.contact.kind = "penalty";
  made.contact.stiffness = 1e6;
  const World world = at_end(at_tolerance(made, "dormand_prince5", 1e-6));
  CHECK(std::abs(velocity(world)[0] + 20) < 0.01L);  // elastic: they change their velocities
}
