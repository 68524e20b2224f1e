// What each row does to linear problems is known exactly: these test the implementation, not its accuracy.
#include <array>
#include <complex>

#include "engine/integrators/rows.h"
#include "tests/catch.h"
#include "tests/methods/order_conditions.h"
#include "tests/methods/rows.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

using Complex = std::complex<long double>;

World oscillator(const std::string& integrator, double z, const Vector3d& velocity = Vector3d::Zero()) {
  return World(scene(particle({1, 0, 0}, velocity), {spring(1)}, 1, z, integrator));
}

/// The Taylor polynomial of exp up to the row's order: what one step multiplies y by for y' = lambda y, w = h lambda.
Complex step_factor(int order, Complex w) {
  Complex sum = 1, term = 1;
  for (int k = 1; k <= order; ++k) sum += term *= w / static_cast<long double>(k);
  return sum;
}

/// What a step of a row multiplies y by.
Complex step_factor(const IntegratorDescription& row, Complex w) {
  return row.family == "Taylor" ? step_factor(row.order, w) : stability_function(*f64::find_row(row.name), w);
}

/// The angle of a step of a body that turns by z: drifts turn it by the midpoint rule, each its share.
long double turn_of(const IntegratorDescription& row, long double z) {
  if (row.family != "splitting") return 2 * std::arg(step_factor(row, Complex(0, z / 2)));
  const f64::Row& shares = *f64::find_row(row.name);
  long double turn = 2 * std::arg(step_factor(2, Complex(0, shares.lead * z / 2)));
  for (const long double share : shares.drift) turn += 2 * std::arg(step_factor(2, Complex(0, share * z / 2)));
  return turn;
}

long double relative(long double measured, long double exact) {
  return std::abs(measured / exact - 1);
}

}  // namespace

TEST_CASE("oscillator: energy ratio after 1000 steps at z = 0.1", "[methods]") {
  const std::vector<std::pair<std::string, long double>> ratios = {{"euler", 20959.15563781366L},
                                                                   {"midpoint", 1.025314800118844L},
                                                                   {"heun", 1.025314800118844L},
                                                                   {"taylor2", 1.025314800118844L},
                                                                   {"rk4", 0.9999861285683352L}};
  for (const auto& [name, ratio] : ratios) {
    INFO(name);
    World world = oscillator(name, 0.1);
    const double start = world.totals().energy();
    world.step(1000);
    CHECK(relative(world.totals().energy() / start, ratio) < 1e-10L);
  }
}

TEST_CASE("oscillator: one-step rows without splitting multiply x + i v by the exponential's series", "[methods]") {
  for (const IntegratorDescription& row : integrators()) {
    if (row.family == "splitting" || row.start_steps > 0) continue;
    for (const double z : {0.1, 0.5}) {
      INFO(row.name << ", z = " << z);
      World world = oscillator(row.name, z, {0.5, 0, 0});
      world.step(200);
      const Complex end = Complex(1, 0.5L) * std::pow(step_factor(row, Complex(0, -z)), 200.0L);
      const Complex measured(position(world)[0], velocity(world)[0]);
      CHECK(std::abs(measured - end) / std::abs(end) < 1e-12L);
    }
  }
}

TEST_CASE("oscillator: implicit rows keep its energy, or divide it by 1 + z^2", "[methods]") {
  for (const double z : {0.1, 0.5, 20.0, 3e5}) {
    for (const char* name : {"implicit_midpoint", "gauss4"}) {
      INFO(name << ", z = " << z);
      World world = oscillator(name, z);
      const double start = world.totals().energy();
      world.step(10000);
      CHECK(relative(world.totals().energy(), start) < 1e-12L);
    }
    World damped = oscillator("backward_euler", z);
    const double start = damped.totals().energy();
    damped.step(20);
    CHECK(relative(damped.totals().energy() / start, std::pow(1 + static_cast<long double>(z) * z, -20.0L)) < 1e-12L);
  }
}

TEST_CASE("oscillator: velocity Verlet turns at (2/h) asin(z/2) and keeps its invariant", "[methods]") {
  const long double z = 0.5L, angle = 2 * std::asin(z / 2);
  World world = oscillator("velocity_verlet", 0.5);
  for (int n = 1; n <= 1000; ++n) {
    world.step();
    const long double x = position(world)[0], v = velocity(world)[0];
    REQUIRE(std::abs(x - std::cos(n * angle)) < 1e-10L);
    REQUIRE(std::abs(v * v + x * x * (1 - z * z / 4) - (1 - z * z / 4)) < 1e-13L);
  }
}

