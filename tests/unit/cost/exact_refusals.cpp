// What closed forms do not cover exactly, they refuse.
#include "tests/catch.h"
#include "tests/unit/cost/lone_bodies.h"

using namespace lone_bodies;
namespace cost = ballpark::cost;

namespace {

const Effect pull = effect("gravity");
const Effect thin_air = effect("linear_drag", {{"coefficient", 0.1}});
const Effect air = effect("quadratic_drag", {{"coefficient", 0.1}});
const Effect lift = effect("magnus", {{"coefficient", 0.1}});
const Effect field = effect("magnetic_field", {{"charge", 2.0}, {"field", Vector3d(0, 0, 1)}});
const Effect push = effect("electric_field", {{"charge", 2.0}, {"field", Vector3d(0, 1, 1)}});
const Effect frame =
    effect("rotating_frame", {{"angular_velocity", Vector3d(0, 0, 1)}, {"centrifugal", std::string("off")}});
const Effect sun = effect("central_gravity", {{"strength", 5.0}});

bool taken(ClosedForm& form, const Made& body) {
  return form(body.lone()).has_value();
}

bool taken(const Made& body) {
  return cost::exact_motion(body.lone()).has_value();
}

Effect with(Effect made, const std::string& parameter, const Value& value) {
  made.parameters[parameter] = value;
  return made;
}

Made bob() {
  return particle({1, 0, 0}, {0, 0, 0}).turned(Eigen::Quaterniond::Identity());
}

}  // namespace

TEST_CASE("Closed forms: an effect that no form knows is refused by all", "[cost]") {
  const std::vector<Effect> strangers = {effect("force", {{"force", Vector3d(0, 0, 1)}}),
                                         effect("torque", {{"torque", Vector3d(0, 0, 1)}}),
                                         effect("mutual_gravity"),
                                         effect("bonds"),
                                         effect("lennard_jones"),
                                         effect("soft_repulsion"),
                                         effect("wind of the user's")};
  const std::vector<Made> bodies = {particle({1, 0, 0}, {0, 1, 0}).with(pull),
                                    particle({1, 0, 0}, {0, 0, 1}).with(pull).with(air),
                                    particle({1, 0, 0}, {0, 1, 0}).with(spring(5, 0)),
                                    particle({1, 0, 0}, {0, 1, 0}).with(sun),
                                    particle({1, 0, 0}, {0, 1, 0}).with(field).with(push),
                                    particle({1, 0, 0}, {0, 1, 0}).with(spring(5, 0)).with(frame),
                                    bob().with(pull).with(pivot()),
                                    rigid({1, 2, 2.5}, {1, 2, 3}),
                                    rigid({1, 1, 1.5}, {1, 2, 3}, {0, 0, 1}, {2, -1, 0}).with(pull).with(pivot()),
                                    rigid({1, 1, 1}, {1, 2, 3}, {0, 0, 0}, {1, 0, 0}).with(lift)};
  for (const Made& body : bodies) {
    CHECK(taken(body));
    for (const Effect& stranger : strangers) CHECK(!taken(body.with(stranger)));
  }
}

TEST_CASE("Closed forms: free flight and lift are for balls", "[cost]") {
  const Made brick = rigid({1, 2, 2.5}, {1, 2, 3}, {0, 0, 0}, {1, 0, 0});
  CHECK(!taken(cost::ballistic, brick));
  CHECK(!taken(cost::ballistic, rigid({1, 1, 1.0000001}, {1, 2, 3})));
  CHECK(taken(cost::ballistic, rigid({1, 2, 2.5}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0})));
  CHECK(!taken(brick.with(lift)));
  CHECK(!taken(rigid({1, 1, 1}, {1, 2, 3}, {0, 0, 0}, {1, 0, 0}).with(lift).with(air)));
  CHECK(!taken(rigid({1, 1, 1}, {1, 2, 3}, {0, 0, 0}, {1, 0, 0}).with(lift).with(thin_air)));
}

