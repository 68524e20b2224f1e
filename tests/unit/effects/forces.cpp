// Each effect's force against its formula, its energy as the force's potential, its force derivative against the
// difference of forces along a path, and its stiffness against the force's response.
#include <limits>

#include "tests/unit/effects/effect_checks.h"

using namespace effect_checks;

namespace {

const Value vector = Vector3d(1, -2, 0.5);
const std::vector<Vector3d> anchor{{0.1, 0.2, -0.3}};

}  // namespace

TEST_CASE("Effects: gravity", "[effects]") {
  const auto c = packed<Gravity>({{"acceleration", vector}});
  CHECK(near(loads<Gravity>(c, body).force, {2.5, -5, 1.25}, 1e-15));
  CHECK(near(loads<Gravity>(c, body).torque, {}, 0));
  check_energy<Gravity>(c);
  check_force_rate<Gravity>(c);
}

TEST_CASE("Effects: linear drag", "[effects]") {
  const auto c = packed<LinearDrag>({{"coefficient", 0.5}});
  CHECK(near(loads<LinearDrag>(c, body).force, {-0.75, -0.125, 1}, 1e-15));
  check_force_rate<LinearDrag>(c);
}

TEST_CASE("Effects: quadratic drag", "[effects]") {
  const auto c = packed<QuadraticDrag>({{"coefficient", 0.5}});
  const double speed = std::sqrt(1.5 * 1.5 + 0.25 * 0.25 + 4);
  CHECK(near(loads<QuadraticDrag>(c, body).force, -0.5 * speed * body.velocity, 1e-15));
  check_force_rate<QuadraticDrag>(c);
  Body<Real> still = body;
  still.velocity = {};
  Loads<Real> rate;
  QuadraticDrag::force_rate(c, still, bend, rate);
  CHECK(near(rate.force, {}, 0));
}

TEST_CASE("Effects: Magnus lift", "[effects]") {
  const auto c = packed<Magnus>({{"coefficient", 2.0}});
  CHECK(near(loads<Magnus>(c, body).force, {2 * 1.875, 2 * 6.75, 2 * 2.25}, 1e-15));
  check_force_rate<Magnus>(c);
}

TEST_CASE("Effects: springs with and without length, damped", "[effects]") {
  for (const double length : {0.0, 0.4, 5.0}) {
    const auto c = packed<Spring>({{"anchor", anchor}, {"stiffness", 8.0}, {"damping", 0.5}, {"rest_length", length}});
    const Vector r = {0.2, -0.9, 1.4};
    const double distance = std::sqrt(dot(r, r));
    const Vector expected = (-8 * (distance - length) / distance) * r - 0.5 * body.velocity;
    CAPTURE(length);
    CHECK(near(loads<Spring>(c, body).force, expected, 1e-14));
    check_energy<Spring>(c);
    check_force_rate<Spring>(c);
    Body<Real> there = body;
    there.position = {0.1, 0.2, -0.3};
    there.velocity = {};
    CHECK(near(loads<Spring>(c, there).force, {}, 0));
    CHECK(std::abs(Spring::energy(c, there) - 4 * length * length) < 1e-12);
  }
}

TEST_CASE("Effects: central gravity, softened and not", "[effects]") {
  for (const double softening : {0.0, 0.5}) {
    const auto c = packed<CentralGravity>({{"centre", vector}, {"strength", 3.0}, {"softening", softening}});
    const Vector r = body.position - Vector{1, -2, 0.5};
    const double square = dot(r, r) + softening * softening;
    CHECK(near(loads<CentralGravity>(c, body).force, (-2.5 * 3 / std::pow(square, 1.5)) * r, 1e-14));
    check_energy<CentralGravity>(c);
    check_force_rate<CentralGravity>(c);
  }
}

TEST_CASE("Effects: electric field", "[effects]") {
  const auto c = packed<ElectricField>({{"charge", -3.0}, {"field", vector}});
  CHECK(near(loads<ElectricField>(c, body).force, {-3, 6, -1.5}, 1e-15));
  CHECK(std::abs(ElectricField::energy(c, body) - 3 * (0.3 + 1.4 + 0.55)) < 1e-14);
  check_energy<ElectricField>(c);
  check_force_rate<ElectricField>(c);
}

TEST_CASE("Effects: magnetic field, across the velocity", "[effects]") {
  const auto c = packed<MagneticField>({{"charge", -3.0}, {"field", vector}});
  const Vector force = loads<MagneticField>(c, body).force;
  CHECK(near(force, {-3 * -3.875, -3 * -2.75, -3 * -3.25}, 1e-15));
  CHECK(std::abs(dot(force, body.velocity)) < 1e-14);
  check_force_rate<MagneticField>(c);
}

