// Traps and fluids against closed forms, and against balances solved here.
#include <functional>

#include "tests/catch.h"
#include "tests/physics/measures.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

constexpr double g = 9.81, water = 998, water_viscosity = 1.0e-3;

Effect buoyancy(double density) {
  return {"buoyancy", {}, {{"density", density}}};
}
Effect added_mass(double density) {
  return {"added_mass", {}, {{"density", density}}};
}
Effect reynolds_drag(double density, double viscosity) {
  return {"reynolds_drag", {}, {{"density", density}, {"viscosity", viscosity}}};
}
Effect wind(const Vector3d& velocity, const Vector3d& shear = Vector3d::Zero(), double height = 0) {
  return {"wind", {}, {{"velocity", velocity}, {"shear", shear}, {"height", height}}};
}
Effect gusts(double speed, double length, const Vector3d& velocity) {
  return {"gusts", {}, {{"speed", speed}, {"length", length}, {"velocity", velocity}}};
}

double volume(double radius) {
  return 4 / 3.0 * pi * radius * radius * radius;
}
BodyGroup bead(double radius, double density) {
  BodyGroup group = particle(Vector3d::Zero());
  group.shape = "sphere";
  group.mass = {};
  group.density = {density};
  group.radius = {radius};
  return group;
}

World run(const Scene& made, const Options& options = {}) {
  World world(made, options);
  world.advance_to(made.run.duration);
  return world;
}

double apart(const Vector3d& a, const Vector3d& b) {
  return (a - b).norm() / (1 + b.norm());
}

/// Where f changes its sign, between low and high.
long double root(long double low, long double high, const std::function<long double(long double)>& f) {
  const bool rises = f(high) > 0;
  for (int i = 0; i < 200; ++i) {
    const long double middle = (low + high) / 2;
    ((f(middle) > 0) == rises ? high : low) = middle;
  }
  return low;
}

/// At which drag carries the weight in water: Schiller & Naumann's law, solved by bisection.
long double terminal_speed(long double radius, long double density, long double fluid, long double viscosity) {
  return root(0, 100, [=](long double v) {
    const long double reynolds = 2 * radius * fluid * v / viscosity;
    const long double coefficient = reynolds < 1000 ? 24 / reynolds * (1 + 0.15L * std::pow(reynolds, 0.687L)) : 0.44L;
    return coefficient * fluid / 2 * radius * radius * v * v -
           4 / 3.0L * radius * radius * radius * (density - fluid) * static_cast<long double>(g);
  });
}

}  // namespace

TEST_CASE("harmonic trap: each axis swings, stands free or runs away by itself", "[physics]") {
  const Vector3d centre(0.5, -1, 2), x0(1, 0.25, 1.5), v0(0.3, -0.7, 0.2);
  const Effect trap{"harmonic_trap", {}, {{"centre", centre}, {"stiffness", Vector3d(25, 0, -4)}}};
  const World world = run(scene(particle(x0, v0), {trap}, 2, 1e-3));
  const double t = 2, d = x0.x() - centre.x(), e = x0.z() - centre.z();
  const Vector3d x(centre.x() + d * std::cos(5 * t) + v0.x() / 5 * std::sin(5 * t), x0.y() + v0.y() * t,
                   centre.z() + e * std::cosh(2 * t) + v0.z() / 2 * std::sinh(2 * t));
  const Vector3d v(-5 * d * std::sin(5 * t) + v0.x() * std::cos(5 * t), v0.y(),
                   2 * e * std::sinh(2 * t) + v0.z() * std::cosh(2 * t));
  CHECK(apart(world.body(0).position, x) < 1e-9);
  CHECK(apart(world.body(0).velocity, v) < 1e-9);
}

TEST_CASE("spin decay: a ball's spin fades as exp(-c t / I), and tells its largest stable step", "[physics]") {
  BodyGroup group = ball();
  group.angular_velocity = {{3, -4, 12}};
  Scene made = scene(group, {effect("spin_decay", 0.1)}, 10, 1e-2);
  const double left = std::exp(-0.1 * 10 / 0.4);
  CHECK(apart(run(made).body(0).angular_velocity, left * group.angular_velocity[0]) < 1e-9);
  made.run.duration = 1000;
  made.run.step = 2.785293563405282 * 0.4 / 0.1 * 1.01;  // the real limit of rk4
  const Status status = World(made).status();
  CHECK(status.code == Status::Code::stability);
  CHECK(status.sentence.find("the spin of group ball") != std::string::npos);
  made.run.step *= 0.98;
  CHECK(World(made).status().code == Status::Code::ok);
}

