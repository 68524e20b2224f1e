// Bodies on their own, and what tests of closed forms ask of a motion.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "perf/cost/exact.h"

namespace lone_bodies {

using ballpark::Effect;
using ballpark::Value;
using ballpark::Vector3d;
using ballpark::cost::ClosedForm;
using ballpark::cost::ExactMotion;
using ballpark::cost::ExactState;
using ballpark::cost::LoneBody;
using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;
using Rotation = Eigen::Quaternion<Real>;

struct Made {
  ballpark::BodyGroup group;
  std::vector<Effect> effects;
  ballpark::BodyState start;
  double mass = 1;
  std::optional<Vector3d> inertia;

  LoneBody lone() const {
    LoneBody body{group, 0, {}, start, mass, inertia};
    for (const Effect& effect : effects) body.effects.push_back(&effect);
    return body;
  }
  Made with(Effect effect) const {
    Made more = *this;
    more.effects.push_back(std::move(effect));
    return more;
  }
  Made turned(const Eigen::Quaterniond& q) const {
    Made more = *this;
    more.start.orientation = {q.w(), q.x(), q.y(), q.z()};
    more.start.has_orientation = more.start.has_angular_velocity = true;
    return more;
  }
};

inline Made particle(const Vector3d& position, const Vector3d& velocity, double mass = 1) {
  Made body;
  body.mass = mass;
  body.start.position = position;
  body.start.velocity = velocity;
  return body;
}

/// `spin` in the world frame.
inline Made rigid(const Vector3d& inertia, const Vector3d& spin, const Vector3d& position = Vector3d::Zero(),
                  const Vector3d& velocity = Vector3d::Zero(), double mass = 1) {
  Made body = particle(position, velocity, mass).turned(Eigen::Quaterniond::Identity());
  body.inertia = inertia;
  body.start.angular_velocity = spin;
  return body;
}

inline Effect effect(const std::string& kind, std::map<std::string, Value> parameters = {}) {
  return {kind, {}, std::move(parameters)};
}
inline Effect pivot(const Vector3d& point = Vector3d::Zero()) {
  return effect("pivot", {{"point", std::vector<Vector3d>{point}}});
}
inline Effect spring(double stiffness, double damping, const Vector3d& anchor = Vector3d::Zero()) {
  return effect("spring", {{"anchor", std::vector<Vector3d>{anchor}}, {"stiffness", stiffness}, {"damping", damping}});
}

/// Repeatable random numbers.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vector3d vector(double size) {
    const double x = number(-size, size), y = number(-size, size);
    return {x, y, number(-size, size)};
  }
  Eigen::Quaterniond rotation() {
    const double w = number(-1, 1);
    const Vector3d v = vector(1);
    return Eigen::Quaterniond(w, v.x(), v.y(), v.z()).normalized();
  }

 private:
  std::mt19937 engine_;
};

struct State {
  Vector x, v, w;
  Rotation q;
};

inline State state_at(const ExactMotion& motion, Real t) {
  const ExactState<Real> s = motion.in_extended(t);
  const auto vector = [](const std::array<Real, 3>& a) { return Vector(a[0], a[1], a[2]); };
  const auto& q = s.orientation;
  return {vector(s.position), vector(s.velocity), vector(s.angular_velocity), Rotation(q[0], q[1], q[2], q[3])};
}

/// d/dt of f at t by central differences of sixth order.
template <class F>
auto rate_of(const F& f, Real t, Real h) {
  using Result = std::decay_t<decltype(f(t))>;
  const Result one = f(t + h) - f(t - h), two = f(t + 2 * h) - f(t - 2 * h), three = f(t + 3 * h) - f(t - 3 * h);
  return Result((45 * one - 9 * two + three) / (60 * h));
}

/// How far q' is from w q/2, either sign of q being the same rotation. [rad/s]
inline Real turning_error(const ExactMotion& motion, Real t, Real h) {
  using Four = Eigen::Matrix<Real, 4, 1>;
  const State now = state_at(motion, t);
  const auto coefficients = [&](Real at) -> Four {
    const Four q = state_at(motion, at).q.coeffs();
    return q.dot(now.q.coeffs()) < 0 ? Four(-q) : q;
  };
  const Rotation spin(0, now.w.x(), now.w.y(), now.w.z());
  return (2 * rate_of(coefficients, t, h) - (spin * now.q).coeffs()).norm();
}

/// Largest difference between the two precisions at a time, each quantity over 1 + its own size.
inline Real rounding_of(const ExactMotion& motion, double t) {
  const ExactState<double> a = motion.in_double(t);
  const ExactState<Real> b = motion.in_extended(t);
  const auto apart = [](const auto& few, const auto& many) {
    Real difference = 0, opposite = 0, size = 1;
    for (std::size_t i = 0; i < few.size(); ++i) {
      difference = std::max(difference, std::abs(few[i] - many[i]));
      opposite = std::max(opposite, std::abs(few[i] + many[i]));
      size = std::max(size, std::abs(many[i]));
    }
    return std::pair<Real, Real>(difference / size, opposite / size);
  };
  const auto turned = apart(a.orientation, b.orientation);
  return std::max({apart(a.position, b.position).first, apart(a.velocity, b.velocity).first,
                   apart(a.angular_velocity, b.angular_velocity).first, std::min(turned.first, turned.second)});
}

}  // namespace lone_bodies
