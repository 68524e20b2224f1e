// A turning body whose orientation moves by the exponential map: within a step the state holds the rotation vector
// since the step's start in place of the quaternion, and the end of the step is exp(r) q. So every Runge-Kutta row
// becomes its Munthe-Kaas form, the quaternion keeps its length, and a steady spin is exact. (Munthe-Kaas 1999, Appl.
// Numer. Math. 29, 115; Hairer, Lubich & Wanner, Geometric Numerical Integration, IV.8.2.)
#pragma once

#include "engine/kernels/motion.h"
#include "engine/kernels/rotation_vector.h"

namespace ballpark::BALLPARK_PRECISION {

/// M: a motion whose last four values of state are a quaternion.
template <class M>
struct ExponentialMotion {
  static constexpr bool spins = true, turns = true, by_vector = true, special = true;
  static constexpr int position_end = M::position_end, momentum = M::momentum, quaternion = M::quaternion;
  static constexpr int size = M::size - 1;

  template <class V>
  struct Constants {
    std::size_t row;
    typename M::template Constants<V> body;
    V start[4];  ///< orientation at the step's start
  };

  template <class V>
  BALLPARK_INLINE static Constants<V> constants(const BodyConstants& c, std::size_t row) {
    Constants<V> k;
    k.row = row;
    k.body = M::template constants<V>(c, row);
    load_columns(c.orientation, row, k.start);
    return k;
  }

  /// Columns of a trial hold its rotation vector; in those of the state it is zero.
  template <class V>
  BALLPARK_INLINE static void load(const StateColumns& s, std::size_t row, V* y) {
    V whole[M::size];
    M::load(s, row, whole);
    for (int i = 0; i < quaternion; ++i) y[i] = whole[i];
    for (int i = quaternion; i < size; ++i) y[i] = V(Real(0));
    if (s.turn[0]) load_columns(s.turn, row, y + quaternion);
  }

  template <class V>
  BALLPARK_INLINE static void store(const StateColumns& s, const Constants<V>& k, const V* y) {
    V whole[M::size];
    with_quaternion(k, y, whole);
    M::store(s, k.body, whole);
    if (s.turn[0]) store_columns(s.turn, k.row, y + quaternion);
  }

  template <class V>
  BALLPARK_INLINE static V spin_per_momentum(const Constants<V>& k) {
    return M::spin_per_momentum(k.body);
  }

  template <class V>
  BALLPARK_INLINE static Body<V> body(const Constants<V>& k, const V* y) {
    V whole[M::size];
    with_quaternion(k, y, whole);
    return M::body(k.body, whole);
  }

  template <class V>
  BALLPARK_INLINE static void rates(const Constants<V>& k, const V* y, const Body<V>& b, const Loads<V>& loads,
                                    V* rate) {
    V whole[M::size], whole_rate[M::size];
    with_quaternion(k, y, whole);
    M::rates(k.body, whole, b, loads, whole_rate);
    for (int i = 0; i < quaternion; ++i) rate[i] = whole_rate[i];
    put(rate + quaternion, rotation_vector_rate(vector_from(y + quaternion), b.spin));
  }

 private:
  template <class V>
  BALLPARK_INLINE static void with_quaternion(const Constants<V>& k, const V* y, V* whole) {
    for (int i = 0; i < quaternion; ++i) whole[i] = y[i];
    for (int c = 0; c < 4; ++c) whole[quaternion + c] = k.start[c];
    turn(vector_from(y + quaternion), whole + quaternion);
    tidy(whole + quaternion);
  }
};

}  // namespace ballpark::BALLPARK_PRECISION
