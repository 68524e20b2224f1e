// The spring-dashpot law: damping for a restitution and back, the push and Coulomb's limit.
#include <cmath>

#include "engine/contact/penalty_law.h"
#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

TEST_CASE("Penalty law: restitution of a damping ratio, as published", "[contact]") {
  CHECK(std::abs(restitution_of(0.3, true) - 0.3723261049) < 1e-10);
  CHECK(std::abs(restitution_of(0.3, false) - 0.4509754529) < 1e-10);
  CHECK(restitution_of(0, false) == 1);
  CHECK(restitution_of(0, true) == 1);
  CHECK(restitution_of(1, true) == 0);
  CHECK(std::abs(restitution_of(1, false) - std::exp(-2.0)) < 1e-15);
  for (const double b : {1 - 1e-9, 1 + 1e-9}) CHECK(std::abs(restitution_of(b, false) - std::exp(-2.0)) < 1e-8);
}

TEST_CASE("Penalty law: the damping ratio is the inverse of the restitution", "[contact]") {
  CHECK(damping_ratio(1, false) == 0);
  CHECK(damping_ratio(1, true) == 0);
  CHECK(damping_ratio(0, true) == 1);
  for (const double e : {0.003, 0.05, 0.1353, 0.4, 0.9, 0.999}) {
    CAPTURE(e);
    CHECK(std::abs(restitution_of(damping_ratio(e, false), false) - e) < 1e-12);
    CHECK(std::abs(restitution_of(damping_ratio(e, true), true) - e) < 1e-12);
  }
}

TEST_CASE("Penalty law: a dashpot pulls only if it may, friction is at most mu times the push", "[contact]") {
  const SpringDashpot law{1000, 10, 300, 2, Real(0.5)};
  Touch touch;
  touch.depth = Real(0.01), touch.normal = {0, 0, 1}, touch.parting = Real(0.5);
  CHECK(push(law, touch, false) == 5);
  touch.parting = 2;
  CHECK(push(law, touch, false) == 0);
  CHECK(push(law, touch, true) == -10);
  Real share;
  touch.slip = {Real(0.5), 0, 0};
  const Vector3<Real> held = friction(law, touch, 10, {Real(0.01), 0, 0}, share);
  CHECK(held.x == -4);
  CHECK(share == 1);
  const Vector3<Real> slipping = friction(law, touch, 6, {Real(0.01), 0, 0}, share);
  CHECK(std::abs(slipping.x + 3) < Real(1e-6));
  CHECK(std::abs(share - Real(0.75)) < Real(1e-6));
  CHECK(length(friction(law, touch, -6, {Real(0.01), 0, 0}, share)) == 0);  // a pull holds nothing
}
