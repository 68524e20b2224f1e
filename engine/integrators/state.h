// A step's state and rates in registers or columns, and the evaluation of forces, as all families see them. Templates
// on the motion M and the vector type V; M::size values of state.
#pragma once

#include "engine/integrators/method.h"
#include "engine/kernels/motion.h"

namespace ballpark::BALLPARK_PRECISION {

/// Rates k(phase, i), in registers or (staged path) in columns. Families are templates on which.
template <class M, class V>
struct LocalRates {
  V values[max_phases][M::size];
  BALLPARK_INLINE V operator()(int phase, int i) const { return values[phase][i]; }
};
template <class M, class V>
struct ColumnRates {
  Real* const* columns = nullptr;  ///< value i of set p: columns[p * M::size + i]
  std::size_t row = 0;
  BALLPARK_INLINE V operator()(int set, int i) const { return load<V>(columns[set * M::size + i] + row); }
  BALLPARK_INLINE void read(int set, V* k) const {
    for (int i = 0; i < M::size; ++i) k[i] = (*this)(set, i);
  }
  BALLPARK_INLINE void write(int set, const V* k) const {
    for (int i = 0; i < M::size; ++i) store(columns[set * M::size + i] + row, k[i]);
  }
};

template <int n, class V>
BALLPARK_INLINE void copy(const V* from, V* to) {
  for (int i = 0; i < n; ++i) to[i] = from[i];
}

/// The state of a step in registers. Compensated: what rounding takes from each sum is carried to the next one, so that
/// the error of a step is about h times an ulp of the state (Kahan 1965; Moller 1965; Hairer, Lubich & Wanner VIII.5).
template <class M, class V, bool compensated = false>
struct State {
  using Motion = M;
  using Value = V;
  static constexpr int size = M::size;

  V y[size];
  V carry[compensated ? size : 1];
  V over = V(Real(0));  ///< embedded pairs: the step's error over the tolerance, squared

  /// y_i += change_i for i in [begin, end).
  BALLPARK_INLINE void add(int begin, int end, const V* change) {
    for (int i = begin; i < end; ++i) add(i, change[i]);
  }

  /// Normalises the quaternion, if the motion has one.
  BALLPARK_INLINE void normalise() {
    if constexpr (M::turns && !M::by_vector) {
      V* q = y + M::quaternion;
      const V scale = inverse_length(q);
      for (int c = 0; c < 4; ++c) {
        if constexpr (compensated) {
          add(M::quaternion + c, q[c] * (scale - V(Real(1))));
        } else {
          q[c] *= scale;
        }
      }
    }
  }

 private:
  /// Compensated: Knuth's two-sum, y + change = sum + rest without error.
  BALLPARK_INLINE void add(int i, V change) {
    if constexpr (compensated) {
      const V add = change + carry[i], sum = y[i] + add, part = sum - y[i];
      carry[i] = (y[i] - (sum - part)) + (add - part);
      y[i] = sum;
    } else {
      y[i] += change;
    }
  }
};

/// Rates of the state y under the group's forces, so long after the step's start [s]; `forces` is any type with
/// loads(body, after) and read_position.
template <class M, class V, class Forces>
BALLPARK_INLINE void evaluate(const Forces& forces, const typename M::template Constants<V>& k, const V* y,
                              double after, V* rate) {
  const Body<V> body = M::body(k, y);
  M::rates(k, y, body, forces.loads(body, after), rate);
}

}  // namespace ballpark::BALLPARK_PRECISION