TEST_CASE("oscillator: frequency ratios at z = 0.5", "[methods]") {
  constexpr long double of_verlet = 1.010721020568315L, of_midpoint = 0.9799146525074566L;
  for (const auto& [name, ratio] :
       {std::pair{"velocity_verlet", of_verlet}, std::pair{"semi_implicit_euler", of_verlet},
        std::pair{"implicit_midpoint", of_midpoint}}) {
    INFO(name);
    World world = oscillator(name, 0.5);
    std::array<long double, 3> x{};
    world.step(9);
    for (long double& value : x) {
      world.step();
      value = position(world)[0];
    }
    const long double angle = std::acos((x[0] + x[2]) / (2 * x[1]));  // of x_n = a cos(n angle) + b sin(n angle)
    CHECK(relative(angle / 0.5L, ratio) < 1e-10L);
  }
}

TEST_CASE("oscillator: semi-implicit Euler keeps v^2 + x^2 - z x v", "[methods]") {
  const long double z = 0.1L;
  World world = oscillator("semi_implicit_euler", 0.1);
  long double largest_change = 0;
  for (int n = 0; n < 1000; ++n) {
    world.step();
    const long double x = position(world)[0], v = velocity(world)[0];
    largest_change = std::max(largest_change, std::abs(v * v + x * x - z * x * v - 1));
  }
  CHECK(largest_change < 1e-13L);
}

TEST_CASE("free fall: Euler errs by g h T/2, second order and above are exact", "[methods]") {
  constexpr double g = 9.81, h = 1.0 / 128, duration = 4;
  const long double fall = g * duration * duration / 2;
  for (const IntegratorDescription& row : integrators()) {
    INFO(row.name);
    World world(scene(particle(Vector3d::Zero(), {3, 0, 0}), {gravity(g)}, duration, h, row.name));
    world.step(512);
    const long double error = position(world)[2] + fall;
    if (row.order == 1) {
      const long double side = row.symplectic || row.implicit ? -1 : 1;  // too high, or too low with the new velocity
      CHECK(relative(error, side * g * h * duration / 2) < 1e-10L);
    } else {
      CHECK(std::abs(error) < 1e-13L * fall);
    }
    CHECK(relative(velocity(world)[2], -g * duration) < 1e-13L);
    CHECK(std::abs(position(world)[0] - 12) < 1e-14L * 512);
  }
}

TEST_CASE("rotation per step at constant spin: the quaternion's series, normalised", "[methods]") {
  for (const IntegratorDescription& row : integrators()) {
    if (row.start_steps > 0) continue;  // looks back at several steps
    for (const long double z : {0.1L, 1.0L}) {
      INFO(row.name << ", z = " << static_cast<double>(z));
      BodyGroup group = ball();
      group.orientation = {Quaternion{}};
      group.angular_velocity = {{0, 0, static_cast<double>(z)}};
      World world(scene(std::move(group), {}, 1, 1, row.name));
      const long double turn = turn_of(row, z);
      for (int n = 1; n <= 5; ++n) {
        world.step();
        const Numbers q = column(world, "orientation");
        CHECK(std::abs(2 * std::atan2(q[3], q[0]) - n * turn) < 1e-10L * n * turn);
      }
      if (row.name == "euler") {
        CHECK(std::abs(turn / z - (z < 0.5L ? 0.99916791L : 0.92729522L)) < 1e-8L);
        CHECK(relative(turn, 2 * std::atan(z / 2)) < 1e-15L);
      }
    }
  }
}

TEST_CASE("the quaternion has norm 1 after each step", "[methods]") {
  BodyGroup turning = ball();
  turning.orientation = {{0.6, 0, 0.8, 0}};
  turning.angular_velocity = {{3, -2, 5}};
  const Effect torque{"torque", {}, {{"torque", Vector3d(1, 0.5, -0.25)}}};
  for (const std::string& name : integrator_names()) {
    for (const Scene& made :
         {scene(turning, {torque}, 1, 0.01, name), scene(rigid_body({1, 2, 3}, {1, 0.5, -0.7}), {}, 1, 0.05, name),
          pendulum(1, 1, 0.05, name)}) {
      INFO(name << ", " << made.bodies[0].name);
      World world(made);
      for (int n = 0; n < 100; ++n) {
        world.step();
        const Numbers q = column(world, "orientation");
        const long double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        REQUIRE(std::abs(norm - 1) <= 1e-15L);
      }
    }
  }
}
