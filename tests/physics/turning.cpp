// Periods, nutation and precession of pendulums, tops and free bodies; what turning keeps.
#include "tests/catch.h"
#include "tests/physics/crossings.h"
#include "tests/physics/measures.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

constexpr double lean = pi / 6;
const Vector3d asymmetric(1, 2, 3);

World after(const Scene& scene, std::uint64_t steps) {
  World world(scene);
  world.step(steps);
  return world;
}

/// Direction of the top's axis around the vertical [rad].
double azimuth(const World& world) {
  const Vector3d x = world.body(0).position;
  return std::atan2(x.y(), x.x());
}
double cosine_of_lean(const World& world) {
  return world.body(0).position.z() / 0.1;
}
double turned(double from, double to) {
  return std::remainder(to - from, 2 * pi);
}

}  // namespace

TEST_CASE("P-N1: period from 30 and 90 degrees", "[physics]") {
  const std::pair<double, double> periods[] = {{30, 2.04098988951913041}, {90, 2.36784194757623745}};
  for (const auto& [degrees, period] : periods) {
    INFO(degrees << " degrees");
    const Crossing back = first_fall_through_zero(pendulum(degrees * pi / 180, 5, 1e-3), [](const World& world) {
      return static_cast<double>(pendulum_rate(world));
    });
    CHECK(std::abs(back.time / period - 1) < 1e-9);
    CHECK(std::abs(std::atan2(back.state.position.x(), -back.state.position.z()) - degrees * pi / 180) < 1e-9);
  }
}

TEST_CASE("P-R1 and P-R2: the spin comes back after its period", "[physics]") {
  const std::pair<Vector3d, double> periods[] = {{{1, 0.5, -0.7}, 11.1823954296029494},
                                                 {{0.001, 5, 0.001}, 13.2424479626813616}};
  for (const auto& [spin, period] : periods) {
    INFO("from " << spin.transpose());
    Scene made = scene(rigid_body(asymmetric, spin), {}, period, period / 100000);
    made.run.compensated = true;
    const Numbers start = {spin.x(), spin.y(), spin.z()};
    const double tolerance = spin.y() == 5 ? 1e-8 : 1e-9;
    CHECK(largest_difference(body_spin(after(made, 100000), asymmetric), start) < tolerance * spin.norm());
    CHECK(largest_difference(body_spin(after(made, 50000), asymmetric), start) > 0.5);
  }
}

TEST_CASE("P-R2: time between flips", "[physics]") {
  Scene made = scene(rigid_body(asymmetric, {0.001, 5, 0.001}), {}, 30, 1e-4);
  const auto middle = [](const World& world) { return static_cast<double>(body_spin(world, asymmetric)[1]); };
  const Crossing down = first_fall_through_zero(made, middle);
  const Crossing up = first_fall_through_zero(
      made, [&](const World& world) { return -middle(world); }, down.time);
  CHECK(std::abs((up.time - down.time) / 6.6212239813406808 - 1) < 1e-6);
}

TEST_CASE("P-R3: the top nods and precesses with its period", "[physics]") {
  constexpr double period = 0.636778291502150703;
  const Scene made = top(lean, {0, 0, 60}, period, period / 10000);
  const World start(made), half = after(made, 5000), whole = after(made, 10000);
  CHECK(std::abs(cosine_of_lean(half) - std::cos(55.0155875609507462 * pi / 180)) < 1e-9);
  CHECK(std::abs(cosine_of_lean(whole) - std::cos(lean)) < 1e-9);
  CHECK(std::abs(turned(azimuth(start), azimuth(whole)) - 3.85098384174106405 * period) < 1e-9);
}

TEST_CASE("P-R3: steady precession at both roots", "[physics]") {
  for (const double rate : {4.37517077231759947, 12.9453373033711735}) {
    INFO("precession " << rate << " rad/s");
    World world(top(lean, {0, rate * std::sin(lean), 60}, 1, 1e-4));
    const double start = azimuth(world);
    for (int tenth = 1; tenth <= 10; ++tenth) {
      world.step(1000);
      CHECK(std::abs(cosine_of_lean(world) - std::cos(lean)) < 1e-9);
      CHECK(std::abs(turned(start + rate * world.time(), azimuth(world))) < 1e-9 * rate);
    }
  }
}

TEST_CASE("a body without torque keeps its angular momentum bit for bit, and its energy", "[physics]") {
  for (const IntegratorDescription& row : integrators()) {
    INFO(row.name);
    World world(scene(rigid_body(asymmetric, {1, 0.5, -0.7}, {0.6, 0, 0.8, 0}), {}, 100, 1e-2, row.name));
    const Numbers start = column(world, "angular_momentum");
    const double energy = world.totals().energy();
    world.step(10000);
    CHECK(column(world, "angular_momentum") == start);
    const double drift = std::abs(world.totals().energy() / energy - 1);
    const int order = row.family == "splitting" ? 2 : row.order;
    CHECK(drift < (order >= 4 ? 1e-8 : order == 3 ? 1e-4 : order == 2 ? 1e-2 : 1));
  }
}

TEST_CASE("a body on a pivot without gravity keeps its angular momentum about the pivot bit for bit", "[physics]") {
  BodyGroup group = rigid_body({0.01, 0.02, 0.025}, {1, 2, 3});
  group.position = {{0.3, -0.2, 0.5}};
  World world(scene(std::move(group), {pivot()}, 10, 1e-2));
  const Numbers start = column(world, "angular_momentum");
  world.step(1000);
  CHECK(column(world, "angular_momentum") == start);
}

TEST_CASE("a pivot off the body's axes keeps energy and the length of the arm", "[physics]") {
  BodyGroup group = rigid_body({0.01, 0.02, 0.025}, {1, 2, 3}, {0.5, 0.5, -0.5, 0.5});
  group.position = {{0.3, -0.2, 0.5}};
  const double arm = group.position[0].norm();
  World world(scene(std::move(group), {gravity(), pivot()}, 10, 4e-4));
  const Totals start = world.totals();
  double energy = 0, length = 0, vertical = 0;
  for (int n = 0; n < 25000; ++n) {
    world.step();
    const Totals now = world.totals();
    energy = std::max(energy, std::abs(now.energy() - start.energy()));
    vertical = std::max(vertical, std::abs(now.angular_momentum.z() - start.angular_momentum.z()));
    length = std::max(length, std::abs(world.body(0).position.norm() - arm));
  }
  CHECK(energy < 1e-9 * 9.81 * arm);
  CHECK(vertical < 1e-9 * start.angular_momentum_scale);
  CHECK(length < 1e-14);
  CHECK(std::abs(world.body(0).position.dot(world.body(0).velocity)) < 1e-14);
}

TEST_CASE("a pivoted body's start: velocity gives the spin, and energy is that of a rotation about the pivot",
          "[physics]") {
  BodyGroup swinging = particle({0, 0, -2}, {3, 0, 0});
  World mass(scene(swinging, {gravity(), pivot()}, 1, 1e-3));
  CHECK((mass.body(0).angular_velocity - Vector3d(0, -1.5, 0)).norm() < 1e-15);
  CHECK(std::abs(mass.totals().kinetic - 4.5) < 1e-14);

  BodyGroup bar = rigid_body({0.3, 0.3, 0.01}, {2, 0, 0});
  bar.position = {{0, 0, -2}};
  World body(scene(bar, {gravity(), pivot()}, 1, 1e-3));
  CHECK(std::abs(body.totals().kinetic - (0.3 + 4) * 4 / 2) < 1e-14);
  CHECK((body.body(0).velocity - Vector3d(0, 4, 0)).norm() < 1e-14);
}