TEST_CASE("Closed forms: quadratic drag across gravity is refused", "[cost]") {
  CHECK(taken(particle({0, 0, 0}, {0, 0, 1}).with(pull).with(air)));
  CHECK(!taken(particle({0, 0, 0}, {1e-12, 0, 1}).with(pull).with(air)));
  CHECK(!taken(particle({0, 0, 0}, {0, 0, 1}).with(pull).with(air).with(thin_air)));
  CHECK(!taken(rigid({1, 2, 2.5}, {1, 2, 3}, {0, 0, 0}, {0, 0, 1}).with(pull).with(air)));
  CHECK(!taken(cost::vertical_drag, particle({0, 0, 0}, {0, 0, 1}).with(pull)));
}

TEST_CASE("Closed forms: springs with a rest length, or none, are refused", "[cost]") {
  const Made mass = particle({1, 0, 0}, {0, 1, 0});
  CHECK(taken(mass.with(spring(5, 1))));
  CHECK(!taken(mass.with(with(spring(5, 1), "rest_length", 0.5))));
  CHECK(!taken(mass.with(spring(5, 1)).with(with(spring(5, 1), "rest_length", 0.5))));
  CHECK(!taken(mass.with(spring(0, 1))));
  const auto trap = [](const Vector3d& stiffness) { return effect("harmonic_trap", {{"stiffness", stiffness}}); };
  CHECK(taken(mass.with(trap({5, 1, 2}))));
  CHECK(!taken(mass.with(trap({5, 0, 2}))));
  CHECK(!taken(mass.with(trap({5, -1, 2}))));
  CHECK(taken(mass.with(trap({5, -1, 2})).with(spring(2, 0))));
  CHECK(!taken(mass.with(trap({5, 1, 2})).with(effect("wind", {{"velocity", Vector3d(1, 0, 0)}}))));
  CHECK(!taken(mass.with(spring(5, 1)).with(air)));
  CHECK(!taken(rigid({1, 2, 2.5}, {1, 2, 3}, {1, 0, 0}).with(spring(5, 1))));
}

TEST_CASE("Closed forms: charges with drag, and bricks, are refused", "[cost]") {
  const Made charge = particle({1, 0, 0}, {0, 1, 0});
  CHECK(taken(charge.with(field).with(push).with(pull)));
  CHECK(taken(charge.with(push)));
  CHECK(!taken(charge.with(field).with(thin_air)));
  CHECK(!taken(charge.with(field).with(frame)));
  CHECK(!taken(charge.with(push).with(sun)));
  CHECK(!taken(rigid({1, 1, 1}, {1, 2, 3}, {0, 0, 0}, {1, 0, 0}).with(field).with(lift)));
  CHECK(!taken(rigid({1, 2, 2.5}, {1, 2, 3}, {0, 0, 0}, {1, 0, 0}).with(field)));
}

TEST_CASE("Closed forms: oscillators in a frame with its centrifugal force, damped or stretched, are refused",
          "[cost]") {
  const Made mass = particle({1, 0, 0}, {0, 1, 0});
  const Effect whole = with(frame, "centrifugal", std::string("on"));
  CHECK(taken(mass.with(spring(5, 0)).with(frame)));
  CHECK(taken(mass.with(spring(5, 0)).with(frame).with(field).with(push).with(pull)));
  CHECK(!taken(mass.with(spring(5, 0)).with(whole)));
  CHECK(!taken(mass.with(spring(5, 0)).with(frame).with(whole)));
  CHECK(!taken(mass.with(spring(5, 1)).with(frame)));
  CHECK(!taken(mass.with(with(spring(5, 0), "rest_length", 0.5)).with(frame)));
  CHECK(!taken(mass.with(spring(0, 0)).with(frame)));
  CHECK(!taken(mass.with(frame)));
}

TEST_CASE("Closed forms: orbits of other forces, and falls into the sun, are refused", "[cost]") {
  const Made planet = particle({1, 0, 0}, {0, 1, 0});
  CHECK(taken(planet.with(sun)));
  CHECK(!taken(planet.with(with(sun, "softening", 0.1))));
  CHECK(!taken(planet.with(with(sun, "strength", -1.0))));
  CHECK(!taken(planet.with(sun).with(sun)));
  CHECK(!taken(planet.with(sun).with(pull)));
  CHECK(!taken(particle({1, 0, 0}, {0, 0, 0}).with(sun)));
  CHECK(!taken(particle({1, 0, 0}, {-1, 0, 0}).with(sun)));
}