TEST_CASE("buoyancy with Stokes' drag: v = (m - m_f) g / k (1 - exp(-k t / m))", "[physics]") {
  const double radius = 1e-3, density = 2500, k = 6 * pi * water_viscosity * radius;
  const double mass = density * volume(radius), terminal = (density - water) * volume(radius) * g / k;
  for (const double t : {0.1, 5.0}) {
    const World world =
        run(scene(bead(radius, density), {gravity(g), buoyancy(water), effect("linear_drag", k)}, t, t / 1024));
    CHECK(std::abs(world.body(0).velocity.z() / (-terminal * (1 - std::exp(-k * t / mass))) - 1) < 1e-11);
  }
}

TEST_CASE("added mass: what is let go in water starts at (rho_s - rho_f) / (rho_s + rho_f / 2) g", "[physics]") {
  for (const double density : {7850.0, 2500.0, 998.0, 600.0, 1.2}) {
    Scene made = scene(bead(0.01, density), {gravity(g), buoyancy(water), added_mass(water)}, 1, 1.0 / 128);
    const double expected = -(density - water) / (density + water / 2) * g;
    for (const IntegratorDescription& row : integrators()) {
      made.run.integrator = row.name;
      if (!check(made).empty()) continue;
      CAPTURE(density, row.name);
      const World world = run(made);
      const double tolerance = 1e-13 * g;
      CHECK(std::abs(world.body(0).velocity.z() - expected) <= tolerance);
      if (row.order > 1) CHECK(std::abs(world.body(0).position.z() - expected / 2) <= tolerance);
      const Totals start = World(made).totals(), end = world.totals();
      if (row.order > 1) {                                                  // with the kinetic energy of the water
        const double scale = 1e-12 * (density + water) * volume(0.01) * g;  // what rounds: both potentials
        CHECK(std::abs(end.kinetic + end.potential - start.kinetic - start.potential) <= scale);
      }
    }
  }
}

TEST_CASE("added mass: a blow and a spring feel it too", "[physics]") {
  const double radius = 0.01, density = 600;
  const double effective = (density + water / 2) * volume(radius), stiffness = 4;
  Scene made = scene(bead(radius, density), {spring(stiffness), added_mass(water)}, 1, 1e-4);
  World world(made);
  world.apply_impulse(0, {0, 0, 0.01});
  const double start = 0.01 / effective, w = std::sqrt(stiffness / effective);
  CHECK(std::abs(world.body(0).velocity.z() / start - 1) < 1e-14);
  world.advance_to(1);
  CHECK(std::abs(world.body(0).position.z() - start / w * std::sin(w)) < 1e-9 * start / w);
  made.run.integrator = "gauss4";
  World implicit(made);
  implicit.apply_impulse(0, {0, 0, 0.01});
  implicit.advance_to(1);
  CHECK(std::abs(implicit.body(0).position.z() - start / w * std::sin(w)) < 1e-7 * start / w);
}

TEST_CASE("added mass: two balls in water meet as if they were heavier", "[physics]") {
  BodyGroup balls = ball();
  balls.mass = {};
  balls.density = {600};
  balls.position = {{-1.5, 0, 0}, {1.5, 0, 0}};
  balls.velocity = {{1, 0, 0}, {0, 0, 0}};
  Scene made = scene(balls, {}, 2, 1e-3);
  Scene heavier = made;
  made.effects = {added_mass(water)};
  heavier.bodies[0].density = {600 + water / 2};
  for (const std::string kind : {"impulse", "penalty"}) {
    for (Scene* one : {&made, &heavier}) {
      one->contact.kind = kind;
      if (kind == "penalty") one->contact.stiffness = 1e7;
    }
    const World wet = run(made), dry = run(heavier);
    CAPTURE(kind);
    for (const std::size_t id : {0U, 1U}) CHECK(apart(wet.body(id).velocity, dry.body(id).velocity) < 1e-12);
    CHECK(std::abs(wet.body(0).velocity.x() - 1) > 0.1);
  }
}

