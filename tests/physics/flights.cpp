// Throws through the air: apex, landing, return.
#include "tests/catch.h"
#include "tests/physics/crossings.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

double height(const World& world) {
  return world.body(0).position.z();
}
double climb(const World& world) {
  return world.body(0).velocity.z();
}
bool close(double measured, double exact, double scale) {
  return std::abs(measured - exact) <= 1e-9 * scale;
}

Scene thrown(const Vector3d& velocity, double drag) {
  return scene(particle(Vector3d::Zero(), velocity), {gravity(), effect("quadratic_drag", drag)}, 10, 1e-3);
}

}  // namespace

TEST_CASE("P-D1: thrown up at 30 m/s, rise and return", "[physics]") {
  const Scene made = thrown({0, 0, 30}, 0.05);
  const Crossing apex = first_fall_through_zero(made, climb), landing = first_fall_through_zero(made, height);
  CHECK(close(apex.time, 1.61913657554119766, 1.6));
  CHECK(close(apex.state.position.z(), 17.2047038548075332, 17.2));
  CHECK(close(landing.time - apex.time, 2.14932469859823933, 2.1));
  CHECK(close(landing.state.velocity.z(), -12.6918770811241523, 30));
}

TEST_CASE("P-D2: apex and landing", "[physics]") {
  const double angle = 35 * pi / 180;
  const Scene made = thrown({40 * std::cos(angle), 0, 40 * std::sin(angle)}, 0.02);
  const Crossing apex = first_fall_through_zero(made, climb), landing = first_fall_through_zero(made, height);
  CHECK(close(apex.time, 1.50260953381078391, 1.5));
  CHECK(close(apex.state.position.x(), 32.999794595694707, 33));
  CHECK(close(apex.state.position.z(), 14.237949071913812, 14));
  CHECK(close(landing.time, 3.36235340424308239, 3.4));
  CHECK(close(landing.state.position.x(), 55.5999856357256778, 55));
  CHECK(close(landing.state.velocity.x(), 9.0360078419414477, 33));
  CHECK(close(landing.state.velocity.z(), -13.9115316985291476, 33));
}

TEST_CASE("P-D2: what Euler, midpoint and RK4 miss the position at 3 s by", "[physics]") {
  const double angle = 35 * pi / 180;
  struct Printed {
    const char* integrator;
    double errors[3];  // at steps of 0.1, 0.05 and 0.01 s
  };
  for (const Printed& row : {Printed{"euler", {.364, .186, .0378}}, Printed{"midpoint", {2.37e-2, 5.71e-3, 2.21e-4}},
                             Printed{"rk4", {4.04e-5, 2.34e-6, 3.52e-9}}}) {
    for (int i = 0; i < 3; ++i) {
      Scene made = thrown({40 * std::cos(angle), 0, 40 * std::sin(angle)}, 0.02);
      const int steps[] = {30, 60, 300};
      made.run.step = 3.0 / steps[i];
      made.run.integrator = row.integrator;
      World world(made);
      world.step(static_cast<std::uint64_t>(steps[i]));
      const double error = (world.body(0).position - Vector3d(52.1250704508110414, 0, 4.68004363794871736)).norm();
      INFO(row.integrator << " in " << steps[i] << " steps: " << error << " against " << row.errors[i]);
      CHECK(std::abs(error / row.errors[i] - 1) < 0.01);
    }
  }
}
