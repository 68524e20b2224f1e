// Closed forms of rotations solve their equations of motion, for random starts, parameters and times. And what
// they say in double is what they say in extended precision, to rounding.
#include "tests/unit/cost/equations.h"

using namespace equations;

namespace {

/// A velocity for a body that is on a pivot at the origin.
Made on_pivot(Made body) {
  const Vector3d x = body.start.position;
  if (!body.inertia) body.start.angular_velocity -= x.dot(body.start.angular_velocity) / x.squaredNorm() * x;
  body.start.velocity = body.start.angular_velocity.cross(x);
  return body.with(pivot());
}

}  // namespace

TEST_CASE("Closed forms: free bodies solve Euler's equations", "[cost]") {
  Dice dice(6);
  const std::vector<Vector3d> spins = {{1, 0, 0}, {0, -2, 0}, {0, 0, 3}, {1, 1e-9, 0}, {1e-9, 1e-9, -1}, {0, 1, 1e-4}};
  for (int i = 0; i < 30; ++i) {
    const double one = dice.number(0.3, 1), other = dice.number(0.3, 1), least = std::abs(one - other);
    const Vector3d unequal(one, dice.number(least, one + other), other);
    for (const Vector3d& moments :
         {unequal, Vector3d(one, one, 0.2), Vector3d(one, 0.2, one), Vector3d(0.2, one, one)}) {
      Made body = rigid(moments, dice.vector(4), dice.vector(1), dice.vector(3)).turned(dice.rotation());
      check_motion(cost::torque_free, check_free, body, dice, 10);
      check_motion(cost::torque_free, check_free, body.with(random_gravity(dice)), dice, 10);
      body = body.turned(Eigen::Quaterniond::Identity());
      body.start.angular_velocity = spins[static_cast<std::size_t>(i) % spins.size()];
      const auto motion = cost::torque_free(body.lone());
      REQUIRE(motion);
      check_start(body, *motion);
      check_free(body, *motion, dice.number(0, 10), 1e-3L);
    }
  }
}

TEST_CASE("Closed forms: needles, discs and nearly equal moments solve Euler's equations", "[cost]") {
  Dice dice(7);
  for (const Vector3d& moments :
       {Vector3d(1e-6, 1, 1.0000005), Vector3d(1, 2, 3 - 1e-9), Vector3d(1, 1 + 1e-9, 1 - 1e-9),
        Vector3d(1, 1 + 1e-12, 1.5), Vector3d(0.5, 1 - 1e-12, 1)}) {
    for (int i = 0; i < 5; ++i) {
      const Made body = rigid(moments, dice.vector(2)).turned(dice.rotation());
      const auto motion = cost::torque_free(body.lone());
      REQUIRE(motion);
      check_start(body, *motion);
      // A needle spins fast about its length.
      check_free(body, *motion, dice.number(0, 10), 1e-3L);
    }
  }
}

TEST_CASE("Closed forms: pendulums solve their equation, to and fro and over the top", "[cost]") {
  Dice dice(8);
  for (int i = 0; i < 20; ++i) {
    const double length = dice.number(0.5, 2), angle = dice.number(-3.1, 3.1), mass = dice.number(0.5, 3);
    const Vector3d x = length * Vector3d(std::sin(angle), 0, -std::cos(angle));
    for (const double speed : {0.0, 1.0, -3.0, 10.0, -20.0}) {
      Made bob = particle(x, Vector3d::Zero(), mass).turned(dice.rotation()).with(effect("gravity"));
      bob.start.angular_velocity = {0, speed, 0};
      check_motion(cost::pendulum, check_pivoted, on_pivot(bob), dice, 10);
      Made rod = bob.turned(Eigen::Quaterniond(0, 1, 0, 0));
      rod.inertia = Vector3d(0.3, 0.7, 0.5);
      check_motion(cost::pendulum, check_pivoted, on_pivot(rod), dice, 10);
      Made tilted = on_pivot(bob).with(effect("gravity", {{"acceleration", Vector3d(5, 0, 3)}}));
      check_motion(cost::pendulum, check_pivoted, tilted, dice, 10);
    }
  }
}

TEST_CASE("Closed forms: pendulums close to the top's equilibrium", "[cost]") {
  Dice dice(9);
  for (const double more : {-1e-3, -1e-9, -1e-15, 0.0, 1e-15, 1e-9, 1e-3}) {
    Made bob = particle({0, 0, -1}, {0, 0, 0}).turned(dice.rotation()).with(effect("gravity"));
    bob.start.angular_velocity = {0, 2 * std::sqrt(9.81) * (1 + more), 0};
    const auto motion = cost::pendulum(on_pivot(bob).lone());
    REQUIRE(motion);
    for (const double t : {0.3, 2.0, 5.0, 30.0}) check_pivoted(on_pivot(bob), *motion, t, 1e-3L);
  }
  for (const Vector3d& x : {Vector3d(0, 0, 1), Vector3d(0, 0, -1)}) {
    Made still = particle(x, {0, 0, 0}).turned(dice.rotation()).with(effect("gravity")).with(pivot());
    check_motion(cost::pendulum, check_pivoted, still, dice, 10);
  }
  Made upright = particle({1e-7, 0, 1}, {0, 0, 0}).turned(dice.rotation()).with(effect("gravity")).with(pivot());
  const auto motion = cost::pendulum(upright.lone());
  REQUIRE(motion);
  for (const double t : {1.0, 5.0, 5.5, 11.0}) check_pivoted(upright, *motion, t, 1e-3L);
}

