// A fixed point that bodies turn about (pendulum, top). A constraint, so a motion of its own: the state is the
// orientation and the angular momentum L about the pivot, and the centre of mass follows, x = p + R a, v = w x R a.
//   L' = torque + R a x F,  q' = w q / 2,  w = R J^-1 R^T L,  J = I + m (a^2 1 - a a^T)  (parallel axes)
#pragma once

#include "engine/effects/effect_info.h"
#include "engine/kernels/motion.h"

namespace ballpark::BALLPARK_PRECISION {

struct PivotedMotion {
  static constexpr bool spins = true, turns = true, by_vector = false, special = false;
  static constexpr int position_end = 0, momentum = 0, quaternion = 3, size = 7;
  static constexpr int momenta_begin = 0, momenta_end = 3;

  template <class V>
  struct Constants {
    std::size_t row;
    V mass, inverse_inertia[6];
    Vector3<V> arm, pivot;
    PrincipalAxes<V> axes;
  };

  template <class V>
  BALLPARK_INLINE static Constants<V> constants(const BodyConstants& c, std::size_t row) {
    Constants<V> k;
    k.row = row;
    k.mass = c.mass.at<V>(row);
    for (int i = 0; i < 6; ++i) k.inverse_inertia[i] = c.inverse_inertia[i].at<V>(row);
    k.arm = vector_at<V>(c.arm, row);
    k.pivot = vector_at<V>(c.pivot, row);
    for (int i = 0; i < 3; ++i) {
      const PerBody* axis = c.principal + 3 * i;
      k.axes.axis[i] = {axis[0].at<V>(row), axis[1].at<V>(row), axis[2].at<V>(row)};
      k.axes.rate[i] = c.principal[9 + i].at<V>(row);
    }
    return k;
  }

  template <class V>
  BALLPARK_INLINE static void load(const StateColumns& s, std::size_t row, V* y) {
    load_columns(s.momentum, row, y);
    load_columns(s.orientation, row, y + quaternion);
  }

  template <class V>
  BALLPARK_INLINE static void store(const StateColumns& s, const Constants<V>& k, const V* y) {
    store_columns(s.momentum, k.row, y);
    store_columns(s.orientation, k.row, y + quaternion);
    const Body<V> b = body(k, y);
    V x[3], v[3];
    put(x, b.position);
    put(v, b.velocity);
    store_columns(s.position, k.row, x);
    store_columns(s.velocity, k.row, v);
  }

  template <class V>
  BALLPARK_INLINE static V spin_per_momentum(const Constants<V>& k) {
    V most = k.inverse_inertia[0];
    for (int i = 1; i < 3; ++i) most = select(k.inverse_inertia[i] > most, k.inverse_inertia[i], most);
    return most;
  }

  template <class V>
  BALLPARK_INLINE static const PrincipalAxes<V>& principal(const Constants<V>& k) {
    return k.axes;
  }

  template <class V>
  BALLPARK_INLINE static Rotation<V> rotation(const V* y) {
    return Rotation<V>(y[3], y[4], y[5], y[6]);
  }

  template <class V>
  BALLPARK_INLINE static Vector3<V> over_inertia(const Constants<V>& k, const V* y, const Vector3<V>& a) {
    const Rotation<V> r = rotation(y);
    const Vector3<V> b = r.to_body(a);
    const V* j = k.inverse_inertia;
    return r.to_world({j[0] * b.x + j[3] * b.y + j[4] * b.z, j[3] * b.x + j[1] * b.y + j[5] * b.z,
                       j[4] * b.x + j[5] * b.y + j[2] * b.z});
  }

  template <class V>
  BALLPARK_INLINE static Body<V> body(const Constants<V>& k, const V* y) {
    const Vector3<V> spin = over_inertia(k, y, vector_from(y));
    const Vector3<V> arm = rotation(y).to_world(k.arm);
    return {k.row, k.mass, k.pivot + arm, cross(spin, arm), spin};
  }

  template <class V>
  BALLPARK_INLINE static Vector3<V> torque_about_pivot(const Constants<V>& k, const V* y, const Loads<V>& loads) {
    return loads.torque + cross(rotation(y).to_world(k.arm), loads.force);
  }

  template <class V>
  BALLPARK_INLINE static void rates(const Constants<V>& k, const V* y, const Body<V>& b, const Loads<V>& loads,
                                    V* rate) {
    put(rate, torque_about_pivot(k, y, loads));
    quaternion_rate(b.spin, y + quaternion, rate + quaternion);
  }

  template <class V>
  BALLPARK_INLINE static Acceleration<V> acceleration(const Constants<V>& k, const V* y, const Body<V>& b,
                                                      const Loads<V>& loads) {
    const Vector3<V> torque = torque_about_pivot(k, y, loads) - cross(b.spin, vector_from(y));
    const Vector3<V> angular = over_inertia(k, y, torque);
    const Vector3<V> arm = rotation(y).to_world(k.arm);
    return {cross(angular, arm) + cross(b.spin, b.velocity), angular};
  }

  template <class V>
  BALLPARK_INLINE static void second_rates(const Constants<V>& k, const V* y, const Body<V>& b, const Loads<V>& loads,
                                           const Acceleration<V>& a, const Loads<V>& load_rates, const V* rate,
                                           V* second) {
    const Vector3<V> arm = rotation(y).to_world(k.arm);
    put(second, load_rates.torque + cross(b.velocity, loads.force) + cross(arm, load_rates.force));
    V turning[4], bending[4];
    quaternion_rate(b.spin, rate + quaternion, turning);
    quaternion_rate(a.angular, y + quaternion, bending);
    for (int c = 0; c < 4; ++c) second[quaternion + c] = turning[c] + bending[c];
  }
};

#ifndef BALLPARK_TARGET
struct Pivot {
  static EffectDescription description() {
    return {.name = "pivot",
            .doc =
                "bodies turn about a fixed point as rigid bodies; position and velocity follow from the rotation, a "
                "particle is a point mass on a massless rod",
            .source = "Euler's equations about a fixed point; parallel-axis theorem",
            .parameters = {{.name = "point",
                            .kind = ParameterKind::vectors,
                            .unit = "m",
                            .fallback = {},
                            .doc = "the fixed point: one, or one for each body"}},
            .reads = {"orientation", "spin"},
            .exerts = {"constraint"},
            .has_force_derivative = true,
            .flops = 90};
  }
};
#endif

}  // namespace ballpark::BALLPARK_PRECISION