TEST_CASE("added mass: what resists more is stable at longer steps", "[physics]") {
  BodyGroup beads = bead(1e-3, 0);
  beads.density = {600, 7850};
  beads.position = {{0, 0, 0}, {1, 0, 0}};
  const auto limit_with = [&](const Effect& one) {
    return World(scene(beads, {one, added_mass(water)}, 1, 1e-4)).explain().step_limits.at(0).largest;
  };
  // Stokes' drag slows the light one fastest; the frame turns the heavy one, of which less is water, fastest.
  const double light = (600 + water / 2) * volume(1e-3), rate = 6 * pi * water_viscosity * 1e-3 / light;
  CHECK(std::abs(limit_with(reynolds_drag(water, water_viscosity)) * rate / 2.785293563405282 - 1) < 1e-5);
  const double turning = 2 * 3.0 * 7850 / (7850 + water / 2);
  CHECK(std::abs(limit_with(rotating_frame({0, 0, 3}, "off")) * turning / (2 * std::sqrt(2.0)) - 1) < 1e-5);
}

TEST_CASE("Schiller and Naumann's drag: beads in water and drops in air reach the speed that carries them",
          "[physics]") {
  struct Fall {
    double radius, density, fluid, viscosity;
  };
  for (const Fall& fall : {Fall{5e-5, 2500, water, water_viscosity}, Fall{1e-3, 2500, water, water_viscosity},
                           Fall{1e-2, 7850, water, water_viscosity}, Fall{1e-3, 600, water, water_viscosity},
                           Fall{1e-4, 998, 1.2, 1.8e-5}, Fall{2.5e-3, 998, 1.2, 1.8e-5}}) {
    const bool sinks = fall.density > fall.fluid;
    const long double speed =
        sinks ? terminal_speed(fall.radius, fall.density, fall.fluid, fall.viscosity)
              : root(0, 100, [&](long double v) {
                  const long double reynolds = 2 * fall.radius * fall.fluid * v / fall.viscosity;
                  return 24 / reynolds * (1 + 0.15L * std::pow(reynolds, 0.687L)) * fall.fluid * v * v / 2 -
                         4 / 3.0L * fall.radius * (fall.fluid - fall.density) * static_cast<long double>(g);
                });
    const double relaxation =
        static_cast<double>(speed) / g * (fall.density + fall.fluid) / std::abs(fall.density - fall.fluid);
    Scene made = scene(bead(fall.radius, fall.density),
                       {gravity(g), buoyancy(fall.fluid), reynolds_drag(fall.fluid, fall.viscosity)}, 60 * relaxation,
                       relaxation / 16);
    const double reached = run(made).body(0).velocity.z() * (sinks ? -1 : 1);
    CAPTURE(fall.radius, fall.density, fall.fluid, static_cast<double>(speed));
    CHECK(std::abs(reached / static_cast<double>(speed) - 1) < 1e-10);
  }
}

TEST_CASE("wind: what flies in it flies as in still air seen from a moving frame", "[physics]") {
  const Vector3d steady(4, -3, 1), v0(10, 2, 20);
  BodyGroup group = ball();
  group.angular_velocity = {{5, -2, 8}};
  std::vector<Effect> effects = {gravity(g), effect("quadratic_drag", 0.05), effect("linear_drag", 0.02),
                                 effect("magnus", 0.03), reynolds_drag(1.2, 0.1)};
  group.velocity = {v0 - steady};
  const World still = run(scene(group, effects, 3, 1e-2));
  effects.push_back(wind({3, -3, 0}));
  effects.push_back(wind({1, 0, 1}));  // together they are one
  group.velocity = {v0};
  for (const Path path : {Path::fused, Path::staged}) {
    const World blown = run(scene(group, effects, 3, 1e-2), {.path = path});
    CHECK(apart(blown.body(0).velocity, still.body(0).velocity + steady) < 1e-12);
    CHECK(apart(blown.body(0).position, still.body(0).position + 3 * steady) < 1e-12);
  }
}

