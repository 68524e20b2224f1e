// The families' phases, as templates on the motion M and the vector type V. M::size values of state.
#pragma once

#include "engine/integrators/error.h"
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

/// Rates of the state y under the group's forces; `forces` is any type with loads(body) and read_position.
template <class M, class V, class Forces>
BALLPARK_INLINE void evaluate(const Forces& forces, const typename M::template Constants<V>& k, const V* y, V* rate) {
  const Body<V> body = M::body(k, y);
  M::rates(k, y, body, forces.loads(body), rate);
}

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
    if (m.first_known) {
      kept.read(0, k.values[0]);
    } else {
      evaluate<M>(forces, c, state.y, k.values[0]);
    }
    for (int p = 1; p < m.phases; ++p) {
      prepare(m, p, c, forces, state, k, trial);
      evaluate<M>(forces, c, trial, k.values[p]);
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
      evaluate<typename S::Motion>(forces, c, trial, k);
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
    using M = typename S::Motion;
    using V = typename S::Value;
    const V* y = state.y;
    const Body<V> body = M::body(c, y);
    const Loads<V> loads = forces.loads(body);
    const Acceleration<V> a = M::acceleration(c, y, body, loads);
    V rate[S::size], second[S::size], sum[S::size];
    for (int i = 0; i < S::size; ++i) rate[i] = k(0, i);
    M::second_rates(c, y, body, loads, a, forces.load_rates(body, a), rate, second);
    for (int i = 0; i < S::size; ++i) sum[i] = V(m.step) * rate[i] + V(m.half_square) * second[i];
    state.add(0, S::size, sum);
  }
};

/// Kicks change momenta (velocity, L) by the forces, drifts change positions (x, q) by the momenta:
/// (lead drift), kick_0, drift_0, kick_1, drift_1, ...  (Hairer, Lubich & Wanner, Geometric Numerical Integration,
/// II.5.) Forces that read velocity see it predicted to the end of the kick by the one before, which keeps velocity
/// Verlet at second order.
struct Splitting {
  using Staged = Splitting;
  static constexpr bool prepare_moves = true;
  static constexpr bool embeds = false;

  template <class S, class Constants, class Forces, class Rates, class V>
  BALLPARK_INLINE static void prepare(const Method& m, int phase, const Constants& c, const Forces& forces, S& state,
                                      const Rates& k, V* trial) {
    if (phase > 0) {
      apply(m, phase - 1, c, forces, k, state);
    } else if (m.lead != 0) {
      drift(m, c, m.lead, state);
    }
    copy<S::size>(state.y, trial);
    for (int i = S::Motion::momenta_begin; phase > 0 && i < S::Motion::momenta_end; ++i) {
      trial[i] += V(m.kick[phase]) * k(phase - 1, i);
    }
  }

  template <class S, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void finish(const Method& m, const Constants& c, const Forces& forces, const Rates& k,
                                     S& state) {
    apply(m, m.phases - 1, c, forces, k, state);
  }

 private:
  template <class S, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void apply(const Method& m, int phase, const Constants& c, const Forces& forces,
                                    const Rates& k, S& state) {
    if (m.turns_velocity) {
      kick(Real(0.5) * m.kick[phase], k, phase, state);
      turn_velocity(m.kick[phase], c, forces, state);
      kick(Real(0.5) * m.kick[phase], k, phase, state);
    } else {
      kick(m.kick[phase], k, phase, state);
    }
    if (m.drift[phase] != 0) drift(m, c, m.drift[phase], state);
  }

  template <class S, class Rates>
  BALLPARK_INLINE static void kick(Real step, const Rates& k, int phase, S& state) {
    using M = typename S::Motion;
    using V = typename S::Value;
    V change[S::size];
    for (int i = M::momenta_begin; i < M::momenta_end; ++i) change[i] = V(step) * k(phase, i);
    state.add(M::momenta_begin, M::momenta_end, change);
  }

  /// v' = W x v by Cayley's transform, which keeps |v|: v + 2 / (1 + t^2) t x (v + t x v), t = h W / 2. (Boris 1970;
  /// Birdsall & Langdon, Plasma Physics via Computer Simulation, 4-4.) Rounding of t would change |v| by the same in
  /// every step: what it did is taken back.
  template <class S, class Constants, class Forces>
  BALLPARK_INLINE static void turn_velocity(Real step, const Constants& c, const Forces& forces, S& state) {
    using M = typename S::Motion;
    using V = typename S::Value;
    if constexpr (M::position_end > 0) {  // a pivot ties velocities
      const V one = V(Real(1)), zero = V(Real(0));
      const Vector3<V> v = vector_from(state.y + M::position_end);
      const Vector3<V> t = V(Real(0.5) * step) * forces.turning(M::body(c, state.y));
      const Vector3<V> turn = ((one + one) / (one + dot(t, t))) * cross(t, v + cross(t, v)), turned = v + turn;
      const V twice = (one + one) * dot(turned, turned), gain = dot(turn, v + turned);
      V change[S::size];
      put(change + M::position_end, turn - select(twice > zero, gain / twice, zero) * turned);
      state.add(M::position_end, M::position_end + 3, change);
    }
  }