TEST_CASE("Closed forms: pendulums out of their plane are refused", "[cost]") {
  const Made hung = bob().with(pull).with(pivot());
  CHECK(taken(cost::pendulum, hung));
  CHECK(!taken(hung.with(pivot({0, 0, 1}))));
  CHECK(!taken(hung.with(thin_air)));
  Made aside = hung;
  aside.start.angular_velocity = {0, 1, 1e-9};
  CHECK(!taken(cost::pendulum, aside));
  CHECK(taken(cost::symmetric_top, aside));  // it is a spherical pendulum
  Made rod = hung;
  rod.inertia = Vector3d(1, 2, 2.5);
  CHECK(taken(cost::pendulum, rod));
  CHECK(!taken(rod.turned(Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Vector3d::UnitX())))));  // pulled out of its plane
  rod.start.angular_velocity = {1, 0, 0};
  CHECK(!taken(rod));
}

TEST_CASE("Closed forms: a free body on the separatrix itself is refused", "[cost]") {
  CHECK(!taken(rigid({1, 2, 2.25}, {0.75, 1, 1})));  // 2 E I2 = L^2 to the last bit, and forever to the next flip
  CHECK(taken(rigid({1, 2, 2.25}, {0.75, 1, 1.000001})));
  CHECK(taken(rigid({1, 2, 2.25}, {0, 1, 0})));
  CHECK(!taken(rigid({1, 2, 2.5}, {1, 2, 3}).with(sun)));
  CHECK(!taken(rigid({1, 2, 2.5}, {1, 2, 3}).with(air)));
}

TEST_CASE("Closed forms: tops that are not symmetric about their arm are refused", "[cost]") {
  const auto top = [](const Vector3d& inertia, const Vector3d& arm) {
    const Vector3d spin(1, 2, 30);
    return rigid(inertia, spin, arm, spin.cross(arm)).with(pull).with(pivot());
  };
  CHECK(taken(top({1, 1, 0.5}, {0, 0, 1})));
  CHECK(taken(top({1, 1, 1}, {1, 2, 3})));
  CHECK(taken(top({0.5, 1, 1}, {-1, 0, 0})));
  CHECK(!taken(top({1, 1 + 1e-9, 0.5}, {0, 0, 1})));
  CHECK(!taken(top({1, 1, 0.5}, {1e-9, 0, 1})));
  CHECK(!taken(top({1, 1, 0.5}, {0, 1, 0})));
  CHECK(!taken(top({1, 1, 0.5}, {0, 0, 1}).with(lift)));
  CHECK(!taken(rigid({1, 1, 0.5}, {1, 2, 30}, {0, 0, 1}, {2, -1, 0}).with(pivot())));  // no gravity: no vertical
}

TEST_CASE("Closed forms: parameters come from the scene, then from the catalogue", "[cost]") {
  CHECK(cost::vector(pull, "acceleration") == Vector3d(0, 0, -9.81));
  CHECK(cost::vector(with(pull, "acceleration", Vector3d(1, 2, 3)), "acceleration") == Vector3d(1, 2, 3));
  CHECK(cost::number(sun, "softening") == 0);
  CHECK(cost::number(sun, "strength") == 5);
  CHECK(std::isnan(cost::number(sun, "mass")));
  CHECK(cost::word(frame, "centrifugal") == "off");
  CHECK(cost::word(effect("rotating_frame"), "centrifugal") == "on");
  CHECK(cost::word(sun, "centrifugal").empty());
  const Effect rows = effect("pivot", {{"point", std::vector<Vector3d>{{1, 0, 0}, {2, 0, 0}}}});
  CHECK(cost::vector(rows, "point", 1) == Vector3d(2, 0, 0));
  CHECK(cost::vector(pivot({3, 0, 0}), "point", 1) == Vector3d(3, 0, 0));
}
