// Balls on a table against closed forms: sliding into rolling, coming to rest, slopes, and a table that turns.
#include <Eigen/Geometry>

#include "tests/catch.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

constexpr double g = 9.81, radius = 0.028575, settling = 1e-5;

using Parameters = std::map<std::string, Value>;

Effect table(Parameters parameters) {
  parameters.emplace("settling", settling);
  return {"table", {}, std::move(parameters)};
}
/// Without friction but that against sliding.
Effect cloth(double sliding, Parameters more = {}) {
  more.insert({{"sliding", sliding}, {"rolling", 0.0}, {"spinning", 0.0}});
  return table(std::move(more));
}

BodyGroup pool_ball(const Vector3d& velocity, const Vector3d& spin = Vector3d::Zero()) {
  BodyGroup group = ball();
  group.mass = {0.170097};
  group.radius = {radius};
  group.velocity = {velocity};
  group.angular_velocity = {spin};
  return group;
}

World run(const Scene& made) {
  World world(made);
  REQUIRE(world.status().code == Status::Code::ok);
  world.advance_to(made.run.duration);
  return world;
}

bool near(const Vector3d& a, const Vector3d& b, double tolerance) {
  CAPTURE(a.transpose(), b.transpose(), (a - b).norm());
  CHECK((a - b).norm() < tolerance);
  return (a - b).norm() < tolerance;
}

/// The spin with which a ball at x, v rolls on a table that turns with `turning` about the origin.
Vector3d rolling_spin(const Vector3d& x, const Vector3d& v, const Vector3d& n, double turning, double r) {
  return n.cross(v - turning * n.cross(x)) / r;
}

}  // namespace

// numerics B1, B2: mu = 0.2; the slip ends after 2 |u0| / (7 mu g), at (5 v0 + 2 R w0 x z) / 7.
TEST_CASE("Table: a sliding ball curves, then rolls", "[physics]") {
  struct Shot {
    Vector3d velocity, spin;
    double time;
    Vector3d displacement, rolling;
  };
  const Shot shots[] = {
      {{2, 0, 0}, {0, 0, 0}, 0.291247997670016, {0.499282281720027, 0, 0}, {10 / 7.0, 0, 0}},
      {{1, 0, 0},
       {30, -20, 0},
       0.260682813872375,
       {0.202159522158027, -0.0319243345988705, 0},
       {0.551, -0.244928571428571, 0}},
  };
  for (const Shot& shot : shots) {
    const double T = 0.4;
    const World world = run(scene(pool_ball(shot.velocity, shot.spin), {gravity(), cloth(0.2)}, T, settling));
    near(world.body(0).velocity, shot.rolling, 1e-11);
    near(world.body(0).position, shot.displacement + (T - shot.time) * shot.rolling, 1e-9);
    near(world.body(0).angular_velocity, rolling_spin(Vector3d::Zero(), shot.rolling, {0, 0, 1}, 0, radius), 1e-9);
  }
}

TEST_CASE("Table: between, sliding keeps its direction, and settling moves the end by half of mu g t^2", "[physics]") {
  const World sliding = run(scene(pool_ball({1, 0, 0}, {30, -20, 0}), {gravity(), cloth(0.2)}, 0.2, settling));
  const Vector3d u = Vector3d(1, 0, 0) - radius * Vector3d(30, -20, 0).cross(Vector3d(0, 0, 1));
  near(sliding.body(0).velocity, Vector3d(1, 0, 0) - 0.2 * 0.2 * g * u.normalized(), 1e-12);
  for (const double t : {1e-3, 1e-4}) {
    const World world = run(scene(pool_ball({2, 0, 0}), {gravity(), cloth(0.2, {{"settling", t}})}, 0.4, t / 4));
    const double exact = 0.499282281720027 + (0.4 - 0.291247997670016) * 10 / 7;
    CHECK(std::abs((world.body(0).position.x() - exact) / (0.5 * 0.2 * g * t * t) - 1) < 0.01);
  }
}