  /// Positions at constant momenta. Orientations by the midpoint rule, of second order, unless another rule is asked
  /// for.
  template <class S, class Constants>
  BALLPARK_INLINE static void drift(const Method& m, const Constants& c, Real step, S& state) {
    using M = typename S::Motion;
    using V = typename S::Value;
    V rate[S::size], change[S::size];
    M::rates(c, state.y, M::body(c, state.y), Loads<V>{}, rate);
    if constexpr (M::turns) {
      if (m.rotation == RotationRule::renormalise) {
        V middle[S::size];
        copy<S::size>(state.y, middle);
        for (int i = M::quaternion; i < M::quaternion + 4; ++i) middle[i] += V(Real(0.5)) * V(step) * rate[i];
        M::rates(c, middle, M::body(c, middle), Loads<V>{}, rate);
      } else {
        turn_orientation<M>(m, c, step, state.y);
        for (int i = M::quaternion; i < M::quaternion + 4; ++i) rate[i] = V(Real(0));
      }
    }
    for (int i = 0; i < S::size; ++i) change[i] = V(step) * rate[i];
    state.add(0, M::momenta_begin, change);
    state.add(M::momenta_end, S::size, change);
  }

  /// By the exponential map at the spin of the middle, or by splitting.
  template <class M, class V, class Constants>
  BALLPARK_INLINE static void turn_orientation(const Method& m, const Constants& c, Real step, V* y) {
    if (m.rotation == RotationRule::splitting) {
      turn_freely(M::principal(c), vector_from(y + M::momentum), step, m.turn_share, m.turns, y + M::quaternion);
      return;
    }
    V middle[M::size];
    copy<M::size>(y, middle);
    turn(V(Real(0.5) * step) * M::body(c, y).spin, middle + M::quaternion);
    turn(V(step) * M::body(c, middle).spin, y + M::quaternion);
  }
};

/// Adams-Bashforth: y' = y + sum_j h b_j f(y_n-j). With a second phase, Adams-Bashforth-Moulton as predict, evaluate,
/// correct: the predicted y' is where that phase evaluates. (HNW III.1)
struct Multistep {
  using Staged = Multistep;
  static constexpr bool prepare_moves = false;
  static constexpr bool embeds = false;

  template <class S, class V, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void prepare(const Method& m, int phase, const Constants&, const Forces&, S& state,
                                      const Rates& k, V* trial) {
    copy<S::size>(state.y, trial);
    if (phase == 0) return;
    V change[S::size];
    weigh<S>(m, m.past, k, change);
    for (int i = 0; i < S::size; ++i) trial[i] += change[i];
  }

  template <class S, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void finish(const Method& m, const Constants&, const Forces&, const Rates& k, S& state) {
    using V = typename S::Value;
    V change[S::size];
    weigh<S>(m, m.phases == 1 ? m.past : m.corrector + 1, k, change);
    for (int i = 0; m.phases > 1 && i < S::size; ++i) change[i] += V(m.corrector[0]) * k(1, i);
    state.add(0, S::size, change);
  }

  template <class S, class Constants, class Forces>
  BALLPARK_INLINE static void whole_step(const Method& m, const Constants& c, const Forces& forces,
                                         const ColumnRates<typename S::Motion, typename S::Value>& kept, S& state) {
    using M = typename S::Motion;
    using V = typename S::Value;
    V trial[S::size], now[2][S::size];
    for (auto& rates : now) {  // there may be one phase only
      for (V& rate : rates) rate = V(Real(0));
    }
    const auto k = [&](int set, int i) BALLPARK_INLINE_LAMBDA { return set < m.phases ? now[set][i] : kept(set, i); };
    for (int p = 0; p < m.phases; ++p) {
      prepare(m, p, c, forces, state, k, trial);
      evaluate<M>(forces, c, trial, now[p]);
    }
    kept.write(0, now[0]);
    finish(m, c, forces, k, state);
  }

 private:
  /// Of the rates at the step's start and of the steps before.
  template <class S, class Rates, class V>
  BALLPARK_INLINE static void weigh(const Method& m, const Real* weights, const Rates& k, V* change) {
    for (int i = 0; i < S::size; ++i) change[i] = V(weights[0]) * k(0, i);
    for (int j = 1; j <= m.history; ++j) {
      for (int i = 0; i < S::size; ++i) change[i] += V(weights[j]) * k(m.history_begin + j - 1, i);
    }
  }
};

/// A whole step in registers: all phases of the family F. `kept`: sets of rates that stay between steps.
template <class F, class S, class Constants, class Forces>
BALLPARK_INLINE void whole_step(const Method& m, const Constants& c, const Forces& forces,
                                const ColumnRates<typename S::Motion, typename S::Value>& kept, S& state) {
  if constexpr (requires { F::whole_step(m, c, forces, kept, state); }) {
    F::whole_step(m, c, forces, kept, state);
  } else {
    using M = typename S::Motion;
    typename S::Value trial[S::size];
    LocalRates<M, typename S::Value> k;
    for (int p = 0; p < m.phases; ++p) {
      F::prepare(m, p, c, forces, state, k, trial);
      evaluate<M>(forces, c, trial, k.values[p]);
    }
    F::finish(m, c, forces, k, state);
  }
}

/// Calls f with the family's type, as `f.template operator()<F>()`.
template <class F>
decltype(auto) with_family(Family family, F&& f) {
  switch (family) {
    case Family::chained_runge_kutta:
      return f.template operator()<ChainedRungeKutta>();
    case Family::taylor:
      return f.template operator()<Taylor>();
    case Family::splitting:
      return f.template operator()<Splitting>();
    case Family::multistep:
      return f.template operator()<Multistep>();
    case Family::explicit_runge_kutta:
    case Family::implicit_runge_kutta:  // solved elsewhere
      break;
  }
  return f.template operator()<ExplicitRungeKutta>();
}

}  // namespace ballpark::BALLPARK_PRECISION
