// A body on its way, and what an effect's functions must be to each other there.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "engine/effects/local_effects.h"
#include "tests/catch.h"

namespace effect_checks {

using namespace ballpark::BALLPARK_PRECISION;
using ballpark::Value;
using ballpark::Vector3d;
using Vector = Vector3<Real>;

inline const Body<Real> body{0, 2.5, {0.3, -0.7, 1.1}, {1.5, 0.25, -2}, {3, -1, 0.5}};
inline const Acceleration<Real> bend{{0.4, 2, -0.3}, {-0.6, 0.1, 1.3}};

/// The effect's constants from parameters, as build packs them; per-body vectors as one value, radius 0.2 m.
template <class E>
typename E::Constants packed(const std::map<std::string, Value>& parameters) {
  const auto per_body = [](const std::string&, const std::vector<Vector3d>& rows) {
    return std::array<PerBody, 3>{PerBody{nullptr, rows[0].x()}, {nullptr, rows[0].y()}, {nullptr, rows[0].z()}};
  };
  return E::pack(EffectInput{parameters, 3.0, per_body, body.mass, {nullptr, 0.2}});
}

template <class E>
Loads<Real> loads(const typename E::Constants& c, const Body<Real>& b) {
  Loads<Real> sum;
  E::force(c, b, sum);
  return sum;
}

inline bool near(const Vector& a, const Vector& b, double tolerance) {
  const Vector d = a - b;
  return std::sqrt(dot(d, d)) <= tolerance * (1 + std::sqrt(dot(b, b)));
}

/// The body a time t later, on the path that it is on.
inline Body<Real> later(double t) {
  Body<Real> b = body;
  b.position += t * body.velocity + t * t / 2 * bend.linear;
  b.velocity += t * bend.linear;
  b.spin += t * bend.angular;
  return b;
}

template <class E>
void check_force_rate(const typename E::Constants& c) {
  Loads<Real> rate;
  E::force_rate(c, body, bend, rate);
  const double t = 1e-5;
  const Loads<Real> after = loads<E>(c, later(t)), before = loads<E>(c, later(-t));
  CHECK(near(rate.force, (1 / (2 * t)) * (after.force - before.force), 1e-8));
  CHECK(near(rate.torque, (1 / (2 * t)) * (after.torque - before.torque), 1e-8));
}

/// F = -grad E. Forces that read velocity are taken at rest.
template <class E>
void check_energy(const typename E::Constants& c) {
  Body<Real> still = body;
  still.velocity = {};
  const double t = 1e-5;
  const auto slope = [&](Vector along) {
    Body<Real> ahead = still, behind = still;
    ahead.position += t * along;
    behind.position -= t * along;
    return (E::energy(c, ahead) - E::energy(c, behind)) / (2 * t);
  };
  CHECK(near(loads<E>(c, still).force, {-slope({1, 0, 0}), -slope({0, 1, 0}), -slope({0, 0, 1})}, 1e-8));
}

}  // namespace effect_checks
