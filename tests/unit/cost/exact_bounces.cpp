// Closed forms: a ball that bounces on a plane. With g = 8 m/s^2 and a fall of 1 m the first impact is at 0.5 s and
// 4 m/s, and at e = 1/2 all times are binary fractions.
#include "ballpark/ballpark.h"
#include "ballpark/scenes.h"
#include "perf/cost/reference.h"
#include "tests/catch.h"
#include "tests/unit/cost/lone_bodies.h"

using namespace lone_bodies;
namespace cost = ballpark::cost;
using ballpark::BodyGroup;
using ballpark::Scene;

namespace {

constexpr double radius = 0.125;

BodyGroup ball_at(const Vector3d& position, const Vector3d& velocity = Vector3d::Zero()) {
  return {.name = "ball",
          .shape = "sphere",
          .material = "rubber",
          .radius = {radius},
          .mass = {1},
          .position = {position},
          .velocity = {velocity},
          .angular_velocity = {{0, 0, 0}}};
}

/// From 1 m above the floor z = 0, with an upward speed.
Scene drop(double restitution, double g = 8, double speed = 0) {
  Scene scene;
  scene.bodies = {ball_at({0, 0, 1 + radius}, {0, 0, speed})};
  scene.effects = {effect("gravity", {{"acceleration", Vector3d(0, 0, -g)}})};
  scene.materials["rubber"] = {restitution, 0};
  scene.boundaries = {{.shape = "plane", .material = "rubber"}};
  scene.contact.kind = "impulse";
  return scene;
}

std::optional<ExactMotion> taken(const Scene& scene, std::size_t id = 0) {
  cost::TouchingBodies all{scene, {}};
  for (const BodyGroup& group : scene.bodies) {
    LoneBody ball{group, 0, {}, {}, 1, Vector3d::Constant(0.4 * radius * radius)};
    for (const Effect& effect : scene.effects) ball.effects.push_back(&effect);
    ball.start.position = group.position.front();
    ball.start.velocity = group.velocity.front();
    ball.start.angular_velocity = group.angular_velocity.front();
    ball.start.has_orientation = ball.start.has_angular_velocity = true;
    all.bodies.push_back(ball);
  }
  return cost::exact_motion(all, id);
}

ExactMotion motion_of(const Scene& scene, std::size_t id = 0) {
  const auto motion = taken(scene, id);
  REQUIRE(motion);
  return *motion;
}

Real height(const ExactMotion& motion, Real t) {
  return state_at(motion, t).x.z() - radius;
}
Real speed(const ExactMotion& motion, Real t) {
  return state_at(motion, t).v.z();
}

/// In both precisions, to the last bit.
void check_exactly(const ExactMotion& motion, double t, double height, double speed) {
  INFO("at " << t);
  CHECK(motion.in_double(t).position[2] == radius + height);
  CHECK(motion.in_double(t).velocity[2] == speed);
  CHECK(motion.in_extended(t).position[2] == radius + height);
  CHECK(motion.in_extended(t).velocity[2] == speed);
}

struct Bounced {
  Real height, speed, nearest;  // and how far from an impact [s]
};

/// The same motion impact by impact.
Bounced by_impacts(Real height, Real speed, Real g, Real e, Real t) {
  Real flight = (speed + std::sqrt(speed * speed + 2 * g * height)) / g, gone = t;
  while (t > flight && flight > 1e-15L) {
    t -= flight;
    speed = e * (g * flight - speed);
    height = 0;
    flight = 2 * speed / g;
    gone = t;
  }
  if (t > flight) return {0, 0, 1};
  return {height + speed * t - g * t * t / 2, speed - g * t, std::min(gone, flight - t)};
}

}  // namespace

TEST_CASE("Bounces: dropped from 1 m at e = 0.8, time of rest and path (numerics 2.2)", "[cost]") {
  const double g = 9.81, e = 0.8;
  const ExactMotion motion = motion_of(drop(e, g));
  const Real rest = 4.0637127688715781L;
  CHECK(speed(motion, rest - 1e-14L) != 0);
  for (const double late : {1e-14, 1e-3, 1.0, 1e9}) check_exactly(motion, double(rest) + late, 0, 0);
  const Real fall = std::sqrt(2 / Real(g));
  Real impact = fall, path = 1;
  for (Real up = e * fall; up > 1e-12L; up *= e) {
    path += 2 * height(motion, impact + up);
    CHECK(std::abs(speed(motion, impact + up)) < 1e-16L);
    impact += 2 * up;
  }
  CHECK(std::abs(path - (1 + 0.64L) / (1 - 0.64L)) < 5e-15L);
}