TEST_CASE("Table: rolling and spinning fade evenly and end at rest", "[physics]") {
  const double v = 0.5, mu = 0.01, spin = 0.0127, about = 40;
  Scene made = scene(pool_ball({v, 0, 0}, {0, v / radius, about}), {gravity(), table({{"settling", 1e-4}})}, 3, 1e-4);
  const World rolling = run(made);
  CHECK(std::abs(rolling.body(0).velocity.x() - (v - mu * g * 3)) < 1e-12);
  CHECK(std::abs(rolling.body(0).position.x() - (v * 3 - mu * g * 4.5)) < 1e-12);
  CHECK(std::abs(rolling.body(0).angular_velocity.z() - (about - 2.5 * spin * g / radius * 3)) < 1e-9);
  made.run.duration = 6;
  made.run.step = 1e-4;
  World world(made);
  double last = v;
  while (world.time() < 6) {
    world.step(100);
    CHECK(world.body(0).velocity.x() > -1e-300);  // never back
    CHECK(world.body(0).velocity.x() <= last);
    last = world.body(0).velocity.x();
  }
  CHECK(last < 1e-30);
  CHECK(std::abs(world.body(0).angular_velocity.z()) < 1e-30);
  CHECK(std::abs(world.body(0).position.x() - v * v / (2 * mu * g)) < 1e-8);
}

TEST_CASE("Table: on a slope a ball rolls if mu >= 2/7 tan a, else it slides", "[physics]") {
  const double a = 20 * pi / 180, limit = 0.103991495504629;
  const Vector3d n(std::sin(a), 0, std::cos(a)), down(std::cos(a), 0, -std::sin(a));
  for (const double mu : {0.2, limit * 1.001, limit * 0.999, 0.05}) {
    const bool rolls = mu > limit;
    CAPTURE(mu);
    const World world =
        run(scene(pool_ball(Vector3d::Zero()), {gravity(), cloth(mu, {{"normal", Vector3d(3 * n)}})}, 1, 1e-5));
    const double along = rolls ? 2.39658400430344 : g * (std::sin(a) - mu * std::cos(a));
    const double spin = rolls ? 2.39658400430344 / radius : 2.5 * mu * g * std::cos(a) / radius;
    near(world.body(0).velocity, along * down, 1e-4 * (rolls ? 1e-7 : 1));
    near(world.body(0).position, along / 2 * down, 1e-4 * (rolls ? 1e-7 : 1));
    CHECK(std::abs(world.body(0).angular_velocity.y() / spin - 1) < (rolls ? 1e-10 : 1e-4));
  }
}

// numerics P-T1 (Weckesser 1997): (1 + a) v' = a W n x v + g_t; a = 2/5 of a solid ball.
TEST_CASE("Table: on one that turns balls circle, or drift across the slope", "[physics]") {
  const double turning = pi, a = 0.4, T = 7;
  for (const double slope : {0.0, 3 * pi / 180}) {
    const Vector3d n(std::sin(slope), 0, std::cos(slope)), weight(0, 0, -g), x0(0.3, -0.1, 0), v0(0, 0.2, 0);
    const Vector3d at = x0 - x0.dot(n) * n, along = weight - weight.dot(n) * n;
    const Vector3d drift = n.cross(along) / (a * turning), own = v0 - drift;
    if (slope > 0) CHECK(std::abs(drift.norm() - 0.408563257044652138) < 1e-14);
    const double rate = a / (1 + a) * turning, t = 0.9 * T;
    for (const char* integrator : {"rk4", "dormand_prince8", "dormand_prince5"}) {
      CAPTURE(slope, integrator);
      BodyGroup group = pool_ball(v0, rolling_spin(at, v0, n, turning, radius));
      group.position = {at};
      const Effect spun = cloth(0.9, {{"normal", n}, {"turning", turning}, {"settling", 1e-2}});
      Scene made = scene(group, {gravity(), spun}, t, 2e-3, integrator);
      if (made.run.integrator == "dormand_prince5") made.run.step = {}, made.run.tolerance = 1e-11;
      const World world = run(made);
      const Vector3d whole = std::sin(rate * t) * own + (1 - std::cos(rate * t)) * n.cross(own);
      near(world.body(0).position, at + t * drift + whole / rate, 1e-9);
      near(world.body(0).velocity, drift + std::cos(rate * t) * own + std::sin(rate * t) * n.cross(own), 1e-9);
    }
  }
}

