// Forces between bodies: three and seven bodies that attract each other, bodies on springs, and what such forces keep.
#include "tests/catch.h"
#include "tests/integrators.h"
#include "tests/physics/measures.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

Effect mutual_gravity(double softening = 0) {
  return {"mutual_gravity", {}, {{"strength", 1.0}, {"softening", softening}}};
}

Effect bonds(std::vector<IdPair> pairs, const Value& stiffness, const Value& damping, const Value& rest_length) {
  return {"bonds",
          {},
          {{"pairs", std::move(pairs)}, {"stiffness", stiffness}, {"damping", damping}, {"rest_length", rest_length}}};
}

BodyGroup bodies(std::vector<double> masses, std::vector<Vector3d> positions, std::vector<Vector3d> velocities) {
  BodyGroup group;
  group.name = "bodies";
  group.mass = std::move(masses);
  group.position = std::move(positions);
  group.velocity = std::move(velocities);
  return group;
}

constexpr double period = 6.32591398;

Scene figure_eight(double duration, double step, const std::string& integrator = "rk4") {
  return scene(bodies({1}, {{0.97000436, -0.24308753, 0}, {-0.97000436, 0.24308753, 0}, {0, 0, 0}},
                      {{0.466203685, 0.43236573, 0}, {0.466203685, 0.43236573, 0}, {-0.93240737, -0.86473146, 0}}),
               {mutual_gravity()}, duration, step, integrator);
}

Scene pleiades(double step) {
  return scene(
      bodies({1, 2, 3, 4, 5, 6, 7}, {{3, 3, 0}, {3, -3, 0}, {-1, 2, 0}, {-3, 0, 0}, {2, 0, 0}, {-2, -4, 0}, {2, 4, 0}},
             {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, -1.25, 0}, {0, 1, 0}, {1.75, 0, 0}, {-1.5, 0, 0}}),
      {mutual_gravity()}, 3, step);
}

World at_end(const Scene& made) {
  World world(made);
  world.step(static_cast<std::uint64_t>(std::llround(made.run.duration / made.run.step)));
  return world;
}

double distance(const World& world, std::size_t id, const Vector3d& place) {
  return (world.body(id).position - place).norm();
}

}  // namespace

TEST_CASE("P-3B: figure of eight, after one and ten periods", "[physics]") {
  World world(figure_eight(10 * period, period / 4000));
  world.step(4000);
  CHECK(distance(world, 0, {0.97000434443112531663, -0.24308754345679379002, 0}) < 1e-9);
  CHECK(distance(world, 2, {3.0055170291137e-8, 2.7919569170671e-8, 0}) < 1e-9);
  world.step(36000);
  CHECK(distance(world, 0, {0.97000421375646287438, -0.24308766531606135216, 0}) < 1e-8);
}

TEST_CASE("P-3B: every method converges at its order", "[physics]") {
  const Vector3d exact(0.97000434443112531663, -0.24308754345679379002, 0);
  for (const IntegratorDescription& row : integrators_for(figure_eight(period, period / 1000))) {
    CAPTURE(row.name);
    const double above = row.order == 10                         ? 96
                         : row.order == 8                        ? 250
                         : row.start_steps > 0 || row.order == 3 ? 8000
                         : row.order == 4                        ? 2000
                                                                 : 1000;
    const double finest = row.order == 1 ? 256000 : row.order == 2 ? 16000 : above;
    const auto error = [&](double steps) {
      return distance(at_end(figure_eight(period, period / steps, row.name)), 0, exact);
    };
    const double slope = std::log2(error(finest / 2) / error(finest));
    CHECK(std::abs(slope - row.order) < (row.order == 10 ? 1 : row.order == 8 ? 0.3 : 0.15));
  }
}

TEST_CASE("P-PL: Pleiades, seven bodies, by rk4 and by every pair", "[physics]") {
  const double x[] = {0.3706139143970502, 3.237284092057233, -3.222559032418324, 0.6597091455775310,
                      0.3425581707156584, 1.562172101400631, -0.7003092922212495};
  const double y[] = {-3.943437585517392, -3.271380973972550,  5.225081843456543, -2.590612434977470,
                      1.198213693392275,  -0.2429682344935824, 1.091449240428980};
  const auto check_end = [&](const World& world, double most) {
    for (std::size_t i = 0; i < 7; ++i) CHECK(distance(world, i, {x[i], y[i], 0}) < most);
  };
  check_end(at_end(pleiades(3e-5)), 5e-8);
  for (const IntegratorDescription& row : integrators()) {
    if (!row.adaptive) continue;
    Scene made = pleiades(0);
    made.run.integrator = row.name;
    made.run.tolerance = 1e-10;
    World world(made);
    world.advance_to(3);
    INFO(row.name << ": " << world.steps() << " steps, " << world.counters().force_evaluations << " evaluations");
    check_end(world, 1e-6);
  }
}