TEST_CASE("Bounces: at impacts and next to them, exactly", "[cost]") {
  const ExactMotion motion = motion_of(drop(0.5));
  const double bit = 0x1p-20;
  check_exactly(motion, 0, 1, 0);
  double impact = 0.5, before = 4;
  for (int k = 1; k <= 8; ++k, before /= 2) {
    check_exactly(motion, impact, 0, -before);
    check_exactly(motion, impact - bit, before * bit - 4 * bit * bit, 8 * bit - before);
    check_exactly(motion, impact + bit, before / 2 * bit - 4 * bit * bit, before / 2 - 8 * bit);
    impact += before / 8;
  }
  check_exactly(motion, 1.5, 0, 0);
  check_exactly(motion, 2, 0, 0);
}

TEST_CASE("Bounces: e = 0 ends them, e = 1 never does", "[cost]") {
  const ExactMotion clay = motion_of(drop(0));
  check_exactly(clay, 0.5 - 0x1p-20, 0x1p-18 - 0x1p-38, 0x1p-17 - 4);
  check_exactly(clay, 0.5, 0, -4);
  check_exactly(clay, 0.5 + 0x1p-40, 0, 0);
  const ExactMotion ideal = motion_of(drop(1));
  for (const double n : {0.0, 1.0, 2.0, 1e6, 1e12}) {
    check_exactly(ideal, n, 1, 0);
    check_exactly(ideal, n + 0.25, 0.75, -2);
    check_exactly(ideal, n + 0.5, 0, -4);
    check_exactly(ideal, n + 0.75, 0.75, 2);
  }
}

TEST_CASE("Bounces: starts on the floor", "[cost]") {
  for (const double e : {0.0, 0.5, 1.0}) {
    Scene scene = drop(e);
    scene.bodies.front().position = {{3, 4, radius}};
    for (const double t : {0.0, 1e-9, 0.1, 100.0}) check_exactly(motion_of(scene), t, 0, 0);
    scene.bodies.front().velocity = {{0, 0, 4}};
    check_exactly(motion_of(scene), 0.5, 1, 0);
    check_exactly(motion_of(scene), 1, 0, -4);
    scene.bodies.front().velocity = {{0, 0, -4}};
    check_exactly(motion_of(scene), 0, 0, -4);
    check_exactly(motion_of(scene), 0x1p-20, 4 * e * 0x1p-20 - (e > 0 ? 0x1p-38 : 0), 4 * e - (e > 0 ? 0x1p-17 : 0));
  }
}

TEST_CASE("Bounces: energy after k impacts is e^2k", "[cost]") {
  for (const double e : {0.3, 0.8, 0.99, 1.0}) {
    const ExactMotion motion = motion_of(drop(e, 9.81, -2));
    const Real g = 9.81, start = 2 + g, impact = std::sqrt(4 + 2 * g);
    Real begin = (impact - 2) / g, flight = 2 * e * impact / g, share = Real(e) * e;
    for (int k = 1; k <= 30 && share > 1e-8L; ++k, begin += flight, flight *= e, share *= Real(e) * e) {
      for (const Real part : {0.1L, 0.5L, 0.9L}) {
        const Real t = begin + part * flight, v = speed(motion, t);
        INFO("e " << e << ", impact " << k);
        CHECK(std::abs(g * height(motion, t) + v * v / 2 - share * start) <= 1e-17L * share * start + 1e-18L);
      }
    }
  }
}

TEST_CASE("Bounces: as impact by impact, in either precision", "[cost]") {
  Dice dice(7);
  int compared = 0;
  for (int n = 0; n < 400; ++n) {
    const double e = n % 5 == 0 ? 1 : dice.number(0.2, 0.97), t = dice.number(0, 8);
    Scene scene = drop(e, dice.number(1, 20), dice.number(-5, 5));
    const Bounced expected = by_impacts(1, scene.bodies.front().velocity.front().z(),
                                        -cost::vector(scene.effects.front(), "acceleration").z(), e, t);
    if (expected.nearest < 1e-6L) continue;
    ++compared;
    const ExactMotion motion = motion_of(scene);
    INFO("e " << e << " at " << t);
    CHECK(std::abs(height(motion, t) - expected.height) < 1e-15L);
    CHECK(std::abs(speed(motion, t) - expected.speed) < 1e-14L);
    CHECK(rounding_of(motion, t) < 4e-13L);
  }
  CHECK(compared > 300);
}

