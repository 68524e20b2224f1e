// Impulses at a time, and forces and torques for a while: from the scene, and through the library's calls.
#include <Eigen/Geometry>

#include "tests/catch.h"
#include "tests/methods/rows.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

constexpr double kick_time = 0.7654321;  // inside a step, whatever its length here

/// x'' = -x from x = 1 at rest, with a kick of J at t1: the sum of two oscillations.
long double kicked_oscillator_error(const World& world, long double J, long double t1) {
  const long double t = 2, since = t - t1;
  const Numbers exact = {std::cos(t) + J * std::sin(since), -std::sin(t) + J * std::cos(since)};
  return largest_difference({position(world)[0], velocity(world)[0]}, exact);
}

/// x'' = -x + F between `at` and `until`.
long double pushed_oscillator_error(const World& world, long double F, long double at, long double until) {
  const long double t = 2, a = t - at, b = t - until;
  const Numbers exact = {std::cos(t) + F * (std::cos(b) - std::cos(a)), -std::sin(t) + F * (std::sin(a) - std::sin(b))};
  return largest_difference({position(world)[0], velocity(world)[0]}, exact);
}

BodyGroup turning_ball() {
  BodyGroup group = ball();
  group.orientation = {Quaternion{}};
  group.angular_velocity = {Vector3d::Zero()};
  return group;
}

/// Turned by `angle` about y.
bool has_turned(const World& world, double angle) {
  const Quaternion q = world.body(0).orientation;
  return std::abs(std::abs(q.w * std::cos(angle / 2) + q.y * std::sin(angle / 2)) - 1) < 1e-12;
}

}  // namespace

TEST_CASE("an impulse inside a step leaves every row its order", "[physics]") {
  for (const IntegratorDescription& row : integrators()) {
    Scene made = scene(particle({1, 0, 0}), {spring(1)}, 2, 1, row.name);
    made.impulses = {{kick_time, 0, {0.5, 0, 0}, Vector3d::Zero()}};
    const std::uint64_t n = row.order == 10                        ? 1
                            : row.order == 8                       ? 4
                            : row.start_steps > 0 && row.order > 2 ? 200
                            : row.order >= 5                       ? 20
                            : row.order >= 3                       ? 100
                                                                   : 2000;
    const Refinement refinement =
        refine(made, n, [](const World& world) { return kicked_oscillator_error(world, 0.5L, kick_time); });
    INFO(row.name << ": " << refinement.errors[2] << ", " << refinement.errors[3]);
    const long double margin = row.order == 10 ? 1 : 0.15L;  // too near to rounding to show more
    CHECK(std::abs(refinement.slope(1) - row.order) < margin);
    CHECK(std::abs(refinement.slope(2) - row.order) < margin);
  }
}

TEST_CASE("a force for a while, from inside one step to inside another, leaves rk4 its order", "[physics]") {
  Scene made = scene(particle({1, 0, 0}), {spring(1)}, 2, 1);
  made.effects.push_back({"force", {}, {{"force", Vector3d(0.5, 0, 0)}, {"at", kick_time}, {"until", 1.2345678}}});
  const Refinement refinement =
      refine(made, 100, [](const World& world) { return pushed_oscillator_error(world, 0.5L, kick_time, 1.2345678L); });
  INFO(refinement.errors[2] << ", " << refinement.errors[3]);
  CHECK(refinement.errors[0] < 1e-8L);
  CHECK(std::abs(refinement.slope(1) - 4) < 0.15L);
  CHECK(std::abs(refinement.slope(2) - 4) < 0.15L);
}

TEST_CASE("impulses at the start, on a step, at one time, and of the library's calls all count once", "[physics]") {
  for (const double at : {0.0, 0.5, 0.5 + 1e-14, 0.7, 0.9}) {
    INFO("at " << at << " s");
    Scene made = scene(particle(Vector3d::Zero()), {}, 1, 0.125);
    made.impulses = {{at, 0, {1, 0, 0}, Vector3d::Zero()}, {at, 0, {0, 3, 0}, Vector3d::Zero()}};
    World world(made);
    world.apply_impulse_at(at, 0, {0, 0, 2});
    world.step(8);
    CHECK((world.body(0).velocity - Vector3d(1, 3, 2)).norm() < 1e-15);
    CHECK((world.body(0).position - (1 - at) * Vector3d(1, 3, 2)).norm() < 1e-13);
    CHECK(world.time() == 1);
  }
}

TEST_CASE("an off-centre impulse spins a ball: v = J / m, w = (offset x J) / I", "[physics]") {
  const Vector3d J(0, 0, 2), offset(0.5, -0.25, 0);
  const Vector3d spin = offset.cross(J) / 0.4;
  Scene made = scene(ball(), {}, 1, 0.125);
  made.impulses = {{0.3, 0, J, offset}};
  World world(made);
  world.step(8);
  CHECK((world.body(0).velocity - J).norm() < 1e-15);
  CHECK((world.body(0).angular_velocity - spin).norm() < 1e-14);
  CHECK((world.body(0).position - 0.7 * J).norm() < 1e-14);
  world.apply_impulse(0, J, offset);
  CHECK((world.body(0).velocity - 2 * J).norm() < 1e-15);
  CHECK((world.body(0).angular_velocity - 2 * spin).norm() < 1e-14);
}