TEST_CASE("Table: a circle of radius 7 v / (2 W) closes after 7 s", "[physics]") {
  BodyGroup group = pool_ball({0.2, 0, 0}, rolling_spin(Vector3d::Zero(), {0.2, 0, 0}, {0, 0, 1}, pi, radius));
  const Effect spun = cloth(0.9, {{"turning", pi}, {"settling", 1e-2}});
  near(run(scene(group, {gravity(), spun}, 3.5, 1e-3)).body(0).position, {0, 2 * 0.22281692032865347, 0}, 1e-9);
  near(run(scene(group, {gravity(), spun}, 7, 1e-3)).body(0).position, {0, 0, 0}, 1e-9);
}

TEST_CASE("Table: what nothing presses on it is free", "[physics]") {
  const World lifted = run(scene(pool_ball({1, 0, 0}, {30, -20, 5}), {gravity(-1), table({})}, 0.5, settling));
  near(lifted.body(0).position, {0.5, 0, 0.125}, 1e-12);
  near(lifted.body(0).angular_velocity, {30, -20, 5}, 1e-12);
  const World slippery = run(scene(pool_ball({1, 0, 0}, {30, -20, 0}), {gravity(), cloth(0)}, 0.5, settling));
  near(slippery.body(0).position, {0.5, 0, 0}, 1e-12);
}

TEST_CASE("Table: balls of all sizes side by side, each as if alone", "[physics]") {
  BodyGroup all = pool_ball({1, 0, 0}, {30, -20, 0});
  all.mass = {0.1, 0.2, 0.3, 0.4, 0.5};
  all.radius = {0.01, 0.02, 0.03, 0.04, 0.05};
  all.position = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  const World together = run(scene(all, {gravity(), table({})}, 0.3, settling));
  for (std::size_t i = 0; i < 5; ++i) {
    BodyGroup one = all;
    one.mass = {all.mass[i]}, one.radius = {all.radius[i]}, one.position = {all.position[i]};
    const World alone = run(scene(one, {gravity(), table({})}, 0.3, settling));
    CHECK(together.body(i).position == alone.body(0).position);
    CHECK(together.body(i).angular_velocity == alone.body(0).angular_velocity);
  }
}

TEST_CASE("Table: the ledger gives friction what it takes, and rolling nothing", "[physics]") {
  const double v = 2, energy = 0.5 * 0.170097 * v * v;
  World world(scene(pool_ball({v, 0, 0}), {gravity(), cloth(0.2)}, 0.4, settling));
  world.keep_ledger(true);
  world.advance_to(0.4);
  const Ledger ledger = world.ledger();
  for (const LedgerLine& line : ledger.lines) {
    if (line.name == "table") CHECK(std::abs(line.work / energy + 2 / 7.0) < 1e-9);
    if (line.name == "gravity") CHECK(std::abs(line.work) < 1e-15);
  }
  CHECK(std::abs(ledger.integrator_error()) < 1e-9 * energy);
}

TEST_CASE("Table: a step much longer than the settling time is told, and what it cannot carry refused", "[physics]") {
  Scene made = scene(pool_ball({1, 0, 0}), {gravity(), table({{"settling", 1e-3}})}, 1, 2.8e-3);
  CHECK(World(made).status().code == Status::Code::stability);
  made.run.step = 2.7e-3;
  CHECK(World(made).status().code == Status::Code::ok);
  const auto problem = [](Scene scene) {
    const std::vector<Problem> problems = check(scene);
    return problems.empty() ? std::string() : problems.front().message;
  };
  Scene uneven = made;
  uneven.bodies[0].inertia = {{1e-4, 1e-4, 2e-4}};
  CHECK(problem(uneven).find("unequal moments of inertia") != std::string::npos);
  Scene twice = made;
  twice.effects.push_back(table({}));
  CHECK(problem(twice).find("has a table already") != std::string::npos);
  Scene wet = made;
  wet.effects.push_back({"added_mass", {}, {{"density", 998.0}}});
  CHECK(problem(wet).find("added_mass") != std::string::npos);
  Scene flat = made;
  flat.effects[1].parameters["normal"] = Vector3d(0, 0, 0);
  CHECK(problem(flat).find("has length 0, expected a direction") != std::string::npos);
}
