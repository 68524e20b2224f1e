// Positions and velocities seen from a frame that turns steadily: F = -2 m Omega x v - m Omega x (Omega x r).
#pragma once

#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct RotatingFrame {
  struct Constants {
    Vector3<Real> rate, point;
    bool centrifugal;
  };

  template <class V>
  BALLPARK_INLINE static Vector3<V> lanes_of(const Vector3<Real>& a) {
    return {V(a.x), V(a.y), V(a.z)};
  }

  template <class V>
  BALLPARK_INLINE static void force(const Constants& c, const Body<V>& body, Loads<V>& loads) {
    const Vector3<V> rate = lanes_of<V>(c.rate);
    Vector3<V> swept = V(Real(2)) * body.velocity;
    if (c.centrifugal) swept += cross(rate, body.position - lanes_of<V>(c.point));
    loads.force -= body.mass * cross(rate, swept);
  }

  template <class V>
  BALLPARK_INLINE static Vector3<V> turning(const Constants& c, const Body<V>&) {
    return V(Real(-2)) * lanes_of<V>(c.rate);
  }

  template <class V>
  BALLPARK_INLINE static void force_rate(const Constants& c, const Body<V>& body, const Acceleration<V>& a,
                                         Loads<V>& loads) {
    const Vector3<V> rate = lanes_of<V>(c.rate);
    Vector3<V> swept = V(Real(2)) * a.linear;
    if (c.centrifugal) swept += cross(rate, body.velocity);
    loads.force -= body.mass * cross(rate, swept);
  }

  template <class V>
  BALLPARK_INLINE static V energy(const Constants& c, const Body<V>& body) {
    if (!c.centrifugal) return V(Real(0));
    const Vector3<V> u = cross(lanes_of<V>(c.rate), body.position - lanes_of<V>(c.point));
    return V(Real(-0.5)) * body.mass * dot(u, u);
  }

#ifndef BALLPARK_TARGET
  static EffectDescription description() {
    return {.name = "rotating_frame",
            .doc =
                "the scene as seen from a frame that turns steadily about a point: Coriolis force -2 m W x v and "
                "centrifugal force -m W x (W x (x - p)) on centres of mass; spin is not turned",
            .source = "Coriolis 1835; Landau & Lifshitz, Mechanics 39",
            .parameters = {{.name = "angular_velocity",
                            .kind = ParameterKind::vector,
                            .unit = "rad/s",
                            .fallback = {},
                            .doc = "W of the frame"},
                           {.name = "point",
                            .kind = ParameterKind::vector,
                            .unit = "m",
                            .fallback = Vector3d(0, 0, 0),
                            .doc = "p, a point of the axis"},
                           {.name = "centrifugal",
                            .kind = ParameterKind::word,
                            .unit = "",
                            .fallback = "on",
                            .choices = {"on", "off"},
                            .doc = "off: the Coriolis force alone, as where gravity includes the centrifugal force"}},
            .reads = {"position", "velocity"},
            .exerts = {"force"},
            .flops = 33};
  }
  static Constants pack(const EffectInput& input) {
    return {input.vector("angular_velocity"), input.vector("point"), input.word("centrifugal") == "on"};
  }
  /// Both are in proportion to mass. The centrifugal force is a spring that pushes.
  static Stiffness stiffness(const EffectInput& input) {
    const double mass = input.least_mass, rate = input.exact_vector("angular_velocity").norm();
    return {.spring = input.word("centrifugal") == "on" ? -mass * rate * rate : 0, .gyration = 2 * mass * rate};
  }
#endif
};

}  // namespace ballpark::BALLPARK_PRECISION
