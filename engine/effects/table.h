// A flat table under balls of one moment of inertia each: it carries what presses them on it, and its cloth slows them.
// With n its normal, N the force on it, s its surface's velocity, a ball slips at u = v - s - R w x n.
#pragma once

#include "engine/effects/effect_info.h"

#ifndef BALLPARK_TARGET
#include <algorithm>
#include <cmath>
#include <limits>
#endif

namespace ballpark::BALLPARK_PRECISION {

struct TableConstants {
  PerBody radius, inverse_inertia;
  Vector3<Real> normal, centre, turning;  ///< turning: its angular velocity
  Real sliding, rolling, spinning, rate;  ///< rate: 1 / settling
};

template <class V>
BALLPARK_INLINE static Vector3<V> table_lanes(const Vector3<Real>& a) {
  return {V(a.x), V(a.y), V(a.z)};
}

/// Of what slows at `rate`, never by more than `most`: the factor k <= rate with k |what| <= most.
template <class V>
BALLPARK_INLINE static V capped(const V& rate, const V& most, const V& size) {
  return select(rate * size > most, most / size, rate);
}

/// Called, so that effects beside it keep their registers.
template <class V>
[[gnu::noinline]] static void add_table_loads(const TableConstants& c, const Body<V>& body, Loads<V>& loads) {
  const V zero = V(Real(0)), one = V(Real(1)), rate = V(c.rate), r = c.radius.at<V>(body.row);
  const V inverse_inertia = c.inverse_inertia.at<V>(body.row), inertia = one / inverse_inertia;
  const Vector3<V> n = table_lanes<V>(c.normal), turning = table_lanes<V>(c.turning);
  const V pressing = -dot(loads.force, n), normal = select(pressing > zero, pressing, zero);
  loads.force += normal * n;

  const Vector3<V> surface = cross(turning, body.position - table_lanes<V>(c.centre));
  const Vector3<V> along = body.velocity - dot(body.velocity, n) * n;
  const Vector3<V> slip = along - surface - r * cross(body.spin, n);
  const V grip = V(c.sliding) * normal, responding = body.mass / (one + body.mass * r * r * inverse_inertia);
  const V holding = responding * rate * length(slip);  // more than the grip: it slides
  const V rolls = select(grip > holding, one - holding / grip, zero);

  const V about_contact = inertia + body.mass * r * r;
  const V spin_up = dot(body.spin, n);
  const Vector3<V> rolling = body.spin - spin_up * n, spinning = (spin_up - dot(turning, n)) * n;
  const V most = rolls * (V(c.rolling) * normal * about_contact / (body.mass * r));
  loads.torque -= capped(about_contact * rate, most, length(rolling)) * rolling;
  loads.torque -= capped(inertia * rate, V(c.spinning) * normal * r, length(spinning)) * spinning;

  // What keeps the slip from changing, and brings back what there is of it.
  const Vector3<V> slipping =
      (one / body.mass) * loads.force - (r * inverse_inertia) * cross(loads.torque, n) - cross(turning, body.velocity);
  const Vector3<V> hold = responding * (slipping + rate * slip);
  const V share = capped(one, grip, length(hold));
  const Vector3<V> friction = share * hold;
  loads.force -= friction;
  loads.torque += r * cross(n, friction);
}

struct Table {
  /// Friction answers to all that pushes the ball: last of the list, and its work is what it changes of all.
  static constexpr bool reads_loads = true;
  using Constants = TableConstants;

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    const Body<V> here = body;  // nothing else has an address
    Loads<V> all = loads;
    add_table_loads(c, here, all);
    loads = all;
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    const auto coefficient = [](const char* name, double fallback, const char* doc) {
      return ParameterInfo{.name = name, .unit = "1", .fallback = fallback, .minimum = 0, .doc = doc};
    };
    return {.name = "table",
            .doc =
                "a flat table that balls stay on: it carries what presses them on it (N), they slide under friction "
                "mu N until they roll (slip u = v - s - R w x n dies within the settling time), rolling and spin "
                "about n fade; it may turn",
            .source =
                "Coriolis 1835; Alciatore, The Illustrated Principles of Pool and Billiards; Weckesser 1997, Am. "
                "J. Phys. 65, 736",
            .parameters = {coefficient("sliding", 0.2, "mu; 0: no grip at all"),
                           coefficient("rolling", 0.01, "what a ball that rolls loses, over N / m"),
                           coefficient("spinning", 0.0127, "T = c N R against spin about n; a cloth has 4/9 R, in m"),
                           {.name = "normal",
                            .kind = ParameterKind::vector,
                            .unit = "1",
                            .fallback = Vector3d(0, 0, 1),
                            .doc = "n, of any length"},
                           {.name = "turning", .unit = "rad/s", .fallback = 0.0, .doc = "of the table about n"},
                           {.name = "centre",
                            .kind = ParameterKind::vector,
                            .unit = "m",
                            .fallback = Vector3d(0, 0, 0),
                            .doc = "what it turns about"},
                           {.name = "settling",
                            .unit = "s",
                            .fallback = 1e-3,
                            .minimum = 1e-12,
                            .doc = "t in which the last slip dies: friction fades below slips of mu N t / m, which "
                                   "moves a ball by half of mu g t^2; steps cannot be much longer"}},
            .reads = {"position", "velocity", "spin", "radius"},
            .exerts = {"force", "torque"},
            .flops = 190};
  }
  static Constants pack(const EffectInput& input) {
    const Vector3d n = input.exact_vector("normal").normalized(), turning = input.exact("turning") * n;
    const auto real = [](const Vector3d& a) {
      return Vector3<Real>{static_cast<Real>(a.x()), static_cast<Real>(a.y()), static_cast<Real>(a.z())};
    };
    return {input.radius,
            input.inverse_inertia,
            real(n),
            input.vector("centre"),
            real(turning),
            input.number("sliding"),
            input.number("rolling"),
            input.number("spinning"),
            static_cast<Real>(1 / input.exact("settling"))};
  }
  /// Slip, the end of rolling and that of spin fade at one rate; a table that turns takes rolling balls around.
  static Stiffness stiffness(const EffectInput& input) {
    double least = std::numeric_limits<double>::infinity();
    for (const EffectInput::Size& size : input.sizes) least = std::min(least, size.mass);
    return {.damping = least / input.exact("settling"), .gyration = least * std::abs(input.exact("turning"))};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
