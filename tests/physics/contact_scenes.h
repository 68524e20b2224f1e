// Scenes of touching balls, in code.
#pragma once

#include "ballpark/ballpark.h"

namespace contact_scenes {

using ballpark::BodyGroup;
using ballpark::BodyState;
using ballpark::Boundary;
using ballpark::Effect;
using ballpark::Scene;
using ballpark::Vector3d;
using ballpark::World;

/// Balls of one kind, of restitution e and friction mu among themselves.
struct Law {
  double e = 1, mu = 0;
};

inline Scene touching_scene(double step, const Law& law, const std::string& integrator = "rk4") {
  Scene scene;
  scene.run.duration = 1;
  scene.run.step = step;
  scene.run.integrator = integrator;
  scene.contact.kind = "impulse";
  scene.materials["ball"] = {law.e, law.mu};
  return scene;
}

inline BodyGroup ball_group(const std::vector<Vector3d>& positions, const std::vector<Vector3d>& velocities = {},
                            double radius = 0.5, double mass = 1) {
  BodyGroup group;
  group.name = "balls";
  group.shape = "sphere";
  group.material = "ball";
  group.radius = {radius};
  group.mass = {mass};
  group.position = positions;
  group.velocity = velocities;
  return group;
}

inline Boundary plane(const Vector3d& point = {0, 0, 0}, const Vector3d& normal = {0, 0, 1}) {
  Boundary wall;
  wall.shape = "plane";
  wall.point = point;
  wall.normal = normal;
  wall.material = "ball";
  return wall;
}

inline Effect gravity(const Vector3d& g = {0, 0, -9.81}) {
  return {.kind = "gravity", .groups = {}, .parameters = {{"acceleration", g}}};
}

/// Largest component of a difference.
inline double off(const Vector3d& a, const Vector3d& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

}  // namespace contact_scenes
