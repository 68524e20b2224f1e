// Scenes of a body or two, built in a line each.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ballpark/ballpark.h"

namespace ballpark::tests {

inline constexpr double pi = 3.14159265358979323846;

inline BodyGroup particle(const Vector3d& position, const Vector3d& velocity = Vector3d::Zero()) {
  BodyGroup group;
  group.name = "particle";
  group.mass = {1.0};
  group.position = {position};
  group.velocity = {velocity};
  return group;
}

/// A body with principal moments, turning with `spin` in its own frame.
inline BodyGroup rigid_body(const Vector3d& inertia, const Vector3d& spin, const Quaternion& orientation = {}) {
  BodyGroup group = particle(Vector3d::Zero());
  group.name = "rigid body";
  group.inertia = {inertia};
  group.angular_velocity = {spin};
  group.angular_velocity_frame = "body";
  group.orientation = {orientation};
  return group;
}

/// A solid ball of 1 kg and 1 m: one moment of inertia, 0.4 kg m^2.
inline BodyGroup ball() {
  BodyGroup group = particle(Vector3d::Zero());
  group.name = "ball";
  group.shape = "sphere";
  group.radius = {1.0};
  return group;
}

inline Effect gravity(double g = 9.81) {
  return {"gravity", {}, {{"acceleration", Vector3d(0, 0, -g)}}};
}
inline Effect pivot() {
  return {"pivot", {}, {{"point", Vector3d(0, 0, 0)}}};
}
inline Effect spring(double stiffness, double damping = 0) {
  return {"spring", {}, {{"anchor", Vector3d(0, 0, 0)}, {"stiffness", stiffness}, {"damping", damping}}};
}
inline Effect magnetic_field(double charge, const Vector3d& field) {
  return {"magnetic_field", {}, {{"charge", charge}, {"field", field}}};
}
inline Effect rotating_frame(const Vector3d& rate, const std::string& centrifugal) {
  return {"rotating_frame", {}, {{"angular_velocity", rate}, {"centrifugal", centrifugal}}};
}
inline Effect attraction() {
  return {"central_gravity", {}, {{"strength", 1.0}}};
}
inline Effect effect(const std::string& kind, double coefficient) {
  return {kind, {}, {{"coefficient", coefficient}}};
}

inline Scene scene(BodyGroup group, std::vector<Effect> effects, double duration, double step,
                   const std::string& integrator = "rk4") {
  Scene made;
  made.name = "test";
  made.run.duration = duration;
  made.run.step = step;
  made.run.integrator = integrator;
  made.bodies = {std::move(group)};
  made.effects = std::move(effects);
  return made;
}

inline std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for (const IntegratorDescription& row : integrators()) names.push_back(row.name);
  return names;
}

/// A point mass on a rod of 1 m in the plane y = 0, at rest at an angle from straight down [rad].
inline Scene pendulum(double angle, double duration, double step, const std::string& integrator = "rk4") {
  return scene(particle({std::sin(angle), 0, -std::cos(angle)}), {gravity(), pivot()}, duration, step, integrator);
}

/// The unit orbit (GM = 1, a = 1) from its pericentre.
inline Scene orbit(double eccentricity, double duration, double step, const std::string& integrator = "rk4") {
  const double e = eccentricity;
  return scene(particle({1 - e, 0, 0}, {0, std::sqrt((1 + e) / (1 - e)), 0}), {attraction()}, duration, step,
               integrator);
}

/// Problem P-R3: a symmetric top about its tip, moments about the tip 0.02, 0.02, 0.005, m g l = 0.981, leaning by
/// `lean` [rad] about x, turning with `spin` in its own frame.
inline Scene top(double lean, const Vector3d& spin, double duration, double step) {
  constexpr double length = 0.1;  // from the tip to the centre of mass
  BodyGroup group = rigid_body({0.02 - length * length, 0.02 - length * length, 0.005}, spin,
                               {std::cos(lean / 2), std::sin(lean / 2), 0, 0});
  group.position = {{0, -length * std::sin(lean), length * std::cos(lean)}};
  return scene(std::move(group), {gravity(), pivot()}, duration, step);
}

}  // namespace ballpark::tests