TEST_CASE("P-3B: figure of eight by an adaptive row, after one and ten periods", "[physics]") {
  Scene made = figure_eight(10 * period, 0, "dormand_prince8");
  made.run.tolerance = 1e-13;
  World world(made);
  world.advance_to(period);
  CHECK(distance(world, 0, {0.97000434443112531663, -0.24308754345679379002, 0}) < 1e-9);
  world.advance_to(10 * period);
  CHECK(distance(world, 0, {0.97000421375646287438, -0.24308766531606135216, 0}) < 1e-8);
}

TEST_CASE("Two bodies that attract each other: Kepler's orbit of the reduced mass", "[physics]") {
  // Masses 3 and 1, G = 1: relative motion has mu = 4; circular at distance 1 with speed 2.
  const double time = 1.7, angle = 2 * time;
  const World world = at_end(scene(bodies({3, 1}, {{-0.25, 0, 0}, {0.75, 0, 0}}, {{0, -0.5, 0}, {0, 1.5, 0}}),
                                   {mutual_gravity()}, time, time / 4000));
  CHECK(distance(world, 1, 0.75 * Vector3d(std::cos(angle), std::sin(angle), 0)) < 1e-11);
  CHECK(distance(world, 0, -0.25 * Vector3d(std::cos(angle), std::sin(angle), 0)) < 1e-11);
}

