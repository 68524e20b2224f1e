// Small scenes in code, and what tests ask of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ballpark/ballpark.h"
#include "ballpark/catalogue.h"

namespace made_scenes {

using ballpark::BodyGroup;
using ballpark::Effect;
using ballpark::Options;
using ballpark::Problem;
using ballpark::Scene;
using ballpark::UserEffect;
using ballpark::Value;
using ballpark::Vector3d;

/// Bodies that all start elsewhere and otherwise: particles of 2 kg.
inline BodyGroup particles(const std::string& name, std::size_t count) {
  BodyGroup group;
  group.name = name;
  group.mass = {2};
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i);
    group.position.push_back({1 + 0.5 * x, 0.3 - 0.25 * x, 2 + 0.125 * x});
    group.velocity.push_back({0.7 - 0.01 * x, 0.02 * x, 0.3});
  }
  return group;
}

/// The same as balls of 0.1 m: no spin, no orientation.
inline BodyGroup balls(const std::string& name, std::size_t count) {
  BodyGroup group = particles(name, count);
  group.shape = "sphere";
  group.radius = {0.1};
  return group;
}

/// The same, each with a spin of its own.
inline BodyGroup spinning(BodyGroup group) {
  for (std::size_t i = 0; i < group.position.size(); ++i) {
    const double x = static_cast<double>(i);
    group.angular_velocity.push_back({1 + 0.1 * x, -2, 0.5 - 0.2 * x});
  }
  return group;
}

/// Tumbling bodies with three moments of inertia.
inline BodyGroup bricks(const std::string& name, std::size_t count) {
  BodyGroup group = spinning(particles(name, count));
  group.inertia = {{0.1, 0.2, 0.25}};
  return group;
}

/// Of one moment of inertia.
inline BodyGroup round_bricks(const std::string& name, std::size_t count) {
  BodyGroup group = bricks(name, count);
  group.inertia = {{0.2, 0.2, 0.2}};
  return group;
}

/// The same with a radius, as fluids ask for.
inline BodyGroup sized(BodyGroup group) {
  group.radius = {0.1};
  return group;
}

inline Effect effect(const std::string& kind, std::map<std::string, Value> parameters = {},
                     std::vector<std::string> groups = {}) {
  return {.kind = kind, .groups = std::move(groups), .parameters = std::move(parameters)};
}

/// Something that a parameter of this kind may be, for scenes of two bodies or more.
inline Value any_value(ballpark::ParameterKind kind) {
  using ballpark::ParameterKind;
  if (kind == ParameterKind::number || kind == ParameterKind::numbers) return 0.3;
  if (kind == ParameterKind::pairs) return std::vector<ballpark::IdPair>{{0, 1}};
  return Vector3d(0.4, -0.2, 5);
}

/// An instance of any effect of the catalogue: what has no default gets a value, by which it reaches its neighbours.
inline Effect sample(const ballpark::EffectDescription& description) {
  Effect made = effect(description.name);
  for (const ballpark::ParameterInfo& parameter : description.parameters) {
    if (parameter.fallback) continue;
    made.parameters[parameter.name] = parameter.name == "cutoff"  ? Value(3.0)
                                      : parameter.name == "size"  ? Value(Vector3d(0.01, 0.02, 0.03))
                                      : parameter.name == "every" ? Value(1.0)
                                                                  : any_value(parameter.kind);
  }
  return made;
}

/// A user's force in double, on all groups.
template <class Run>
UserEffect user_effect(const std::string& name, Run run) {
  UserEffect made;
  made.name = name;
  made.run_double = run;
  return made;
}

inline Scene scene_of(std::vector<BodyGroup> bodies, std::vector<Effect> effects = {}) {
  Scene scene;
  scene.name = "made";
  scene.run.duration = 1;
  scene.run.step = 1.0 / 128;
  scene.bodies = std::move(bodies);
  scene.effects = std::move(effects);
  return scene;
}

/// Problems that World's constructor finds; none if it accepts the scene.
inline std::vector<Problem> problems_of(const Scene& scene, const Options& options = {},
                                        std::vector<UserEffect> users = {}) {
  try {
    ballpark::World world(scene, options, std::move(users));
  } catch (const ballpark::SceneError& error) {
    return error.problems();
  }
  return {};
}

/// The problem of a call that throws SceneError; nothing else may come out of it. An empty path: it did not throw.
template <class Call>
Problem refusal(Call call) {
  try {
    call();
  } catch (const ballpark::SceneError& error) {
    return error.problems().at(0);
  }
  return {};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
inline bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

inline bool close(double a, double b, double tolerance = 1e-12) {
  return std::abs(a - b) <= tolerance * std::max({1.0, std::abs(a), std::abs(b)});
}
inline bool close(const Vector3d& a, const Vector3d& b, double tolerance = 1e-12) {
  return close(a.x(), b.x(), tolerance) && close(a.y(), b.y(), tolerance) && close(a.z(), b.z(), tolerance);
}

}  // namespace made_scenes
