// Effects between steps: a thermostat against the moments of Langevin's equation, and walls that mirror.
#include <cmath>

#include "tests/catch.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

Effect thermostat(double energy, double rate) {
  return {"thermostat", {}, {{"energy", energy}, {"rate", rate}}};
}
Effect wall(const Vector3d& point, const Vector3d& normal) {
  return {"reflecting_wall", {}, {{"point", point}, {"normal", normal}}};
}

BodyGroup many(std::size_t count, double mass, const Vector3d& velocity = Vector3d::Zero()) {
  BodyGroup group = particle(Vector3d::Zero(), velocity);
  group.mass = {mass};
  group.position.clear();
  group.generate = Generate{};
  group.generate->kind = "random";
  group.generate->count = {count};
  return group;
}

/// Mean over bodies and components of what act(position, velocity) tells of each.
template <class Act>
double mean(const World& world, Act act) {
  double sum = 0;
  for (std::size_t id = 0; id < world.body_count(); ++id) {
    const BodyState body = world.body(id);
    for (int c = 0; c < 3; ++c) sum += act(body.position[c], body.velocity[c]);
  }
  return sum / (3 * static_cast<double>(world.body_count()));
}

constexpr std::size_t crowd = 20000;
/// Five standard errors of a mean of squares of so many normal numbers.
constexpr double noise = 5 * 0.00577;  // 5 sqrt(2 / (3 crowd))

}  // namespace

TEST_CASE("Thermostat: free bodies forget their velocity as exp(-g t) and end with m <v^2> = kT", "[physics]") {
  const double kT = 0.7, rate = 2, mass = 0.5, v0 = 3;
  for (const double h : {0.5, 0.05}) {  // the velocity is solved exactly, whatever the step
    World world(scene(many(crowd, mass, {v0, v0, v0}), {thermostat(kT, rate)}, 5, h, "velocity_verlet"));
    world.advance_to(1);
    const double left = std::exp(-rate);
    CAPTURE(h);
    CHECK(std::abs(mean(world, [](double, double v) { return v; }) - v0 * left) <
          5 * std::sqrt(kT / mass / (3 * crowd)));
    const double variance = mean(world, [&](double, double v) { return (v - v0 * left) * (v - v0 * left); });
    CHECK(std::abs(variance / ((1 - left * left) * kT / mass) - 1) < noise);
    world.advance_to(5);
    CHECK(std::abs(mean(world, [](double, double v) { return v * v; }) / (kT / mass) - 1) < noise);
    const double fourth = mean(world, [](double, double v) { return v * v * v * v; });
    CHECK(std::abs(fourth / (3 * kT * kT / mass / mass) - 1) < 3 * noise);
  }
}

TEST_CASE("Thermostat: free bodies spread as 2 kT / (m g) (t - (1 - exp(-g t)) / g)", "[physics]") {
  const double kT = 1, rate = 1.5, mass = 2, t = 4;
  World world(scene(many(crowd, mass), {thermostat(kT, rate)}, t, 0.01, "velocity_verlet"));
  const World start = World(scene(many(crowd, mass), {thermostat(kT, rate)}, t, 0.01, "velocity_verlet"));
  world.advance_to(t);
  double sum = 0;
  for (std::size_t id = 0; id < crowd; ++id) sum += (world.body(id).position - start.body(id).position).squaredNorm();
  // From rest: that of bodies in equilibrium, less what their first velocity would have done.
  const double forgot = 1 - std::exp(-rate * t);
  const double expected = kT / mass * (2 / rate * (t - forgot / rate) - forgot * forgot / (rate * rate));
  CHECK(std::abs(sum / (3 * crowd) / expected - 1) < noise + 0.01);
}

TEST_CASE("Thermostat: behind Verlet's steps, an oscillator's <x^2> is kT / (k (1 - (h w)^2 / 4))", "[physics]") {
  const double kT = 0.3, k = 4, mass = 1;
  const Effect trap{"harmonic_trap", {}, {{"stiffness", Vector3d(k, k, k)}}};
  for (const double hw : {0.2, 1.2}) {  // at 1.2: a factor 1.56
    const double h = hw / std::sqrt(k / mass);
    World world(scene(many(crowd, mass), {trap, thermostat(kT, 1)}, 30, h, "velocity_verlet"));
    world.step(static_cast<std::uint64_t>(30 / h));
    CAPTURE(hw);
    CHECK(std::abs(mean(world, [](double x, double) { return x * x; }) / (kT / k / (1 - hw * hw / 4)) - 1) < noise);
    CHECK(std::abs(mean(world, [](double, double v) { return v * v; }) / (kT / mass) - 1) < noise);
  }
}

