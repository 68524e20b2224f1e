// Where closed forms would lose digits or meet a convention: short times, starts next to an equilibrium, point masses.
#include "tests/catch.h"
#include "tests/unit/cost/lone_bodies.h"

using namespace lone_bodies;
namespace cost = ballpark::cost;

namespace {

Made hung(const Made& body) {
  return body.turned(Eigen::Quaterniond::Identity()).with(effect("gravity")).with(pivot());
}

}  // namespace

TEST_CASE("Closed forms: a short fall through air is g t^2/2 and v t, to its last digit", "[cost]") {
  const Effect drag = effect("quadratic_drag", {{"coefficient", 0.05}});
  for (const double speed : {0.0, 1.0, -1.0}) {
    const Made stone = particle({0, 0, 0}, {0, 0, -speed}).with(effect("gravity")).with(drag);
    const auto motion = cost::vertical_drag(stone.lone());
    REQUIRE(motion);
    const double t = 1e-7;  // of which drag makes 1e-9 at most
    const double way = -motion->in_double(t).position[2], free = speed * t + 9.81 / 2 * t * t;
    CHECK(std::abs(way - free) <= 1e-8 * std::abs(free));
  }
}

TEST_CASE("Closed forms: a pendulum that just falls back from the top, or just passes it", "[cost]") {
  for (const double speed : {1e-7, 3.132e-7, 4e-7}) {
    Made bob = hung(particle({1e-7, 0, 1}, {0, 0, 0}));
    bob.start.angular_velocity = {0, -speed, 0};
    bob.start.velocity = bob.start.angular_velocity.cross(bob.start.position);
    const auto motion = cost::pendulum(bob.lone());
    REQUIRE(motion);
    // Next to it theta - pi =: y grows as y'' = W^2 y: the first second is known to y^2 = 1e-8.
    const Real w = std::sqrt(Real(9.81)), fast = speed;
    for (const double t : {0.0, 1.0}) {
      const Real lean = 1e-7 * std::cosh(w * t) - fast / w * std::sinh(w * t);
      const Real turn = 1e-7 * w * std::sinh(w * t) - fast * std::cosh(w * t);
      const ExactState<double> rounded = motion->in_double(t);
      const ExactState<Real> s = motion->in_extended(t);
      INFO("speed " << speed << " at " << t);
      CHECK(std::abs(s.position[0] - lean) <= 1e-16L);
      CHECK(std::abs(s.angular_velocity[1] - turn) <= 1e-16L);
      CHECK(std::abs(rounded.position[0] - lean) <= 2e-13L);  // angles near 1 are rounded, and grow
      CHECK(std::abs(rounded.angular_velocity[1] - turn) <= 2e-13L);
    }
  }
}

TEST_CASE("Closed forms: a point mass on a pivot keeps no spin about its arm", "[cost]") {
  Made ball = hung(particle({1, 0, 0}, {0, 0, 0}));
  ball.start.angular_velocity = {7, 1, 2};
  const auto motion = cost::symmetric_top(ball.lone());
  REQUIRE(motion);
  CHECK((state_at(*motion, 0).w - Vector(0, 1, 2)).norm() < 1e-17L);
}

TEST_CASE("Closed forms: on a pivot a velocity tells the spin if none is given", "[cost]") {
  const auto swing = cost::pendulum(hung(particle({0, 0, -2}, {3, 0, 0})).lone());
  REQUIRE(swing);
  CHECK((state_at(*swing, 0).w - Vector(0, -1.5L, 0)).norm() < 1e-17L);
  CHECK((state_at(*swing, 0).v - Vector(3, 0, 0)).norm() < 1e-17L);
}

TEST_CASE("Closed forms: what carries no orientation is given none, what does turns by its spin", "[cost]") {
  Made ball = rigid({1, 1, 1}, {0, 0, 2});
  const auto turning = cost::ballistic(ball.lone());
  ball.start.has_orientation = false;
  const auto plain = cost::ballistic(ball.lone());
  REQUIRE(turning);
  REQUIRE(plain);
  CHECK(plain->in_double(1).orientation == std::array<double, 4>{1, 0, 0, 0});
  CHECK(std::abs(turning->in_double(1).orientation[3] - std::sin(1.0)) < 1e-15);
  CHECK(plain->in_double(1).angular_velocity == std::array<double, 3>{0, 0, 2});
}
