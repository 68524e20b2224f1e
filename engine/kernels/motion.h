// How a body moves: which values are its state, and their rates under given loads. A motion is chosen for each group at
// build, from what the scene calls for. All have the same members, so that an integrator is written once:
//   size               number of values in the state y, of which [momenta_begin, momenta_end) change by forces
//   Constants<V>       what is constant over a step, loaded once
//   load, store        state between columns and registers; store also writes columns that follow from the state
//   body               the quantities that effects read
//   rates              y' under loads
//   spin_per_momentum  a scale of the angular momentum
//   acceleration, second_rates   for Taylor-2: accelerations, and y'' under the loads' own rates
//   position_end       y[0, position_end) is the position, which nothing but effects reads
//   spins, turns       has an angular momentum, an orientation; momentum, quaternion: where they start in y
//   by_vector          the orientation in y is a rotation vector (exponential_motion.h), not a quaternion
//   special            stepped by Runge-Kutta methods only
//   principal          axes and inverse moments of inertia, for rotation by splitting
#pragma once

#include "engine/kernels/body.h"
#include "engine/kernels/free_rotation.h"

namespace ballpark::BALLPARK_PRECISION {

enum class MotionKind {
  point,
  spinning,
  oriented,
  rigid,
  pivoted,
  body_frame,
  oriented_exponential,
  rigid_exponential,
  pivoted_exponential
};
inline constexpr int motion_count = 9;
inline constexpr int max_state_size = 13;

template <class V>
BALLPARK_INLINE Vector3<V> vector_from(const V* y) {
  return {y[0], y[1], y[2]};
}
template <class V>
BALLPARK_INLINE void put(V* y, const Vector3<V>& a) {
  y[0] = a.x;
  y[1] = a.y;
  y[2] = a.z;
}
template <class V, std::size_t n>
BALLPARK_INLINE void load_columns(Real* const (&columns)[n], std::size_t row, V* y) {
  for (std::size_t c = 0; c < n; ++c) y[c] = load<V>(columns[c] + row);
}
template <class V, std::size_t n>
BALLPARK_INLINE void store_columns(Real* const (&columns)[n], std::size_t row, const V* y) {
  for (std::size_t c = 0; c < n; ++c) store(columns[c] + row, y[c]);
}

/// Translation (y = x, v) and, by `Spin`, rotation about the centre of mass.
///   none: no rotation.  carried: L only (isotropic inertia, w = L / I).  oriented: L and q, isotropic inertia.
///   rigid: L and q, w = R I^-1 R^T L.  body: q and the angular momentum in the body's axes, R^T L, for needles: a
///   small component of the spin is not the difference of large ones.
enum class Spin { none, carried, oriented, rigid, body };

template <Spin kind>
struct FreeMotion {
  static constexpr bool spins = kind != Spin::none;
  static constexpr bool own_axes = kind == Spin::rigid || kind == Spin::body;  ///< three moments of inertia
  static constexpr bool turns = kind == Spin::oriented || own_axes;
  static constexpr bool by_vector = false, special = kind == Spin::body;
  static constexpr int position_end = 3, momentum = 6, quaternion = 9;
  static constexpr int size = turns ? 13 : spins ? 9 : 6;
  static constexpr int momenta_begin = 3, momenta_end = spins ? 9 : 6;

  template <class V>
  struct Constants {
    std::size_t row;
    V mass, inverse_mass;
    V inverse_inertia[3];
  };

  template <class V>
  BALLPARK_INLINE static Constants<V> constants(const BodyConstants& c, std::size_t row) {
    Constants<V> k;
    k.row = row;
    k.mass = c.mass.at<V>(row);
    k.inverse_mass = c.effective_mass.inverse_at<V>(row);
    if constexpr (spins) {
      for (int i = 0; i < (own_axes ? 3 : 1); ++i) k.inverse_inertia[i] = c.inverse_inertia[i].at<V>(row);
    }
    return k;
  }

  template <class V>
  BALLPARK_INLINE static void load(const StateColumns& s, std::size_t row, V* y) {
    load_columns(s.position, row, y);
    load_columns(s.velocity, row, y + 3);
    if constexpr (spins) load_columns(s.momentum, row, y + momentum);
    if constexpr (turns) load_columns(s.orientation, row, y + quaternion);
  }

  template <class V>
  BALLPARK_INLINE static void store(const StateColumns& s, const Constants<V>& k, const V* y) {
    store_columns(s.position, k.row, y);
    store_columns(s.velocity, k.row, y + 3);
    if constexpr (spins) store_columns(s.momentum, k.row, y + momentum);
    if constexpr (turns) store_columns(s.orientation, k.row, y + quaternion);
  }