TEST_CASE("Effects: rotating frame, Coriolis force with and without the centrifugal one", "[effects]") {
  const Vector rate = {1, -2, 0.5}, r = body.position - Vector{0.5, 1, -1};
  const Vector coriolis = -2 * body.mass * cross(rate, body.velocity);
  const Vector centrifugal = -body.mass * cross(rate, cross(rate, r));
  for (const std::string choice : {"on", "off"}) {
    CAPTURE(choice);
    const auto c =
        packed<RotatingFrame>({{"angular_velocity", vector}, {"point", Vector3d(0.5, 1, -1)}, {"centrifugal", choice}});
    const Vector expected = choice == "on" ? coriolis + centrifugal : coriolis;
    CHECK(near(loads<RotatingFrame>(c, body).force, expected, 1e-15));
    const Vector swept = cross(rate, r);
    const double energy = choice == "on" ? -body.mass / 2 * dot(swept, swept) : 0;
    CHECK(std::abs(RotatingFrame::energy(c, body) - energy) < 1e-14);
    check_energy<RotatingFrame>(c);
    check_force_rate<RotatingFrame>(c);
  }
}

TEST_CASE("Effects: applied force and torque, while they last and where they act", "[effects]") {
  const double forever = std::numeric_limits<double>::infinity();
  auto force =
      packed<AppliedForce>({{"force", vector}, {"offset", Vector3d(0, 0, 2)}, {"at", 0.0}, {"until", forever}});
  auto torque = packed<AppliedTorque>({{"torque", vector}, {"at", 0.0}, {"until", forever}});
  CHECK(near(loads<AppliedForce>(force, body).force, {1, -2, 0.5}, 0));
  CHECK(near(loads<AppliedForce>(force, body).torque, {4, 2, 0}, 1e-15));
  CHECK(near(loads<AppliedTorque>(torque, body).torque, {1, -2, 0.5}, 0));
  CHECK(near(loads<AppliedTorque>(torque, body).force, {}, 0));
  check_force_rate<AppliedForce>(force);
  check_force_rate<AppliedTorque>(torque);
  force.rows.row = torque.rows.row = 3;
  CHECK(near(loads<AppliedForce>(force, body).force, {}, 0));
  CHECK(near(loads<AppliedTorque>(torque, body).torque, {}, 0));
  force.rows.row = torque.rows.row = 0;
  CHECK(near(loads<AppliedForce>(force, body).force, {1, -2, 0.5}, 0));
  force.window.active = torque.window.active = false;
  CHECK(near(loads<AppliedForce>(force, body).force, {}, 0));
  CHECK(near(loads<AppliedTorque>(torque, body).torque, {}, 0));
}

TEST_CASE("Effects: stiffness is the force's response", "[effects]") {
  const auto input = [](const std::map<std::string, Value>& parameters, double speed) {
    return EffectInput{parameters, speed, {}, 2.0};
  };
  const std::map<std::string, Value> spring{
      {"anchor", anchor}, {"stiffness", 8.0}, {"damping", 0.5}, {"rest_length", 1.0}};
  CHECK(Spring::stiffness(input(spring, 3)).spring == 8);
  CHECK(Spring::stiffness(input(spring, 3)).damping == 0.5);
  const std::map<std::string, Value> drag{{"coefficient", 0.5}};
  CHECK(LinearDrag::stiffness(input(drag, 3)).damping == 0.5);
  CHECK(QuadraticDrag::stiffness(input(drag, 3)).damping == 3);  // d(k v^2)/dv = 2 k v
  const std::map<std::string, Value> field{{"charge", -3.0}, {"field", Vector3d(2, 0, 0)}};
  CHECK(MagneticField::stiffness(input(field, 3)).gyration == 6);
  CHECK(MagneticField::stiffness(input(field, 3)).damping == 0);
  std::map<std::string, Value> frame{{"angular_velocity", Vector3d(0, 3, 4)}, {"centrifugal", std::string("off")}};
  CHECK(RotatingFrame::stiffness(input(frame, 3)).gyration == 20);  // 2 m W
  CHECK(RotatingFrame::stiffness(input(frame, 3)).spring == 0);
  frame["centrifugal"] = std::string("on");
  CHECK(RotatingFrame::stiffness(input(frame, 3)).spring == -50);  // - m W^2
}
