// The families' phases, as templates on the motion M and the vector type V. n = M::size values of state.
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
  Real* const* columns;  ///< value i of phase p: columns[p * M::size + i]
  std::size_t row;
  BALLPARK_INLINE V operator()(int phase, int i) const { return load<V>(columns[phase * M::size + i] + row); }
};

template <int n, class V>
BALLPARK_INLINE void copy(const V* from, V* to) {
  for (int i = 0; i < n; ++i) to[i] = from[i];
}

/// The state of a step in registers. Compensated: what rounding takes from each sum is carried to the next one, so that
/// the error of a step is about h times an ulp of the state (Kahan 1965; Moller 1965; Hairer, Lubich & Wanner VIII.5).
template <class M, class V>
struct State {
  V y[M::size];
  V carry[M::size];
  bool compensated;

  /// y_i += change_i for i in [begin, end).
  BALLPARK_INLINE void add(int begin, int end, const V* change) {
    if (!compensated) {
      for (int i = begin; i < end; ++i) y[i] += change[i];
      return;
    }
    for (int i = begin; i < end; ++i) add_exactly(i, change[i]);
  }

  /// Normalises the quaternion, if the motion has one.
  BALLPARK_INLINE void normalise() {
    if constexpr (M::turns) {
      V* q = y + M::quaternion;
      const V scale = inverse_length(q);
      for (int c = 0; c < 4; ++c) {
        if (compensated) {
          add_exactly(M::quaternion + c, q[c] * (scale - V(Real(1))));
        } else {
          q[c] *= scale;
        }
      }
    }
  }

 private:
  /// Knuth's two-sum: y + change = sum + rest without error.
  BALLPARK_INLINE void add_exactly(int i, V change) {
    const V add = change + carry[i], sum = y[i] + add, part = sum - y[i];
    carry[i] = (y[i] - (sum - part)) + (add - part);
    y[i] = sum;
  }
};

/// Rates of the state y under the group's forces; `forces` is any type with loads(body).
template <class M, class V, class Forces>
BALLPARK_INLINE void evaluate(const Forces& forces, const typename M::template Constants<V>& k, const V* y, V* rate) {
  const Body<V> body = M::body(k, y);
  M::rates(k, y, body, forces.loads(body), rate);
}

/// y_i = y + sum_j h a_ij k_j;  y' = y + sum_i h b_i k_i  (Hairer, Norsett & Wanner, Solving ODEs I, eq. II.1.8).
struct ExplicitRungeKutta {
  static constexpr bool prepare_moves = false;  ///< does prepare change the state itself?

  template <class M, class V, class Constants, class Rates>
  BALLPARK_INLINE static void prepare(const Method& m, int phase, const Constants&, State<M, V>& state, const Rates& k,
                                      V* trial) {
    copy<M::size>(state.y, trial);
    for (int j = 0; j < phase; ++j) {
      if (m.a[phase][j] == 0) continue;
      for (int i = 0; i < M::size; ++i) trial[i] += V(m.a[phase][j]) * k(j, i);
    }
  }

  template <class M, class V, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void finish(const Method& m, const Constants&, const Forces&, const Rates& k,
                                     State<M, V>& state) {
    V sum[M::size];
    for (int i = 0; i < M::size; ++i) sum[i] = V(Real(0));
    for (int p = 0; p < m.phases; ++p) {
      if (m.b[p] == 0) continue;
      for (int i = 0; i < M::size; ++i) sum[i] += V(m.b[p]) * k(p, i);
    }
    state.add(0, M::size, sum);
  }
};

/// y' = y + h f + h^2/2 f', f' by the chain rule from the effects' force derivatives.
struct Taylor {
  static constexpr bool prepare_moves = false;

  template <class M, class V, class Constants, class Rates>
  BALLPARK_INLINE static void prepare(const Method&, int, const Constants&, State<M, V>& state, const Rates&,
                                      V* trial) {
    copy<M::size>(state.y, trial);
  }

  template <class M, class V, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void finish(const Method& m, const Constants& c, const Forces& forces, const Rates& k,
                                     State<M, V>& state) {
    const V* y = state.y;
    const Body<V> body = M::body(c, y);
    const Loads<V> loads = forces.loads(body);
    const Acceleration<V> a = M::acceleration(c, y, body, loads);
    V rate[M::size], second[M::size], sum[M::size];
    for (int i = 0; i < M::size; ++i) rate[i] = k(0, i);
    M::second_rates(c, y, body, loads, a, forces.load_rates(body, a), rate, second);
    for (int i = 0; i < M::size; ++i) sum[i] = V(m.step) * rate[i] + V(m.half_square) * second[i];
    state.add(0, M::size, sum);
  }
};

/// Kicks change momenta (velocity, L) by the forces, drifts change positions (x, q) by the momenta:
/// kick_0, drift_0, kick_1, drift_1, ...  (Hairer, Lubich & Wanner, Geometric Numerical Integration, II.5.)
/// Forces that read velocity see it predicted to the end of the kick by the one before, which keeps velocity Verlet at
/// second order.
struct Splitting {
  static constexpr bool prepare_moves = true;

  template <class M, class V, class Rates>
  BALLPARK_INLINE static void kick(V step, const Rates& k, int phase, State<M, V>& state) {
    V change[M::size];
    for (int i = M::momenta_begin; i < M::momenta_end; ++i) change[i] = step * k(phase, i);
    state.add(M::momenta_begin, M::momenta_end, change);
  }

  /// Orientation by the midpoint rule at constant L: second order, as the methods that use it.
  template <class M, class V, class Constants>
  BALLPARK_INLINE static void drift(const Constants& c, V step, State<M, V>& state) {
    V rate[M::size], change[M::size];
    M::rates(c, state.y, M::body(c, state.y), Loads<V>{}, rate);
    if constexpr (M::turns) {
      V middle[M::size];
      copy<M::size>(state.y, middle);
      for (int i = M::quaternion; i < M::quaternion + 4; ++i) middle[i] += V(Real(0.5)) * step * rate[i];
      M::rates(c, middle, M::body(c, middle), Loads<V>{}, rate);
    }
    for (int i = 0; i < M::size; ++i) change[i] = step * rate[i];
    state.add(0, M::momenta_begin, change);
    state.add(M::momenta_end, M::size, change);
  }

  template <class M, class V, class Constants, class Rates>
  BALLPARK_INLINE static void apply(const Method& m, int phase, const Constants& c, const Rates& k,
                                    State<M, V>& state) {
    kick(V(m.kick[phase]), k, phase, state);
    if (m.drift[phase] != 0) drift(c, V(m.drift[phase]), state);
  }

  template <class M, class V, class Constants, class Rates>
  BALLPARK_INLINE static void prepare(const Method& m, int phase, const Constants& c, State<M, V>& state,
                                      const Rates& k, V* trial) {
    if (phase > 0) apply(m, phase - 1, c, k, state);
    copy<M::size>(state.y, trial);
    for (int i = M::momenta_begin; phase > 0 && i < M::momenta_end; ++i) {
      trial[i] += V(m.kick[phase]) * k(phase - 1, i);
    }
  }

  template <class M, class V, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void finish(const Method& m, const Constants& c, const Forces&, const Rates& k,
                                     State<M, V>& state) {
    apply(m, m.phases - 1, c, k, state);
  }
};

}  // namespace ballpark::BALLPARK_PRECISION
