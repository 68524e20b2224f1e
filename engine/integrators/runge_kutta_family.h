// Explicit Runge-Kutta methods and Taylor's: their phases.
#pragma once

#include "engine/integrators/error.h"
#include "engine/integrators/state.h"

namespace ballpark::BALLPARK_PRECISION {

/// y_i = y + sum_j h a_ij k_j;  y' = y + sum_i h b_i k_i  (Hairer, Norsett & Wanner, Solving ODEs I, eq. II.1.8).
/// Embedded pairs: the error is sum_i h e_i k_i. Their last phase is at y', and so the first of the step that follows.
struct ExplicitRungeKutta {
  using Staged = ExplicitRungeKutta;            ///< the family whose passes the staged path runs
  static constexpr bool prepare_moves = false;  ///< does prepare change the state itself?
  static constexpr bool embeds = true;          ///< may it estimate its error?

  template <class S, class V, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void prepare(const Method& m, int phase, const Constants&, const Forces&, S& state,
                                      const Rates& k, V* trial) {
    copy<S::size>(state.y, trial);
    for (int j = 0; j < phase; ++j) {
      if (m.a[phase][j] == 0) continue;
      for (int i = 0; i < S::size; ++i) trial[i] += V(m.a[phase][j]) * k(j, i);
    }
  }

  template <class S, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void finish(const Method& m, const Constants& c, const Forces&, const Rates& k, S& state) {
    using V = typename S::Value;
    V sum[S::size];
    for (int i = 0; i < S::size; ++i) sum[i] = V(Real(0));
    for (int p = 0; p < m.phases; ++p) {
      if (m.b[p] == 0) continue;
      for (int i = 0; i < S::size; ++i) sum[i] += V(m.b[p]) * k(p, i);
    }
    if (m.errors == 0) return state.add(0, S::size, sum);
    V before[S::size], error[S::size][max_errors];
    copy<S::size>(state.y, before);
    state.add(0, S::size, sum);
    for (int i = 0; i < S::size; ++i) {
      for (V& e : error[i]) e = V(Real(0));
    }
    for (int e = 0; e < m.errors; ++e) {
      for (int p = 0; p < m.phases; ++p) {
        if (m.error[e][p] == 0) continue;
        for (int i = 0; i < S::size; ++i) error[i][e] += V(m.error[e][p]) * k(p, i);
      }
    }
    state.over = over_tolerance(m, c, before, state, error);
  }

  template <class S, class Constants, class Forces>
  BALLPARK_INLINE static void whole_step(const Method& m, const Constants& c, const Forces& forces,
                                         const ColumnRates<typename S::Motion, typename S::Value>& kept, S& state) {
    using M = typename S::Motion;
    typename S::Value trial[S::size];
    LocalRates<M, typename S::Value> k;
    if (m.first_known) kept.read(0, k.values[0]);
    for (int p = m.first_known ? 1 : 0; p < m.phases; ++p) {
      prepare(m, p, c, forces, state, k, trial);
      evaluate<M>(forces, c, trial, m.offset[p], k.values[p]);
    }
    if (m.keeps_first) kept.write(0, k.values[0]);
    if (m.errors > 0) kept.write(m.last_set, k.values[m.phases - 1]);
    finish(m, c, forces, k, state);
  }
};

/// Tableaus whose a is its subdiagonal (Euler, midpoint, Heun, rk4): each stage needs the one before only, so a whole
/// step keeps one k, and positions of trial states are computed only for effects that read them. The sums are those of
/// ExplicitRungeKutta in the same order, and so are the bits.
struct ChainedRungeKutta : ExplicitRungeKutta {
  static constexpr bool embeds = false;

  template <class S, class Constants, class Forces>
  BALLPARK_INLINE static void whole_step(const Method& m, const Constants& c, const Forces& forces,
                                         const ColumnRates<typename S::Motion, typename S::Value>&, S& state) {
    using V = typename S::Value;
    V trial[S::size], k[S::size], sum[S::size];
    copy<S::size>(state.y, trial);
    for (int i = 0; i < S::size; ++i) sum[i] = V(Real(0));
    for (int p = 0;;) {
      evaluate<typename S::Motion>(forces, c, trial, m.offset[p], k);
      for (int i = 0; m.b[p] != 0 && i < S::size; ++i) sum[i] += V(m.b[p]) * k[i];
      if (++p == m.phases) break;
      const auto move = [&](int i) BALLPARK_INLINE_LAMBDA { trial[i] = state.y[i] + V(m.a[p][p - 1]) * k[i]; };
      for (int i = 0; forces.read_position && i < S::Motion::position_end; ++i) move(i);
      for (int i = S::Motion::position_end; i < S::size; ++i) move(i);
    }
    state.add(0, S::size, sum);
  }
};

/// y' = y + h f + h^2/2 f', f' by the chain rule from the effects' force derivatives.
struct Taylor {
  using Staged = Taylor;
  static constexpr bool prepare_moves = false;
  static constexpr bool embeds = false;

  template <class S, class V, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void prepare(const Method&, int, const Constants&, const Forces&, S& state, const Rates&,
                                      V* trial) {
    copy<S::size>(state.y, trial);
  }

  template <class S, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void finish(const Method& m, const Constants& c, const Forces& forces, const Rates& k,
                                     S& state) {
    typename S::Value rate[S::size];
    for (int i = 0; i < S::size; ++i) rate[i] = k(0, i);
    const auto body = S::Motion::body(c, state.y);
    move(m, c, forces, body, forces.loads(body, 0), rate, state);
  }

  template <class S, class Constants, class Forces>
  BALLPARK_INLINE static void whole_step(const Method& m, const Constants& c, const Forces& forces,
                                         const ColumnRates<typename S::Motion, typename S::Value>&, S& state) {
    typename S::Value rate[S::size];
    const auto body = S::Motion::body(c, state.y);
    const auto loads = forces.loads(body, 0);
    S::Motion::rates(c, state.y, body, loads, rate);
    move(m, c, forces, body, loads, rate, state);
  }

 private:
  template <class S, class V, class Constants, class Forces>
  BALLPARK_INLINE static void move(const Method& m, const Constants& c, const Forces& forces, const Body<V>& body,
                                   const Loads<V>& loads, const V* rate, S& state) {
    using M = typename S::Motion;
    const Acceleration<V> a = M::acceleration(c, state.y, body, loads);
    V second[S::size], sum[S::size];
    M::second_rates(c, state.y, body, loads, a, forces.load_rates(body, a), rate, second);
    for (int i = 0; i < S::size; ++i) sum[i] = V(m.step) * rate[i] + V(m.half_square) * second[i];
    state.add(0, S::size, sum);
  }
};

}  // namespace ballpark::BALLPARK_PRECISION