TEST_CASE("Bounces: tilted planes, away from the origin, with drift and spin", "[cost]") {
  Dice dice(8);
  for (int n = 0; n < 50; ++n) {
    const Eigen::Quaterniond turn = dice.rotation();
    const Vector3d point = dice.vector(1), drift(dice.number(-1, 1), dice.number(-1, 1), 0), spin = dice.vector(3);
    const Scene flat = drop(0.75, 9.81, 1);
    Scene scene = flat;
    scene.effects = {effect("gravity", {{"acceleration", turn * Vector3d(0, 0, -9.81)}})};
    scene.boundaries.front().point = point;
    scene.boundaries.front().normal = 3 * (turn * Vector3d(0, 0, 1));
    scene.bodies = {ball_at(point + turn * Vector3d(2, 3, 1 + radius), turn * (Vector3d(0, 0, 1) + drift))};
    scene.bodies.front().angular_velocity = {spin};
    const double t = dice.number(0, 5);
    const State s = state_at(motion_of(scene), t), like = state_at(motion_of(flat), t);
    const Rotation back = turn.cast<Real>().conjugate();
    const Vector x = back * Vector(s.x - point.cast<Real>()), v = back * s.v;
    CHECK((x - like.x - t * drift.cast<Real>() - Vector(2, 3, 0)).norm() < 1e-12L);
    CHECK((v - like.v - drift.cast<Real>()).norm() < 1e-12L);
    CHECK((s.w - spin.cast<Real>()).norm() == 0);
    CHECK(std::abs(s.q.w() - std::cos(spin.cast<Real>().norm() * t / 2)) < 1e-18L);
  }
}

TEST_CASE("Bounces: billions of them cost no more than one", "[cost]") {
  const double e = 1 - 0x1p-40;  // which is no longer told from 1 by e^n alone
  const ExactMotion motion = motion_of(drop(e));
  const Real lost = 0x1p-40L, first = 0.5L;
  for (const Real n : {1e3L, 1e6L, 1e9L, 1e12L}) {
    const Real begin = first - std::expm1(n * std::log1p(-lost)) * e / lost,
               up = std::exp((n + 1) * std::log1p(-lost)) / 2;
    INFO(n << " flights");
    CHECK(std::abs(height(motion, begin + up) - 4 * up * up) < 1e-14L);
    CHECK(std::abs(speed(motion, begin + up)) < 1e-6L);
  }
  const ExactMotion soon = motion_of(drop(0.999999999));  // at rest after 1e9 s, and flights too short for any clock
  for (const Real left : {1e-3L, 1e-9L, 1e-12L}) {
    const Real rest = 0.5L + 0.999999999L / (1 - Real(0.999999999));
    CHECK(std::abs(height(soon, rest * (1 - left))) < 2 * left * left);
  }
}

TEST_CASE("Bounces: restitution of a pair, of two materials, of none", "[cost]") {
  Scene scene = drop(0.5);
  scene.materials["floor"] = {1, 0};
  scene.boundaries.front().material = "floor";
  const auto after = [](const Scene& s) { return speed(motion_of(s), 0.5L + 0x1p-60L) / 4; };
  const auto is = [](Real found, Real expected) { return std::abs(found - expected) < 1e-17L; };
  CHECK(is(after(scene), std::sqrt(0.5L)));
  scene.material_pairs = {{{"rubber", "rubber"}, 0.125, 0}, {{"floor", "rubber"}, 0.25, 0}};
  CHECK(is(after(scene), 0.25L));
  std::swap(scene.material_pairs.back().between[0], scene.material_pairs.back().between[1]);
  CHECK(is(after(scene), 0.25L));
  scene.bodies.front().material = "";
  CHECK(is(after(scene), 1));
  scene.boundaries.front().material = "rubber";
  CHECK(is(after(scene), std::sqrt(0.5L)));
}

TEST_CASE("Bounces: other walls, laws and forces are refused", "[cost]") {
  const Scene good = drop(0.5);
  CHECK(taken(good));
  const auto refused = [&](auto change) {
    Scene scene = good;
    change(scene);
    return !taken(scene);
  };
  CHECK(refused([](Scene& s) { s.contact.kind = "penalty"; }));
  CHECK(refused([](Scene& s) { s.contact.restitution_threshold = 1e-9; }));
  CHECK(refused([](Scene& s) { s.boundaries.clear(); }));
  CHECK(refused([](Scene& s) { s.boundaries.push_back(s.boundaries.front()); }));
  CHECK(refused([](Scene& s) { s.boundaries.push_back({.shape = "periodic", .size = {9, 9, 0}}); }));
  CHECK(refused([](Scene& s) { s.boundaries = {{.shape = "box", .size = {9, 9, 9}}}; }));
  CHECK(refused([](Scene& s) { s.boundaries.front().motion.emplace().velocity = {0, 0, 1}; }));
  CHECK(refused([](Scene& s) { s.boundaries.front().surface_velocity = {1, 0, 0}; }));
  CHECK(refused([](Scene& s) { s.boundaries.front().normal = {0, 1e-9, 1}; }));
  CHECK(refused([](Scene& s) { s.boundaries.front().normal = {0, 0, -1}; }));
  CHECK(refused([](Scene& s) { s.boundaries.front().point = {0, 0, 1e-9 + 1}; }));  // overlaps
  CHECK(refused([](Scene& s) { s.effects.clear(); }));
  CHECK(refused([](Scene& s) { s.effects.push_back(effect("linear_drag", {{"coefficient", 0.1}})); }));
  CHECK(refused([](Scene& s) { s.effects.push_back(effect("magnus", {{"coefficient", 0.1}})); }));
  CHECK(refused([](Scene& s) { s.bodies.front().shape = ""; }));
  CHECK(!refused([](Scene& s) { s.boundaries.front().point = {5, -7, 1}; }));  // touches
}

