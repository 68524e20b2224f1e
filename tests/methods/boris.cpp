// The Boris step: velocities turned within the kick.
#include <Eigen/Geometry>

#include "tests/catch.h"
#include "tests/methods/rows.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

Effect electric_field(double charge, const Vector3d& field) {
  return {"electric_field", {}, {{"charge", charge}, {"field", field}}};
}

std::string refusal(const Scene& made) {
  std::string all;
  for (const Problem& problem : check(made)) all += problem.path + ": " + problem.message + "\n";
  return all;
}

void is_of_second_order(const Scene& made, const Numbers& exact) {
  const Refinement r = refine(made, 500, [&](const World& world) {
    const Numbers x = position(world), v = velocity(world);
    return largest_difference({x[0], x[1], v[0], v[1]}, exact);
  });
  INFO(r.errors[0] << ", " << r.errors[1] << ", " << r.errors[2] << ", " << r.errors[3]);
  CHECK(std::abs(r.slope(1) - 2) < 0.1L);
  CHECK(std::abs(r.slope(2) - 2) < 0.1L);
}

}  // namespace

TEST_CASE("boris keeps the speed in a magnetic field to rounding, at any step", "[methods]") {
  for (const double h : {1e-3, 0.1, 10.0}) {
    World world(scene(particle({1, 2, 3}, {1, 0, 0.5}), {magnetic_field(3, {0.5, -1, 2})}, 1e6 * h, h, "boris"));
    CHECK(world.status().code == Status::Code::ok);
    world.step(100000);
    const double change = std::abs(world.body(0).velocity.norm() / std::sqrt(1.25) - 1);
    INFO(h << ": " << change);
    CHECK(change < 1e-12);  // 0.05 ulp a step
    CHECK(world.explain().step_limits.empty());
  }
}

TEST_CASE("P-B1: boris turns by 2 atan(h W / 2) a step, and converges at second order", "[methods]") {
  World world(scene(particle(Vector3d::Zero(), {1, 0, 0.5}), {magnetic_field(3, {0, 0, 2})}, 1, 0.1, "boris"));
  world.step();
  const Vector3d v = world.body(0).velocity;
  CHECK(std::abs(std::atan2(v.y(), v.x()) + 2 * std::atan(0.3)) < 1e-15);
  CHECK(v.z() == 0.5);
  is_of_second_order(scene(particle(Vector3d::Zero(), {1, 0, 0.5}), {magnetic_field(3, {0, 0, 2})}, 4, 1, "boris"),
                     {-0.15092972700110397L, -0.095970165443833837L, 0.42417900733699698L, 0.90557836200662385L});
}

TEST_CASE("boris drifts across electric and magnetic fields at E x B / B^2", "[methods]") {
  // x' - u turns at W = q B / m = 4 about B from v0 - u: after whole turns what is left is the drift.
  const Vector3d electric(0, 3, 0), magnetic(0, 0, 2), drift = electric.cross(magnetic) / magnetic.squaredNorm();
  const double turns = 5, duration = turns * 2 * pi / 4;
  World world(scene(particle(Vector3d::Zero(), {0.5, 0.25, 1}),
                    {magnetic_field(2, magnetic), electric_field(2, electric)}, duration, duration / 20000, "boris"));
  world.step(20000);
  const Vector3d wanted = duration * Vector3d(drift.x(), drift.y(), 1);
  CHECK((world.body(0).position - wanted).norm() < 1e-5 * wanted.norm());
  World coarse(scene(particle(Vector3d::Zero(), drift), {magnetic_field(2, magnetic), electric_field(2, electric)}, 1e4,
                     5, "boris"));  // at many times the step that turns: no force is left, and none is made up
  coarse.step(2000);
  CHECK((coarse.body(0).velocity - drift).norm() < 1e-12);
}

TEST_CASE("boris in a rotating frame: straight flight, seen from it, at second order", "[methods]") {
  const double W = 0.7, T = 3;
  const Vector3d x0(1, 0, 0), v0(0.2, 0.5, 0);  // in the frame, which is at rest's axes at t = 0
  const Vector3d inertial = v0 + Vector3d(0, 0, W).cross(x0);
  const long double c = std::cos(W * T), s = std::sin(W * T);
  const Vector3d x = x0 + T * inertial;
  const long double X = c * x.x() + s * x.y(), Y = -s * x.x() + c * x.y();
  const long double VX = c * inertial.x() + s * inertial.y() + W * Y, VY = -s * inertial.x() + c * inertial.y() - W * X;
  is_of_second_order(scene(particle(x0, v0), {rotating_frame({0, 0, W}, "on")}, T, 1, "boris"), {X, Y, VX, VY});
}

TEST_CASE("boris is leapfrog where nothing turns velocities", "[methods]") {
  World world(scene(particle({1, 0, 0}), {spring(25)}, 10, 0.01, "boris"));
  double x = 1, v = 0;
  for (int n = 0; n < 1000; ++n) {
    x += 0.005 * v;
    v += 0.01 * (-25 * x);
    x += 0.005 * v;
  }
  world.step(1000);
  CHECK(std::abs(world.body(0).position.x() - x) < 1e-13);
}

TEST_CASE("boris refuses what reads velocity otherwise, and pivots that tie it", "[methods]") {
  const Scene drag = scene(particle(Vector3d::Zero(), {1, 0, 0}), {effect("linear_drag", 1)}, 1, 0.1, "boris");
  CHECK(
      refusal(drag).find("boris is of order 2 for forces that do not read velocity or only turn it, but linear_drag") !=
      std::string::npos);
  Scene tied = pendulum(1, 1, 0.01, "boris");
  CHECK(refusal(tied).empty());
  tied.effects.push_back(magnetic_field(1, {0, 0, 1}));
  CHECK(refusal(tied).find("pivot") != std::string::npos);
}
