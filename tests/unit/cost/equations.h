// Whether a motion solves its equations: residuals by differences in extended precision.
#pragma once

#include "tests/catch.h"
#include "tests/unit/cost/lone_bodies.h"

namespace equations {

using namespace lone_bodies;
namespace cost = ballpark::cost;

inline Vector wide(const Vector3d& a) {
  return a.cast<Real>();
}

/// Formulas of the effects, as their descriptions have them.
inline Vector force(const Made& body, const State& s) {
  Vector total = Vector::Zero();
  for (const Effect& e : body.effects) {
    const auto number = [&](const char* name) { return Real(cost::number(e, name)); };
    if (e.kind == "gravity") total += Real(body.mass) * wide(cost::vector(e, "acceleration"));
    if (e.kind == "linear_drag") total -= number("coefficient") * s.v;
    if (e.kind == "quadratic_drag") total -= number("coefficient") * s.v.norm() * s.v;
    if (e.kind == "spring")
      total -= number("stiffness") * (s.x - wide(cost::vector(e, "anchor"))) + number("damping") * s.v;
    if (e.kind == "harmonic_trap") {
      const Vector r = s.x - wide(cost::vector(e, "centre"));
      total -= wide(cost::vector(e, "stiffness")).cwiseProduct(r);
    }
    if (e.kind == "central_gravity") {
      const Vector r = s.x - wide(cost::vector(e, "centre"));
      total -= Real(body.mass) * number("strength") / (r.squaredNorm() * r.norm()) * r;
    }
    if (e.kind == "electric_field") total += number("charge") * wide(cost::vector(e, "field"));
    if (e.kind == "magnetic_field") total += number("charge") * s.v.cross(wide(cost::vector(e, "field")));
    if (e.kind == "rotating_frame")  // the Coriolis force alone
      total -= 2 * Real(body.mass) * wide(cost::vector(e, "angular_velocity")).cross(s.v);
    if (e.kind == "magnus") total += number("coefficient") * s.w.cross(s.v);
  }
  return total;
}

inline void check_small(Real residual, Real scale, const char* what, Real t) {
  INFO(what << " at " << t << ": off by " << residual << " of " << scale);
  CHECK(residual <= 1e-9L * scale);
}

inline Vector momentum(const Made& body, const State& s) {
  const Vector own = s.q.conjugate() * s.w;
  return s.q * Vector(wide(body.inertia.value_or(Vector3d::Zero())).cwiseProduct(own));
}

/// x' = v, m v' = F, q' = w q/2, L' = 0.
inline void check_free(const Made& body, const ExactMotion& motion, Real t, Real h) {
  const State s = state_at(motion, t);
  const Vector v = rate_of([&](Real at) { return state_at(motion, at).x; }, t, h);
  const Vector a = rate_of([&](Real at) { return state_at(motion, at).v; }, t, h);
  const Vector torque = rate_of([&](Real at) { return momentum(body, state_at(motion, at)); }, t, h);
  const Vector expected = force(body, s) / Real(body.mass);
  check_small((v - s.v).norm(), 1 + s.v.norm(), "x' - v", t);
  check_small((a - expected).norm(), 1 + expected.norm(), "v' - F/m", t);
  check_small(torque.norm(), 1 + momentum(body, s).norm(), "L'", t);
  if (body.start.has_orientation) check_small(turning_error(motion, t, h), 1 + s.w.norm(), "q' - w q/2", t);
}

/// About the pivot at the origin: x = R R0^T x0, v = w x x, q' = w q/2, L' = x cross m g.
inline void check_pivoted(const Made& body, const ExactMotion& motion, Real t, Real h) {
  const State s = state_at(motion, t), start = state_at(motion, 0);
  const Vector arm = s.q * (start.q.conjugate() * start.x);
  check_small((s.x - arm).norm(), 1e-6L, "x - R a", t);
  check_small((s.v - s.w.cross(s.x)).norm(), 1e-6L * (1 + s.v.norm()), "v - w x a", t);
  check_small(turning_error(motion, t, h), 1 + s.w.norm(), "q' - w q/2", t);
  const auto about_pivot = [&](Real at) -> Vector {
    const State n = state_at(motion, at);
    return momentum(body, n) + Real(body.mass) * n.x.cross(n.v);
  };
  const Vector torque = s.x.cross(force(body, s)), rate = rate_of(about_pivot, t, h);
  check_small((rate - torque).norm(), torque.norm() + 1e-3L * s.w.norm() * about_pivot(t).norm(), "L' - x x F", t);
  if (!body.inertia) check_small(std::abs(s.w.dot(s.x)), 1e-6L, "spin about the arm of a point mass", t);
}

inline void check_start(const Made& body, const ExactMotion& motion) {
  const State s = state_at(motion, 0);
  const auto& q = body.start.orientation;
  check_small((s.x - wide(body.start.position)).norm(), 1e-8L * (1 + s.x.norm()), "x0", 0);
  check_small((s.v - wide(body.start.velocity)).norm(), 1e-5L * (1 + s.v.norm()), "v0", 0);
  check_small((s.w - wide(body.start.angular_velocity)).norm(), 1e-5L * (1 + s.w.norm()), "w0", 0);
  check_small(1 - std::abs(s.q.dot(Rotation(q.w, q.x, q.y, q.z))), 1e-6L, "q0", 0);
}

using Check = void(const Made&, const ExactMotion&, Real, Real);

/// `h` is small against the motion's own times. The form must be the one that is found for the body.
inline void check_motion(ClosedForm& form, Check& equations, const Made& body, Dice& dice, double duration,
                         Real h = 1e-3L) {
  const auto motion = form(body.lone()), found = cost::exact_motion(body.lone());
  REQUIRE(motion);
  REQUIRE(found);
  CHECK(motion->what == found->what);
  check_start(body, *motion);
  for (int i = 0; i < 4; ++i) {
    const double t = dice.number(0.01, duration);
    equations(body, *motion, t, h);
    const Real rounding = rounding_of(*motion, t);
    INFO("double against extended at " << t << ": " << rounding);
    CHECK(rounding < 1e-12L);
  }
}

inline Effect random_gravity(Dice& dice) {
  return effect("gravity", {{"acceleration", dice.vector(10)}});
}

}  // namespace equations
