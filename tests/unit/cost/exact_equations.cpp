// Closed forms solve their equations of motion: residuals by differences in extended precision, for random starts,
// parameters and times. And what they say in double is what they say in extended precision, to rounding.
#include "tests/catch.h"
#include "tests/unit/cost/lone_bodies.h"

using namespace lone_bodies;
namespace cost = ballpark::cost;

namespace {

Vector wide(const Vector3d& a) {
  return a.cast<Real>();
}

/// Formulas of the effects, as their descriptions have them.
Vector force(const Made& body, const State& s) {
  Vector total = Vector::Zero();
  for (const Effect& e : body.effects) {
    const auto number = [&](const char* name) { return Real(cost::number(e, name)); };
    if (e.kind == "gravity") total += Real(body.mass) * wide(cost::vector(e, "acceleration"));
    if (e.kind == "linear_drag") total -= number("coefficient") * s.v;
    if (e.kind == "quadratic_drag") total -= number("coefficient") * s.v.norm() * s.v;
    if (e.kind == "spring")
      total -= number("stiffness") * (s.x - wide(cost::vector(e, "anchor"))) + number("damping") * s.v;
    if (e.kind == "central_gravity") {
      const Vector r = s.x - wide(cost::vector(e, "centre"));
      total -= Real(body.mass) * number("strength") / (r.squaredNorm() * r.norm()) * r;
    }
    if (e.kind == "magnus") total += number("coefficient") * s.w.cross(s.v);
  }
  return total;
}

void check_small(Real residual, Real scale, const char* what, Real t) {
  INFO(what << " at " << t << ": off by " << residual << " of " << scale);
  CHECK(residual <= 1e-9L * scale);
}

Vector momentum(const Made& body, const State& s) {
  const Vector own = s.q.conjugate() * s.w;
  return s.q * Vector(wide(body.inertia.value_or(Vector3d::Zero())).cwiseProduct(own));
}

/// x' = v, m v' = F, q' = w q/2, L' = 0.
void check_free(const Made& body, const ExactMotion& motion, Real t, Real h) {
  const State s = state_at(motion, t);
  const Vector v = rate_of([&](Real at) { return state_at(motion, at).x; }, t, h);
  const Vector a = rate_of([&](Real at) { return state_at(motion, at).v; }, t, h);
  const Vector torque = rate_of([&](Real at) { return momentum(body, state_at(motion, at)); }, t, h);
  const Vector expected = force(body, s) / Real(body.mass);
  check_small((v - s.v).norm(), 1 + s.v.norm(), "x' - v", t);
  check_small((a - expected).norm(), 1 + expected.norm(), "v' - F/m", t);
  check_small(torque.norm(), 1 + momentum(body, s).norm(), "L'", t);
  if (body.start.has_orientation) check_small(turning_error(motion, t, h), 1 + s.w.norm(), "q' - w q/2", t);
}

/// About the pivot at the origin: x = R R0^T x0, v = w x x, q' = w q/2, L' = x cross m g.
void check_pivoted(const Made& body, const ExactMotion& motion, Real t, Real h) {
  const State s = state_at(motion, t), start = state_at(motion, 0);
  const Vector arm = s.q * (start.q.conjugate() * start.x);
  check_small((s.x - arm).norm(), 1e-6L, "x - R a", t);
  check_small((s.v - s.w.cross(s.x)).norm(), 1e-6L * (1 + s.v.norm()), "v - w x a", t);
  check_small(turning_error(motion, t, h), 1 + s.w.norm(), "q' - w q/2", t);
  const auto about_pivot = [&](Real at) -> Vector {
    const State n = state_at(motion, at);
    return momentum(body, n) + Real(body.mass) * n.x.cross(n.v);
  };
  const Vector torque = s.x.cross(force(body, s)), rate = rate_of(about_pivot, t, h);
  check_small((rate - torque).norm(), torque.norm() + 1e-3L * s.w.norm() * about_pivot(t).norm(), "L' - x x F", t);
  if (!body.inertia) check_small(std::abs(s.w.dot(s.x)), 1e-6L, "spin about the arm of a point mass", t);
}

void check_start(const Made& body, const ExactMotion& motion) {
  const State s = state_at(motion, 0);
  const auto& q = body.start.orientation;
  check_small((s.x - wide(body.start.position)).norm(), 1e-8L * (1 + s.x.norm()), "x0", 0);
  check_small((s.v - wide(body.start.velocity)).norm(), 1e-5L * (1 + s.v.norm()), "v0", 0);
  check_small((s.w - wide(body.start.angular_velocity)).norm(), 1e-5L * (1 + s.w.norm()), "w0", 0);
  check_small(1 - std::abs(s.q.dot(Rotation(q.w, q.x, q.y, q.z))), 1e-6L, "q0", 0);
}

using Check = void(const Made&, const ExactMotion&, Real, Real);

/// `h` is small against the motion's own times. The form must be the one that is found for the body.
void check_motion(ClosedForm& form, Check& equations, const Made& body, Dice& dice, double duration, Real h = 1e-3L) {
  const auto motion = form(body.lone()), found = cost::exact_motion(body.lone());
  REQUIRE(motion);
  REQUIRE(found);
  CHECK(motion->what == found->what);
  check_start(body, *motion);
  for (int i = 0; i < 4; ++i) {
    const double t = dice.number(0.01, duration);
    equations(body, *motion, t, h);
    const Real rounding = rounding_of(*motion, t);
    INFO("double against extended at " << t << ": " << rounding);
    CHECK(rounding < 1e-12L);
  }
}

Made random_flight(Dice& dice) {
  Made body = particle(dice.vector(3), dice.vector(5), dice.number(0.2, 3));
  if (dice.number(0, 1) < 0.5) {
    body = body.turned(dice.rotation());
    body.inertia = Vector3d::Constant(dice.number(0.1, 2));
    body.start.angular_velocity = dice.vector(5);
  }
  return body;
}

Effect random_gravity(Dice& dice) {
  return effect("gravity", {{"acceleration", dice.vector(10)}});
}

Effect drag(const char* kind, double coefficient) {
  return effect(kind, {{"coefficient", coefficient}});
}

/// A velocity for a body that is on a pivot at the origin.
Made on_pivot(Made body) {
  const Vector3d x = body.start.position;
  if (!body.inertia) body.start.angular_velocity -= x.dot(body.start.angular_velocity) / x.squaredNorm() * x;
  body.start.velocity = body.start.angular_velocity.cross(x);
  return body.with(pivot());
}

}  // namespace