TEST_CASE("an off-centre impulse turns whatever carries an orientation", "[physics]") {
  const Vector3d J(0, 0, 0.4), offset(1, 0, 0);  // -1 rad/s about y for a ball
  BodyGroup still = ball();
  still.orientation = {Quaternion{}};
  BodyGroup body = still;
  body.shape = "";
  body.radius = {};
  body.inertia = {{0.3, 0.4, 0.5}};
  for (const BodyGroup& group : {turning_ball(), still, body}) {
    World world(scene(group, {}, 2, 1e-3));
    world.apply_impulse(0, J, offset);
    world.step(1000);
    CHECK((world.body(0).angular_velocity - Vector3d(0, -1, 0)).norm() < 1e-12);
    CHECK(has_turned(world, -1));
    world.apply_impulse_at(1.5, 0, -J, offset);
    world.step(1000);
    CHECK(world.body(0).angular_velocity.norm() < 1e-12);
    CHECK(has_turned(world, -1.5));
  }
}

TEST_CASE("an impulse on a pivoted body changes its angular momentum by its moment about the pivot", "[physics]") {
  World world(scene(particle({0, 0, -2}), {pivot()}, 1, 1e-3));
  world.apply_impulse(0, {3, 0, 5});  // what pulls along the rod changes nothing
  CHECK((world.body(0).velocity - Vector3d(3, 0, 0)).norm() < 1e-15);
  world.step(1000);
  CHECK(std::abs(world.body(0).velocity.norm() - 3) < 1e-12);
  CHECK((world.body(0).position - 2 * Vector3d(std::sin(1.5), 0, -std::cos(1.5))).norm() < 1e-11);
}

TEST_CASE("apply_force acts on one body for its time alone", "[physics]") {
  BodyGroup group = particle(Vector3d::Zero());
  group.mass = {2.0};
  group.position = {{0, 0, 0}, {5, 0, 0}, {9, 0, 0}};
  World world(scene(group, {}, 2, 0.125));
  world.apply_force(1, {4, 0, 0}, 0.3, 1.1);
  world.step(16);
  CHECK(world.body(0).position == Vector3d(0, 0, 0));
  CHECK(world.body(2).position == Vector3d(9, 0, 0));
  CHECK((world.body(1).velocity - Vector3d(1.6, 0, 0)).norm() < 1e-14);
  CHECK((world.body(1).position - Vector3d(5 + 0.64 + 1.6 * 0.9, 0, 0)).norm() < 1e-13);
}

TEST_CASE("apply_torque turns one body for its time alone", "[physics]") {
  BodyGroup group = turning_ball();
  group.position = {{0, 0, 0}, {5, 0, 0}};
  World world(scene(group, {}, 2, 1e-3));
  world.apply_torque(0, {0, 0.8, 0}, 0.25, 0.75);
  world.step(2000);
  CHECK((world.body(0).angular_velocity - Vector3d(0, 1, 0)).norm() < 1e-12);
  CHECK(has_turned(world, 0.25 + 1.25));
  CHECK(world.body(1).angular_velocity.norm() == 0);
}

TEST_CASE("loads of a scene add up: force with an offset is a force and a torque", "[physics]") {
  Scene made = scene(turning_ball(), {}, 1, 1e-3);
  made.effects = {{"force", {}, {{"force", Vector3d(0, 0, 0.4)}, {"offset", Vector3d(1, 0, 0)}}},
                  {"torque", {}, {{"torque", Vector3d(0, 0.8, 0)}}},
                  gravity(1)};
  World world(made);
  world.step(1000);
  CHECK((world.body(0).velocity - Vector3d(0, 0, -0.6)).norm() < 1e-12);
  CHECK((world.body(0).angular_velocity - Vector3d(0, 1, 0)).norm() < 1e-12);
  CHECK(has_turned(world, 0.5));
}

TEST_CASE("set places a body, and it moves on from there", "[physics]") {
  World world(scene(turning_ball(), {gravity(2)}, 2, 0.125));
  world.step(3);
  BodyState state = world.body(0);
  state.position = {1, 2, 3};
  state.velocity = {4, 0, 1};
  state.orientation = {std::sqrt(0.5), 0, std::sqrt(0.5), 0};
  state.angular_velocity = {0, 2, 0};
  world.set(0, state);
  CHECK(world.body(0).position == state.position);
  CHECK((world.body(0).angular_velocity - state.angular_velocity).norm() < 1e-15);
  world.step(8);
  CHECK((world.body(0).position - Vector3d(5, 2, 3)).norm() < 1e-14);
  CHECK((world.body(0).velocity - Vector3d(4, 0, -1)).norm() < 1e-14);
  CHECK((world.body(0).angular_velocity - Vector3d(0, 2, 0)).norm() < 1e-14);
}

TEST_CASE("set turns a body that stood still until now", "[physics]") {
  BodyGroup still = ball();
  still.orientation = {Quaternion{}};
  World world(scene(still, {}, 2, 1e-3));
  BodyState state = world.body(0);
  state.has_angular_velocity = true;
  state.angular_velocity = {0, 1.5, 0};
  world.set(0, state);
  world.step(1000);
  CHECK(has_turned(world, 1.5));
}
