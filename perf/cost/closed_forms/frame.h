// What all closed forms share: vectors and rotations in either precision, uniform spin, and how a form becomes a
// motion.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "perf/cost/exact.h"

namespace ballpark::cost {

template <class R>
using Vector = Eigen::Matrix<R, 3, 1>;
template <class R>
using Rotation = Eigen::Quaternion<R>;  // body to world

/// Numbers of the scene are doubles: what should be zero, parallel or equal is so to their rounding. Geometry that is
/// off by more, relative, is another problem's.
inline constexpr double geometry_tolerance = 1e-14;

template <class R>
Rotation<R> start_orientation(const LoneBody& body) {
  const Quaternion& q = body.start.orientation;
  return Rotation<R>(R(q.w), R(q.x), R(q.y), R(q.z)).normalized();
}

/// The principal moments; zero for a particle.
template <class R>
Vector<R> moments(const LoneBody& body) {
  return body.inertia.value_or(Vector3d::Zero()).template cast<R>();
}

/// Turns by |turn| [rad] about its direction.
template <class R>
Rotation<R> rotation_by(const Vector<R>& turn) {
  const R angle = turn.norm();
  if (angle == 0) return Rotation<R>::Identity();
  const Vector<R> imaginary = (std::sin(angle / 2) / angle) * turn;
  return {std::cos(angle / 2), imaginary.x(), imaginary.y(), imaginary.z()};
}

template <class R>
ExactState<R> state_of(const Vector<R>& x, const Vector<R>& v, const Rotation<R>& q, const Vector<R>& w) {
  return {{x.x(), x.y(), x.z()}, {v.x(), v.y(), v.z()}, {q.w(), q.x(), q.y(), q.z()}, {w.x(), w.y(), w.z()}};
}

/// No torque and one moment of inertia, or no spin at all: the angular velocity stays.
inline bool spins_uniformly(const LoneBody& body) {
  const Vector3d i = body.inertia.value_or(Vector3d::Zero());
  return body.start.angular_velocity.isZero(0) || (i.x() == i.y() && i.y() == i.z());
}

template <class R>
class UniformSpin {
 public:
  explicit UniformSpin(const LoneBody& body)
      : turns_(body.start.has_orientation),
        start_(start_orientation<R>(body)),
        spin_(body.start.angular_velocity.cast<R>()) {}
  Rotation<R> orientation(R t) const { return turns_ ? rotation_by<R>(spin_ * t) * start_ : Rotation<R>::Identity(); }
  const Vector<R>& spin() const { return spin_; }

 private:
  bool turns_;
  Rotation<R> start_;
  Vector<R> spin_;
};

/// Form<R> is made of the body (and what it may touch), tells whether it fits (in this precision) and gives the state
/// at a time.
template <template <class> class Form, class Body>
std::optional<ExactMotion> motion_of(std::string what, const Body& body) {
  const Form<double> in_double(body);
  const Form<long double> in_extended(body);
  if (!in_double.fits() || !in_extended.fits()) return std::nullopt;
  return ExactMotion{std::move(what), [in_double](double t) { return in_double.at(t); },
                     [in_extended](long double t) { return in_extended.at(t); }};
}

}  // namespace ballpark::cost
