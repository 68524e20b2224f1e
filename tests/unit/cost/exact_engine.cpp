// Closed forms mean the scene that the engine runs: its own state at the start, frames, signs and conventions.
#include "ballpark/ballpark.h"
#include "tests/catch.h"
#include "tests/unit/cost/lone_bodies.h"

using namespace lone_bodies;

namespace {

/// The world's body against the closed form that starts from it, after a while of fine steps.
void check_run(ballpark::BodyGroup group, const std::vector<Effect>& effects, std::optional<Vector3d> inertia) {
  ballpark::Scene scene;
  group.name = "body";
  group.mass = {1.5};
  scene.bodies = {group};
  scene.effects = effects;
  scene.run = {.duration = 1, .step = 5e-4, .integrator = "rk4"};
  ballpark::World world(scene);
  LoneBody body{scene.bodies.front(), 0, {}, world.body(0), 1.5, inertia};
  for (const Effect& effect : scene.effects) body.effects.push_back(&effect);
  const auto motion = ballpark::cost::exact_motion(body);
  REQUIRE(motion);
  INFO(motion->what);
  world.step(2000);
  const ballpark::BodyState end = world.body(0);
  const State exact = state_at(*motion, 1);
  CHECK((end.position.cast<Real>() - exact.x).norm() < 1e-9L);
  CHECK((end.velocity.cast<Real>() - exact.v).norm() < 1e-8L);
  CHECK((end.angular_velocity.cast<Real>() - exact.w).norm() < 1e-8L);
  const auto& q = end.orientation;
  CHECK(1 - std::abs(exact.q.dot(Rotation(q.w, q.x, q.y, q.z))) < 1e-15L);
}

}  // namespace

TEST_CASE("Closed forms: the engine runs into them", "[cost]") {
  const ballpark::BodyGroup thrown{.position = {{1, 0.2, 0.3}}, .velocity = {{0.5, 2, -0.4}}};
  const Effect drag = effect("linear_drag", {{"coefficient", 0.7}});
  const Effect air = effect("quadratic_drag", {{"coefficient", 0.4}});
  const Effect sun = effect("central_gravity", {{"strength", 3.0}});
  const Effect lift = effect("magnus", {{"coefficient", 0.9}}), pull = effect("gravity");
  check_run(thrown, {drag, pull}, {});
  check_run({.position = {{0, 0, 0}}, .velocity = {{0, 0, 6}}}, {air, pull}, {});
  check_run(thrown, {spring(20, 0.6, {0, 1, 0}), drag, pull}, {});
  const Effect trap = effect("harmonic_trap", {{"centre", Vector3d(0.5, 0, 1)}, {"stiffness", Vector3d(20, 9, 0.2)}});
  check_run(thrown, {trap, drag, pull}, {});
  check_run(thrown, {trap, spring(2, 0.3, {0, 1, 0}), pull}, {});
  check_run(thrown, {sun}, {});
  const Effect electric = effect("electric_field", {{"charge", -0.7}, {"field", Vector3d(1, 2, -3)}});
  const Effect magnetic = effect("magnetic_field", {{"charge", 1.7}, {"field", Vector3d(2, -1, 1.5)}});
  const Effect frame =
      effect("rotating_frame", {{"angular_velocity", Vector3d(0.3, -0.4, 1.1)}, {"centrifugal", std::string("off")}});
  check_run(thrown, {electric, magnetic, pull}, {});
  check_run(thrown, {spring(20, 0, {0, 1, 0}), electric, magnetic, frame, pull}, {});

  ballpark::BodyGroup ball = thrown;
  ball.inertia = {{0.4, 0.4, 0.4}};
  ball.angular_velocity = {{1, -2, 3}};
  ball.orientation = {{0.8, 0, 0.6, 0}};
  check_run(ball, {lift, pull}, ball.inertia.front());
  ball.inertia = {{0.4, 0.5, 0.7}};
  ball.angular_velocity_frame = "body";
  check_run(ball, {pull}, ball.inertia.front());

  const ballpark::BodyGroup bob{.position = {{0.6, 0, 0.8}},
                                .velocity = {{-0.8, 0, 0.6}}};  // no spin: from the velocity
  check_run(bob, {pull, pivot()}, {});
  ballpark::BodyGroup sideways = bob;
  sideways.velocity = {{0.4, 2, -0.3}};
  check_run(sideways, {pull, pivot()}, {});
  ballpark::BodyGroup top{.inertia = {{0.5, 0.2, 0.5}}, .position = {{0, -0.7, 0}}, .angular_velocity = {{1, 9, -0.5}}};
  check_run(top, {pull, pivot()}, top.inertia.front());
}