TEST_CASE("Thermostat: noise is of the body, its copy's seed and the step, and of nothing else", "[physics]") {
  Scene made = scene(many(300, 1), {gravity(), thermostat(1, 0.5)}, 1, 0.01);
  made.run.seed = 7;
  World one(made, {.threads = 1}), all(made, {.threads = 2, .copies = 3});
  one.step(50), all.step(50);
  made.run.seed = 9;
  World third(made);
  third.step(50);
  for (std::size_t id = 0; id < 300; ++id) {
    REQUIRE(one.body(id).velocity == all.body(id).velocity);
    REQUIRE(third.body(id).position == all.body(600 + id).position);
  }
  CHECK(one.body(0).velocity != third.body(0).velocity);
  const Snapshot half = one.snapshot();
  one.step(20);
  const std::uint64_t hash = one.state_hash();
  one.restore(half);
  one.look_ahead(0.555, [] {});  // steps on with the same noise, and back
  one.step(20);
  CHECK(one.state_hash() == hash);
  Scene two = made;
  two.effects.push_back(thermostat(1, 0.5));
  World both(two);
  both.step(50);
  CHECK(both.body(0).velocity != third.body(0).velocity);  // each has noise of its own
}

TEST_CASE("Reflecting wall: free flight between two is a sawtooth, and energy is kept", "[physics]") {
  const double v = 1.7, width = 1.3, t = 10;
  BodyGroup group = particle({0.4, 5, 0}, {v, 0.2, 0});
  World world(scene(group, {wall({0, 0, 0}, {2, 0, 0}), wall({width, 0, 0}, {-1, 0, 0})}, t, 1e-2));
  world.advance_to(t);
  const double way = 0.4 + v * t, turns = std::floor(way / width), rest = way - turns * width;
  const bool back = static_cast<int>(turns) % 2 == 1;
  CHECK(std::abs(world.body(0).position.x() - (back ? width - rest : rest)) < 1e-12);
  CHECK(world.body(0).velocity.x() == (back ? -v : v));
  CHECK(std::abs(world.body(0).position.y() - 7) < 1e-12);
}

TEST_CASE("Reflecting wall: a gas of points presses on its box as n kT / V", "[physics]") {
  const double kT = 1, t = 20;
  BodyGroup group = many(2000, 1);
  group.generate->upper = Vector3d(1, 1, 1);
  std::vector<Effect> box{thermostat(kT, 1)};
  for (int c = 0; c < 3; ++c) {
    box.push_back(wall({0, 0, 0}, Vector3d::Unit(c)));
    box.push_back(wall({1, 1, 1}, -Vector3d::Unit(c)));
  }
  World world(scene(group, box, t + 5, 0.01));
  world.step(500);  // from rest
  double momentum = 0;
  for (int i = 0; i < 2000; ++i) {
    double before = 0;  // what free flight takes behind the walls comes back reversed
    const auto beyond = [&](double x, double v) {
      const double next = x + 0.01 * v;
      before += next < 0 || next > 1 ? 2 * std::abs(v) : 0;
      return 0.0;
    };
    mean(world, beyond);
    momentum += before;
    world.step();
  }
  const double pressure = momentum / t / 6;  // six faces of 1 m^2
  CHECK(std::abs(pressure / (2000 * kT) - 1) < 0.02);
  CHECK(mean(world, [](double x, double) { return x >= 0 && x <= 1 ? 1.0 : 0.0; }) == 1);
}

TEST_CASE("Between steps: the ledger gives each its line, and what cannot take them is refused", "[physics]") {
  Scene made = scene(many(50, 1, {1, 0, 0}), {gravity(), thermostat(0.5, 3), wall({0, 0, -0.2}, {0, 0, 1})}, 0.5, 1e-3);
  World world(made);
  world.keep_ledger(true);
  world.advance_to(0.5);
  const Ledger ledger = world.ledger();
  double of_thermostat = 0;
  for (const LedgerLine& line : ledger.lines) {
    if (line.name == "thermostat") of_thermostat = line.work;
  }
  CHECK(of_thermostat != 0);
  CHECK(std::abs(ledger.integrator_error()) < 1e-10);
  const auto refused = [](const Scene& scene, const char* word) {
    const std::vector<Problem> problems = check(scene);
    return !problems.empty() && problems.front().message.find(word) != std::string::npos;
  };
  Scene adaptive = made;
  adaptive.run.step = 0, adaptive.run.tolerance = 1e-6, adaptive.run.integrator = "dormand_prince5";
  CHECK(refused(adaptive, "between steps"));
  Scene multistep = made;
  multistep.run.integrator = "ab4";
  CHECK(refused(multistep, "between steps"));
  Scene swinging = pendulum(1, 1, 1e-3);
  swinging.effects.push_back(thermostat(1, 1));
  CHECK(refused(swinging, "pivot"));
  made.effects[2].parameters["normal"] = Vector3d(0, 0, 0);
  CHECK(refused(made, "has length 0"));
}
