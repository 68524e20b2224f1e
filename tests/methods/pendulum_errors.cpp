// x'' = -9.81 sin x from 90 degrees, as an effect of the caller's own: each row's error at t = 10 is known.
#include "engine/core/maths.h"
#include "engine/integrators/families.h"
#include "engine/integrators/rows.h"
#include "tests/catch.h"
#include "tests/methods/rows.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

constexpr long double angle_at_10 = 0.278680673569982948L, rate_at_10 = -4.34316069286468305L;
constexpr double duration = 10;

UserEffect sine_force() {
  UserEffect effect;
  effect.name = "sine";
  effect.reads_velocity = false;
  effect.run_double = [](const BodyBlock<double>& block) {
    for (std::size_t i = 0; i < block.count; ++i) {
      block.force[0][i] += block.mass[i] * -9.81 * maths::sin(block.position[0][i]);
    }
  };
  return effect;
}

Scene swing(const std::string& integrator, int n) {
  return scene(particle({pi / 2, 0, 0}), {}, duration, duration / n, integrator);
}

double error_of(long double angle, long double rate) {
  return static_cast<double>(std::max(std::abs(angle - angle_at_10), std::abs(rate - rate_at_10)));
}

/// The same without the engine: a row's coefficients on two numbers, in extended precision.
double plain_error_at_10(const f64::Row& row, int n) {
  const long double h = static_cast<long double>(duration) / n;
  const auto force = [](long double x) { return -9.81L * std::sin(x); };
  long double x = std::acos(-1.0L) / 2, v = 0;
  for (int step = 0; step < n; ++step) {
    if (row.family == f64::Family::splitting) {
      x += h * row.lead * v;
      for (int i = 0; i < row.phases; ++i) {
        v += h * row.kick[i] * force(x);
        x += h * row.drift[i] * v;
      }
      continue;
    }
    long double rate[f64::max_phases][2], next_x = x, next_v = v;
    for (int i = 0; i < row.phases; ++i) {
      long double at_x = x, at_v = v;
      for (int j = 0; j < i; ++j) {
        at_x += h * row.a[i][j] * rate[j][0];
        at_v += h * row.a[i][j] * rate[j][1];
      }
      rate[i][0] = at_v;
      rate[i][1] = force(at_x);
      next_x += h * row.b[i] * rate[i][0];
      next_v += h * row.b[i] * rate[i][1];
    }
    x = next_x;
    v = next_v;
  }
  return static_cast<double>(std::max(std::abs(x - angle_at_10), std::abs(v - rate_at_10)));
}

double error_at_10(const std::string& integrator, int n) {
  World world(swing(integrator, n), {}, {sine_force()});
  world.step(static_cast<std::uint64_t>(n));
  return error_of(position(world)[0], velocity(world)[0]);
}

/// The same force as the engine's families see one, with its derivative: user effects have none.
struct SineForces {
  f64::Loads<double> loads(const f64::Body<double>& b, double) const {
    return {{-9.81 * maths::sin(b.position.x), 0, 0}, {}};
  }
  f64::Loads<double> load_rates(const f64::Body<double>& b, const f64::Acceleration<double>&) const {
    return {{-9.81 * maths::cos(b.position.x) * b.velocity.x, 0, 0}, {}};
  }
};

double taylor_error_at_10(int n) {
  using Point = f64::FreeMotion<f64::Spin::none>;
  const f64::Method method = f64::method_for(*f64::find_row("taylor2"), duration / n);
  f64::BodyConstants constants;
  constants.mass.value = constants.effective_mass.value = 1;
  const auto c = Point::constants<double>(constants, 0);
  f64::State<Point, double> state{};
  state.y[0] = pi / 2;
  for (int step = 0; step < n; ++step) {
    f64::whole_step<f64::Taylor>(method, c, SineForces{}, {}, state);
  }
  return error_of(state.y[0], state.y[3]);
}

}  // namespace

TEST_CASE("pendulum equation as a user effect: the reference table's errors", "[methods]") {
  struct Printed {
    const char* integrator;
    double errors[3];  // at n = 1000, 2000, 4000
  };
  const std::vector<Printed> table = {{"euler", {9.05, 3.26, 1.02}},
                                      {"semi_implicit_euler", {2.17e-2, 1.09e-2, 5.43e-3}},
                                      {"velocity_verlet", {1.21e-3, 3.02e-4, 7.55e-5}},
                                      {"midpoint", {3.06e-3, 8.35e-4, 2.18e-4}},
                                      {"rk4", {1.25e-7, 8.99e-9, 5.99e-10}},
                                      {"dormand_prince5", {1.08e-9, 3.33e-11, 1.03e-12}},
                                      {"ab2", {1.07e-2, 2.85e-3, 7.34e-4}},
                                      {"ab4", {6.77e-6, 4.64e-7, 3.02e-8}}};
  for (const Printed& row : table) {
    for (int i = 0; i < 3; ++i) {
      const int n = 1000 << i;
      const double measured = error_at_10(row.integrator, n), printed = row.errors[i];
      INFO(row.integrator << ", n = " << n << ": " << measured << " against " << printed);
      CHECK(std::abs(measured / printed - 1) < 0.05);
    }
  }
}

TEST_CASE("pendulum equation as a user effect: the errors of a loop over two numbers", "[methods]") {
  for (const f64::Row& row : f64::rows()) {
    // One has a case of its own, others look back, or need the force's derivatives.
    if (row.family == f64::Family::taylor || row.history > 0) continue;
    if (row.family == f64::Family::implicit_runge_kutta) continue;
    for (const int n : {125, 250}) {
      const double measured = error_at_10(row.name, n), expected = plain_error_at_10(row, n);
      INFO(row.name << ", n = " << n << ": " << measured << " against " << expected);
      if (expected < 1e-14) {  // of double's rounding
        CHECK(measured < 1e-13);
        continue;
      }
      CHECK(std::abs(measured / expected - 1) < (expected < 1e-11 ? 0.1 : 1e-3));  // rounding shows
    }
  }
}

TEST_CASE("pendulum equation with its force's derivative: Taylor-2's printed errors", "[methods]") {
  const double printed[] = {4.15e-3, 1.12e-3, 2.91e-4};
  for (int i = 0; i < 3; ++i) {
    const double measured = taylor_error_at_10(1000 << i);
    INFO("n = " << (1000 << i) << ": " << measured << " against " << printed[i]);
    CHECK(std::abs(measured / printed[i] - 1) < 0.05);
  }
}

TEST_CASE("taylor2 refuses a force without a derivative, and says what to take instead", "[methods]") {
  std::string message;
  try {
    const World world(swing("taylor2", 1000), {}, {sine_force()});
  } catch (const SceneError& error) {
    message = error.what();
  }
  INFO(message);
  CHECK(message.find("run.integrator") != std::string::npos);
  CHECK(message.find("sine") != std::string::npos);
  CHECK(message.find("derivative") != std::string::npos);
  CHECK(message.find("midpoint") != std::string::npos);
}