  /// An angular momentum times this is no less than the angular velocity that it may mean.
  template <class V>
  BALLPARK_INLINE static V spin_per_momentum(const Constants<V>& k) {
    V most = k.inverse_inertia[0];
    for (int i = 1; own_axes && i < 3; ++i) {
      most = select(k.inverse_inertia[i] > most, k.inverse_inertia[i], most);
    }
    return most;
  }

  template <class V>
  BALLPARK_INLINE static Rotation<V> rotation(const V* y) {
    return Rotation<V>(y[9], y[10], y[11], y[12]);
  }

  /// I^-1 b, body frame.
  template <class V>
  BALLPARK_INLINE static Vector3<V> spin_in_body(const Constants<V>& k, const Vector3<V>& b) {
    return {k.inverse_inertia[0] * b.x, k.inverse_inertia[1] * b.y, k.inverse_inertia[2] * b.z};
  }

  /// L in the world frame.
  template <class V>
  BALLPARK_INLINE static Vector3<V> angular_momentum(const V* y) {
    const Vector3<V> own = vector_from(y + momentum);
    if constexpr (kind == Spin::body) return rotation(y).to_world(own);
    return own;
  }

  template <class V>
  BALLPARK_INLINE static PrincipalAxes<V> principal(const Constants<V>& k) {
    const V zero = V(Real(0)), one = V(Real(1));
    PrincipalAxes<V> p{{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}, {}};
    for (int i = 0; i < 3; ++i) p.rate[i] = k.inverse_inertia[own_axes ? i : 0];
    return p;
  }

  /// I^-1 in the world frame, applied.
  template <class V>
  BALLPARK_INLINE static Vector3<V> over_inertia(const Constants<V>& k, const V* y, const Vector3<V>& a) {
    if constexpr (kind == Spin::rigid) {
      const Rotation<V> r = rotation(y);
      return r.to_world(spin_in_body(k, r.to_body(a)));
    } else {
      return k.inverse_inertia[0] * a;
    }
  }

  template <class V>
  BALLPARK_INLINE static Body<V> body(const Constants<V>& k, const V* y) {
    Body<V> b{k.row, k.mass, vector_from(y), vector_from(y + 3), {}};
    if constexpr (kind == Spin::body) {
      b.spin = rotation(y).to_world(spin_in_body(k, vector_from(y + momentum)));
    } else if constexpr (spins) {
      b.spin = over_inertia(k, y, vector_from(y + momentum));
    }
    return b;
  }

  template <class V>
  BALLPARK_INLINE static void rates(const Constants<V>& k, const V* y, const Body<V>& b, const Loads<V>& loads,
                                    V* rate) {
    put(rate, b.velocity);
    put(rate + 3, k.inverse_mass * loads.force);
    if constexpr (kind == Spin::body) {  // Euler's equations
      const Vector3<V> own = vector_from(y + momentum);
      put(rate + momentum, cross(own, spin_in_body(k, own)) + rotation(y).to_body(loads.torque));
    } else if constexpr (spins) {
      put(rate + momentum, loads.torque);
    }
    if constexpr (turns) quaternion_rate(b.spin, y + quaternion, rate + quaternion);
  }

  /// Euler's equation in the world frame: I w' = torque - w x L. Isotropic bodies: w is along L.
  template <class V>
  BALLPARK_INLINE static Acceleration<V> acceleration(const Constants<V>& k, const V* y, const Body<V>& b,
                                                      const Loads<V>& loads) {
    Acceleration<V> a{k.inverse_mass * loads.force, {}};
    if constexpr (kind == Spin::rigid) {
      a.angular = over_inertia(k, y, loads.torque - cross(b.spin, vector_from(y + momentum)));
    } else if constexpr (spins) {
      a.angular = over_inertia(k, y, loads.torque);
    }
    return a;
  }

  template <class V>
  BALLPARK_INLINE static void second_rates(const Constants<V>& k, const V* y, const Body<V>& b, const Loads<V>&,
                                           const Acceleration<V>& a, const Loads<V>& load_rates, const V* rate,
                                           V* second) {
    put(second, a.linear);
    put(second + 3, k.inverse_mass * load_rates.force);
    if constexpr (spins) put(second + momentum, load_rates.torque);
    if constexpr (turns) {
      V turning[4], bending[4];
      quaternion_rate(b.spin, rate + quaternion, turning);
      quaternion_rate(a.angular, y + quaternion, bending);
      for (int c = 0; c < 4; ++c) second[quaternion + c] = turning[c] + bending[c];
    }
  }
};

}  // namespace ballpark::BALLPARK_PRECISION