TEST_CASE("Closed forms: tops solve Euler's equations about their pivot", "[cost]") {
  Dice dice(10);
  for (int i = 0; i < 20; ++i) {
    const double across = dice.number(0.5, 1), along = dice.number(0.1, 1), length = dice.number(0.3, 2);
    for (const double spin : {0.0, 3.0, -20.0}) {
      const Eigen::Quaterniond q = dice.rotation();
      Made top = rigid({across, across, along}, q * (dice.vector(3) + Vector3d(0, 0, spin)), q * Vector3d(0, 0, length),
                       {0, 0, 0}, dice.number(0.3, 2));
      top = top.turned(q).with(effect("gravity"));
      check_motion(cost::symmetric_top, check_pivoted, on_pivot(top), dice, 5, 2e-4L);
      top.inertia = Vector3d::Constant(along);
      check_motion(cost::symmetric_top, check_pivoted, on_pivot(top), dice, 5, 2e-4L);
      top.inertia.reset();  // a spherical pendulum
      check_motion(cost::symmetric_top, check_pivoted, on_pivot(top), dice, 5, 2e-4L);
      top.effects = {random_gravity(dice)};
      check_motion(cost::symmetric_top, check_pivoted, on_pivot(top), dice, 5, 2e-4L);
    }
  }
}

TEST_CASE("Closed forms: tops from a cusp, upright, hanging, and in steady precession", "[cost]") {
  Dice dice(11);
  const Eigen::Quaterniond lean(Eigen::AngleAxisd(0.5, Vector3d::UnitX()));
  const auto top = [](const Eigen::Quaterniond& q, const Vector3d& spin, double way) {
    Made body = rigid({0.01, 0.01, 0.005}, spin, q * Vector3d(0, 0, 0.1 * way)).turned(q);
    return on_pivot(body.with(effect("gravity")));
  };
  const auto straight = Eigen::Quaterniond::Identity();
  check_motion(cost::symmetric_top, check_pivoted, top(lean, lean * Vector3d(0, 0, 60), 1), dice, 5, 1e-4L);
  for (const double way : {1.0, -1.0}) {
    for (const double spin : {60.0, 5.0, -5.0}) {
      check_motion(cost::symmetric_top, check_pivoted, top(straight, {0, 0, spin}, way), dice, 5, 1e-4L);
      // Kicked from the vertical: the axis comes back through it, again and again.
      check_motion(cost::symmetric_top, check_pivoted, top(straight, {3, -1, spin}, way), dice, 5, 1e-4L);
      check_motion(cost::symmetric_top, check_pivoted, top(straight, {1e-5, 0, spin}, way), dice, 2, 1e-4L);
    }
  }
  // P of I1 cos P^2 - I3 w3 P + m g l = 0, the axial spin being w3.
  const double cosine = std::cos(0.5), i1 = 0.02, i3 = 0.005, w3 = 60, mgl = 0.981;
  const double rate = (i3 * w3 - std::sqrt(i3 * i3 * w3 * w3 - 4 * i1 * cosine * mgl)) / (2 * i1 * cosine);
  const Vector3d axis = lean * Vector3d(0, 0, 1), up(0, 0, 1);
  const Made steady = top(lean, w3 * axis + rate * (up - cosine * axis), 1);
  check_motion(cost::symmetric_top, check_pivoted, steady, dice, 5, 1e-4L);
  const auto motion = cost::symmetric_top(steady.lone());
  CHECK(std::abs(state_at(*motion, 3.3L).x.z() - Real(steady.start.position.z())) < 1e-15L);
  // Almost through the zenith: b - a of rounding's size and more.
  for (const double miss : {1e-16, 1e-12, 1e-8, 1e-4}) {
    Made near = top(lean, {0, 0, 0}, 1);
    const Vector3d side = (lean * Vector3d(1, 0, 0)), swing = up.cross(axis).normalized();
    near.start.angular_velocity = 6 * (up + axis) + 25 * swing + miss * side;
    near.start.velocity = near.start.angular_velocity.cross(near.start.position);
    check_motion(cost::symmetric_top, check_pivoted, near, dice, 3, 1e-6L);
  }
}