TEST_CASE("Closed forms: free flight solves its equation", "[cost]") {
  Dice dice(1);
  for (int i = 0; i < 20; ++i) {
    const Made body = random_flight(dice);
    check_motion(cost::ballistic, check_free, body, dice, 10);
    const Made falling = body.with(random_gravity(dice)).with(effect("gravity"));
    check_motion(cost::ballistic, check_free, falling, dice, 10);
    const double k = std::pow(10.0, dice.number(-8, 1));
    check_motion(cost::ballistic, check_free, falling.with(drag("linear_drag", k)).with(drag("linear_drag", 2 * k)),
                 dice, 10);
  }
}

TEST_CASE("Closed forms: straight motion with quadratic drag solves its equation", "[cost]") {
  Dice dice(2);
  for (int i = 0; i < 20; ++i) {
    Made body = random_flight(dice).with(drag("quadratic_drag", dice.number(0.01, 1)));
    check_motion(cost::vertical_drag, check_free, body, dice, 10);
    // Powers of two leave the directions the same to the last bit. At the top |v| v has a kink, not to be stepped over.
    const Vector3d pull = dice.vector(10);
    body = body.with(effect("gravity", {{"acceleration", pull}}));
    for (const double share : {-0.5, 0.0, 0.25, 4.0}) {
      body.start.velocity = share * pull;
      check_motion(cost::vertical_drag, check_free, body, dice, 10, 1e-4L);
    }
  }
}

TEST_CASE("Closed forms: oscillators solve their equation", "[cost]") {
  Dice dice(3);
  for (int i = 0; i < 20; ++i) {
    Made body = random_flight(dice);
    const double m = body.mass, k = dice.number(0.5, 50), critical = 2 * std::sqrt(k * m);
    for (const double share : {0.0, 0.1, 0.999999, 1.0, 1.000001, 2.0, 20.0}) {
      const Made held = body.with(spring(k, share * critical, dice.vector(1)));
      check_motion(cost::oscillator, check_free, held, dice, 10, 1e-5L);
      const Made more = held.with(drag("linear_drag", 0.1)).with(random_gravity(dice)).with(spring(1, 0.2));
      check_motion(cost::oscillator, check_free, more, dice, 10, 1e-5L);
    }
  }
  Made exact = particle({1, 2, 3}, {-1, 0, 2}).with(spring(4, 4));  // critical to the last bit
  check_motion(cost::oscillator, check_free, exact, dice, 10);
  CHECK(cost::oscillator(exact.lone())->in_double(1e4).position[0] == 0);  // nothing overflows
  exact = particle({1, 2, 3}, {-1, 0, 2}).with(spring(4, 4000));
  CHECK(cost::oscillator(exact.lone())->in_double(1e3).position[0] > 0);
}

TEST_CASE("Closed forms: orbits of every eccentricity solve their equation", "[cost]") {
  Dice dice(4);
  for (int i = 0; i < 20; ++i) {
    Made body = random_flight(dice);
    const Vector3d centre = dice.vector(1), r = body.start.position - centre;
    const double strength = dice.number(5, 50), escape = std::sqrt(2 * strength / r.norm());
    body = body.with(effect("central_gravity", {{"centre", centre}, {"strength", strength}}));
    for (const double share : {0.5, 0.7, 0.95, 0.9999999, 1.0, 1.0000001, 1.2, 3.0}) {
      const Vector3d way = r.cross(dice.vector(1)).normalized() + dice.number(-0.6, 0.6) * r.normalized();
      body.start.velocity = share * escape * way.normalized();
      // Sixth differences need steps that are short where it turns fastest.
      check_motion(cost::kepler, check_free, body, dice, 10, 1e-5L * r.norm() / escape);
    }
  }
}

TEST_CASE("Closed forms: steady lift solves its equation", "[cost]") {
  Dice dice(5);
  for (int i = 0; i < 20; ++i) {
    Made body = random_flight(dice).turned(dice.rotation());
    body.inertia = Vector3d::Constant(0.4);
    body.start.angular_velocity = dice.vector(5);
    body = body.with(drag("magnus", std::pow(10.0, dice.number(-9, 0)))).with(drag("magnus", 1e-3));
    check_motion(cost::constant_spin_lift, check_free, body, dice, 10);
    check_motion(cost::constant_spin_lift, check_free, body.with(random_gravity(dice)), dice, 10);
  }
}

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