TEST_CASE("Mutual gravity: energy is that of all pairs, softened or not", "[physics]") {
  for (const double softening : {0.0, 0.3}) {
    World world(scene(bodies({1, 2, 4}, {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {}), {mutual_gravity(softening)}, 1, 0.1));
    const auto pair = [&](double masses, double r) { return -masses / std::sqrt(r * r + softening * softening); };
    CHECK(std::abs(world.totals().potential - (pair(2, 3) + pair(4, 4) + pair(8, 5))) < 1e-15 * 16);
  }
}

TEST_CASE("Mutual gravity: two bodies at one place do not pull each other", "[physics]") {
  World world(scene(bodies({1}, {{1, 2, 3}, {1, 2, 3}}, {}), {mutual_gravity()}, 1, 0.125));
  world.step(8);
  for (const std::size_t id : {0, 1}) CHECK(distance(world, id, {1, 2, 3}) == 0);
  CHECK(world.status().code == Status::Code::ok);
}

TEST_CASE("Bonds: two bodies on a damped spring swing as the reduced mass does", "[physics]") {
  // Masses 1 and 3, k = 12, c = 1.2: relative x'' = -16 x - 1.6 x', from a stretch of 0.5 about l = 2.
  const double time = 2.3, decay = 0.8, rate = std::sqrt(16 - decay * decay);
  const World world = at_end(scene(bodies({1, 3}, {{0, 0, 0}, {0, 2.5, 0}}, {{0, 0, 1}, {0, 0, 1}}),
                                   {bonds({{0, 1}}, 12.0, 1.2, 2.0)}, time, time / 4000));
  const double stretch = 0.5 * std::exp(-decay * time) * (std::cos(rate * time) + decay / rate * std::sin(rate * time));
  const double centre = 2.5 * 3 / 4, length = 2 + stretch;
  CHECK(distance(world, 0, {0, centre - 0.75 * length, time}) < 1e-10);
  CHECK(distance(world, 1, {0, centre + 0.25 * length, time}) < 1e-10);
}

TEST_CASE("Bonds: a hanging chain stretches by the weight below each bond", "[physics]") {
  const double g = 9.81, k_hook = 1e5, k[] = {4000.0, 2500.0};
  BodyGroup hook = bodies({1}, {{0, 0, 0}}, {}), links = bodies({2, 0.5}, {{0, 0, -1}, {0, 0, -3}}, {});
  links.name = "links";
  Scene made = scene(hook, {gravity(g), effect("linear_drag", 3)}, 30, 1e-3);
  made.bodies.push_back(links);
  made.effects.push_back(spring(k_hook, 200));
  made.effects.back().groups = {"bodies"};
  made.effects.push_back(bonds({{1, 0}, {2, 1}}, std::vector<double>{k[0], k[1]}, 20.0, -1.0));
  const World world = at_end(made);
  const double top = -3.5 * g / k_hook, middle = top - 1 - 2.5 * g / k[0], bottom = middle - 2 - 0.5 * g / k[1];
  CHECK(distance(world, 0, {0, 0, top}) < 1e-12);
  CHECK(distance(world, 1, {0, 0, middle}) < 1e-12);
  CHECK(distance(world, 2, {0, 0, bottom}) < 1e-12);
}

TEST_CASE("Bonds: the order of the list changes no bit", "[physics]") {
  const auto hash = [](const std::vector<IdPair>& pairs, const std::vector<double>& stiffness) {
    return at_end(scene(bodies({1, 2, 3}, {{0, 0, 0}, {1, 0.3, 0}, {0.2, 1, 1}}, {}),
                        {bonds(pairs, stiffness, 0.1, 0.5)}, 1, 1e-2))
        .state_hash();
  };
  CHECK(hash({{0, 1}, {1, 2}, {0, 2}, {0, 1}}, {1, 2, 3, 4}) == hash({{1, 0}, {2, 0}, {1, 0}, {2, 1}}, {4, 3, 1, 2}));
}

TEST_CASE("Bonds: a step beyond the limit is reported, with the exact limit of two bodies", "[physics]") {
  // k / m_a + k / m_b = 400 / s^2: semi-implicit Euler is stable to 2 / 20 s.
  for (const double step : {0.0999, 0.1001}) {
    const Scene made = scene(bodies({1, 0.25}, {{0, 0, 0}, {1, 0, 0}}, {}), {bonds({{0, 1}}, 80.0, 0.0, -1.0)}, 1, step,
                             "semi_implicit_euler");
    CHECK((World(made).status().code == Status::Code::stability) == (step > 0.1));
  }
}

TEST_CASE("Forces between bodies keep momentum and angular momentum, and energy where nothing damps", "[physics]") {
  // A splitting kicks along the lines between bodies and so keeps angular momentum to rounding; energy is for rk4.
  const auto run = [](double damping, const std::string& integrator) {
    BodyGroup cloud = bodies({0.5}, {}, {});
    cloud.generate =
        Generate{.kind = "lattice", .count = {4, 4, 4}, .spacing = 0.7, .velocity_spread = {0.3, 0.3, 0.3}};
    std::vector<IdPair> pairs;
    for (std::size_t i = 0; i + 1 < 64; ++i) pairs.push_back({i, i + 1});
    World world(scene(cloud, {mutual_gravity(0.3), bonds(pairs, 30.0, damping, -1.0)}, 1, 1e-3, integrator));
    const Totals before = world.totals();
    world.step(1000);
    return std::pair(before, world.totals());
  };
  for (const double damping : {0.0, 0.4}) {
    const auto [before, after] = run(damping, "velocity_verlet");
    CHECK((after.momentum - before.momentum).norm() < 1e-13 * before.momentum_scale);
    CHECK((after.angular_momentum - before.angular_momentum).norm() < 1e-13 * before.angular_momentum_scale);
  }
  const auto [start, end] = run(0, "rk4");
  CHECK(std::abs(end.energy() - start.energy()) < 1e-10 * std::abs(start.energy()));
  const auto [fresh, damped] = run(0.4, "rk4");
  CHECK(damped.energy() - fresh.energy() < -1e-3 * std::abs(fresh.energy()));
}

TEST_CASE("Forces between bodies: copies do not feel each other, and keep the bits of their own run", "[physics]") {
  Scene made = scene(bodies({1, 2, 3}, {{0, 0, 0}, {1, 0.3, 0}, {0.2, 1, 1}}, {}),
                     {mutual_gravity(0.1), bonds({{0, 2}}, 5.0, 0.1, -1.0)}, 1, 1e-2);
  World copies(made, {.copies = 3, .perturb = 1e-3});
  copies.step(100);
  for (std::size_t copy = 0; copy < 3; ++copy) {
    Scene own = made;
    own.run.seed = made.run.seed + copy;
    World alone(own, {.perturb = 1e-3});
    alone.step(100);
    for (std::size_t id = 0; id < 3; ++id) CHECK(copies.body(3 * copy + id).position == alone.body(id).position);
  }
}

TEST_CASE("Bonds: reach for the nearest image where space repeats", "[physics]") {
  Scene made = scene(bodies({1}, {{0.45, 0, 0}, {-0.45, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}),
                     {bonds({{0, 1}}, 100.0, 0.0, -1.0)}, 1, 1e-3);
  made.bodies[0].shape = "sphere", made.bodies[0].radius = {0.01};
  made.contact.kind = "impulse";
  Boundary space;
  space.shape = "periodic", space.size = {1, 1, 1};
  made.boundaries = {space};
  const World world = at_end(made);
  CHECK(std::abs(world.totals().energy() - 1) < 1e-12);
  CHECK(distance(world, 0, {0.45, 0, 0}) < 1e-9);
}