TEST_CASE("Bounces: what friction would turn or slow is refused", "[cost]") {
  for (const double friction : {0.0, 0.1}) {
    Scene scene = drop(0.5);
    scene.materials["rubber"].friction = friction;
    CHECK(taken(scene));
    Scene drifting = scene, spinning = scene;
    drifting.bodies.front().velocity = {{1e-9, 0, 0}};
    spinning.bodies.front().angular_velocity = {{0, 1e-9, 0}};
    CHECK(taken(drifting).has_value() == (friction == 0));
    CHECK(taken(spinning).has_value() == (friction == 0));
    drifting.material_pairs = {{{"rubber", "rubber"}, 0.5, 0.1 - friction}};
    CHECK(taken(drifting).has_value() == (friction != 0));
  }
}

TEST_CASE("Bounces: balls that may meet are refused", "[cost]") {
  Scene scene = drop(0.5);
  scene.bodies.push_back(ball_at({0.3, 0, 5}));
  CHECK(taken(scene, 0));
  CHECK(taken(scene, 1));
  const auto refused = [&](auto change) {
    Scene other = scene;
    change(other, other.bodies.back());
    return !taken(other, 0) && !taken(other, 1);
  };
  CHECK(refused([](Scene&, BodyGroup& b) { b.position = {{2 * radius, 0, 9}}; }));
  CHECK(refused([](Scene&, BodyGroup& b) { b.position = {{0.1, 0.1, 9}}; }));
  CHECK(!refused([](Scene&, BodyGroup& b) { b.position = {{0.2, 0.2, 1}}; }));
  CHECK(refused([](Scene&, BodyGroup& b) { b.radius = {0.175}; }));
  CHECK(refused([](Scene&, BodyGroup& b) { b.velocity = {{1, 0, 0}}; }));
  CHECK(refused([](Scene& s, BodyGroup&) { s.bodies.front().velocity = {{-1, 0, 0}}; }));
  scene.materials["rubber"].friction = 0.5;
  scene.bodies.back().angular_velocity = {{0, 1, 0}};  // will roll
  CHECK(!taken(scene, 0));
  scene.bodies.back().shape = "";  // a particle touches nothing
  CHECK(taken(scene, 0));
}

TEST_CASE("Bounces: the engine runs into them", "[cost]") {
  Scene scene = drop(0.8, 9.81, 2);
  scene.bodies.front().velocity = {{0.5, 0, 2}};
  scene.run = {.duration = 2, .step = 1e-4, .integrator = "velocity_verlet"};
  ballpark::World world(scene);
  const ExactMotion motion = motion_of(scene);
  for (int n = 1; n <= 20; ++n) {
    world.step(1000);
    const State s = state_at(motion, n * 0.1L);
    const ballpark::BodyState found = world.body(0);
    CHECK((found.position.cast<Real>() - s.x).norm() < 1e-3L);
    CHECK((found.velocity.cast<Real>() - s.v).norm() < 3e-3L);
  }
}

TEST_CASE("Bounces: the scenario has a closed form, a stack has none", "[cost]") {
  const auto found = [](const std::string& name) {
    const Scene scene = ballpark::scenes::load(std::string(BALLPARK_SCENARIOS_FOLDER) + "/" + name + ".toml").scene;
    return cost::closed_form(scene, cost::samples_of(5, 3, 20, 256), {});
  };
  const auto bounce = found("bounce");
  REQUIRE(bounce);
  CHECK(bounce->about.error_bar[0] < 1e-15);
  CHECK(bounce->about.error_bar[1] < 1e-14);
  const auto* end = &bounce->track.states[19 * 3];
  CHECK(end[0].position.z() > 0.2);
  CHECK(end[1].position == Vector3d(1, 0, 0.1));
  CHECK(end[2].position == Vector3d(2, 0, 0.1));
  CHECK(end[2].velocity == Vector3d(0, 0, 0));
  for (const char* name : {"stack", "newton_cradle", "incline"}) CHECK(!found(name));
}
