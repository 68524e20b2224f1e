// Closed forms of flights solve their equations of motion, for random starts, parameters and times. And what
// they say in double is what they say in extended precision, to rounding.
#include "tests/unit/cost/equations.h"

using namespace equations;

namespace {

Made random_flight(Dice& dice) {
  Made body = particle(dice.vector(3), dice.vector(5), dice.number(0.2, 3));
  if (dice.number(0, 1) < 0.5) {
    body = body.turned(dice.rotation());
    body.inertia = Vector3d::Constant(dice.number(0.1, 2));
    body.start.angular_velocity = dice.vector(5);
  }
  return body;
}

Effect drag(const char* kind, double coefficient) {
  return effect(kind, {{"coefficient", coefficient}});
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
      const Vector3d each(k, dice.number(0.5, 50), dice.number(0.5, 50));
      const Made trapped = more.with(effect("harmonic_trap", {{"centre", dice.vector(1)}, {"stiffness", each}}));
      check_motion(cost::oscillator, check_free, trapped, dice, 10, 1e-5L);
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

TEST_CASE("Closed forms: charges in uniform fields solve their equation", "[cost]") {
  Dice dice(8);
  const auto field = [&](const char* kind, double size) {
    return effect(kind, {{"charge", dice.number(-1, 1)}, {"field", dice.vector(size)}});
  };
  for (int i = 0; i < 20; ++i) {
    const Made body = random_flight(dice);
    const double size = std::pow(10.0, dice.number(-9, 0.5));
    const Made turned = body.with(field("magnetic_field", size)).with(field("magnetic_field", size));
    check_motion(cost::charged_particle, check_free, turned, dice, 10);
    check_motion(cost::charged_particle, check_free, turned.with(field("electric_field", 5)), dice, 10);
    const Made pushed = body.with(random_gravity(dice)).with(field("electric_field", 5));
    check_motion(cost::charged_particle, check_free, pushed, dice, 10);  // no magnetic field: a parabola
    check_motion(cost::charged_particle, check_free, pushed.with(field("magnetic_field", size)), dice, 10);
  }
}

TEST_CASE("Closed forms: oscillators that turn solve their equation", "[cost]") {
  Dice dice(9);
  for (int i = 0; i < 20; ++i) {
    const Made body = random_flight(dice).with(spring(dice.number(0.5, 50), 0, dice.vector(1)));
    const Effect frame = effect(
        "rotating_frame",
        {{"angular_velocity", dice.vector(std::pow(10.0, dice.number(-9, 0.5)))}, {"centrifugal", std::string("off")}});
    const Effect field = effect("magnetic_field", {{"charge", dice.number(-1, 1)}, {"field", dice.vector(3)}});
    const Effect push = effect("electric_field", {{"charge", dice.number(-1, 1)}, {"field", dice.vector(5)}});
    check_motion(cost::foucault, check_free, body.with(frame), dice, 10);
    check_motion(cost::foucault, check_free, body.with(field).with(push), dice, 10);
    const Made all = body.with(frame).with(frame).with(field).with(push).with(random_gravity(dice)).with(spring(2, 0));
    check_motion(cost::foucault, check_free, all, dice, 10);
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