TEST_CASE("wind: a group that it does not blow on keeps its bits", "[physics]") {
  Scene made = scene(particle({0, 0, 1}, {1, 0, 2}), {gravity(g), effect("quadratic_drag", 0.1)}, 1, 1e-2);
  const World alone = run(made);
  BodyGroup other = particle({5, 0, 1}, {1, 0, 2});
  other.name = "blown";
  made.bodies.push_back(other);
  made.effects.push_back(wind({3, 0, 0}));
  made.effects.back().groups = {"blown"};
  const World both = run(made);
  CHECK(both.body(0).position == alone.body(0).position);
  CHECK(both.body(0).velocity == alone.body(0).velocity);
  CHECK((both.body(1).velocity - alone.body(0).velocity).norm() > 0.1);
}

TEST_CASE("wind: linear drag in a linear shear, by its closed form", "[physics]") {
  const double rate = 2, k = 0.5, t = 3, v0 = 1.5, z0 = 0.75, start = -0.4;  // tau = m / k = 2 s
  const double tau = 1 / k, fade = std::exp(-t / tau), far = z0 + v0 * tau, way = v0 * tau;
  const World world = run(scene(particle({0, 0, z0 + 1}, {start, 0, v0}),
                                {effect("linear_drag", k), wind({0, 0, 0}, {rate, 0, 0}, 1)}, t, 1e-3));
  // v_x' = -(v_x - S z) / tau, z - z0 = far - way exp(-t / tau)
  const double expected = rate * (far * (1 - fade) - way * t / tau * fade) + start * fade;
  CHECK(std::abs(world.body(0).velocity.x() - expected) < 1e-11);
  CHECK(std::abs(world.body(0).position.z() - (1 + far - way * fade)) < 1e-11);
}

TEST_CASE("gusts: carried by the wind they are those of still air seen from a moving frame", "[physics]") {
  const Vector3d steady(6, -2, 0.5), v0(1, 0, 2);
  const std::vector<Effect> forces = {gravity(0.3), effect("linear_drag", 0.8), effect("quadratic_drag", 0.1)};
  std::vector<Effect> effects = forces;
  effects.push_back(gusts(1.5, 5, {0, 0, 0}));
  const World still = run(scene(particle({0, 0, 0}, v0 - steady), effects, 4, 1e-3));
  effects = forces;
  effects.push_back(gusts(1.5, 5, steady));
  effects.push_back(wind(steady));
  for (const Path path : {Path::fused, Path::staged}) {
    const World blown = run(scene(particle({0, 0, 0}, v0), effects, 4, 1e-3), {.path = path});
    CHECK(apart(blown.body(0).velocity, still.body(0).velocity + steady) < 1e-10);
    CHECK(apart(blown.body(0).position, still.body(0).position + 4 * steady) < 1e-10);
  }
}

TEST_CASE("gusts: every way to step sees them at the time of each stage", "[physics]") {
  Scene made = scene(particle({0, 0, 0}, {1, 0, 2}),
                     {effect("linear_drag", 0.8), wind({6, 0, 0}), gusts(1.5, 5, {6, 0, 0})}, 2, 1e-4);
  const Vector3d expected = run(made).body(0).position;
  made.run.step = 2.0 / 4096;
  World looked(made);
  looked.step(100);
  const std::uint64_t hash = looked.state_hash();
  Vector3d seen;
  looked.look_ahead(1.23456, [&] { seen = looked.body(0).position; });
  CHECK(looked.state_hash() == hash);
  Scene shorter = made;
  shorter.run.duration = 1.23456;
  shorter.run.step = shorter.run.duration / 4096;
  CHECK((seen - run(shorter).body(0).position).norm() < 1e-8);
  for (const char* integrator : {"dormand_prince8", "gauss4", "ab5", "abm4"}) {
    made.run.integrator = integrator;
    CAPTURE(integrator);
    CHECK((run(made).body(0).position - expected).norm() < 1e-6);
  }
  made.run.integrator = "dormand_prince8";
  made.run.step = 0;
  made.run.tolerance = 1e-10;
  for (const Path path : {Path::fused, Path::staged}) {
    CHECK((run(made, {.path = path}).body(0).position - expected).norm() < 1e-8);
  }
}
