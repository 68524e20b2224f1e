// Splittings into kicks and drifts: their phases.
#pragma once

#include "engine/integrators/state.h"

namespace ballpark::BALLPARK_PRECISION {

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
    predict(m, phase, k, state, trial);
  }

  template <class S, class Constants, class Forces, class Rates>
  BALLPARK_INLINE static void finish(const Method& m, const Constants& c, const Forces& forces, const Rates& k,
                                     S& state) {
    apply(m, m.phases - 1, c, forces, k, state);
  }

  template <class S, class Constants, class Forces>
  BALLPARK_INLINE static void whole_step(const Method& m, const Constants& c, const Forces& forces,
                                         const ColumnRates<typename S::Motion, typename S::Value>&, S& state) {
    using M = typename S::Motion;
    typename S::Value trial[S::size];
    LocalRates<M, typename S::Value> k;
    if (m.lead != 0) drift(m, c, m.lead, state);
    for (int p = 0; p < m.phases; ++p) {
      predict(m, p, k, state, trial);
      evaluate<M>(forces, c, trial, m.offset[p], k.values[p]);
      apply(m, p, c, forces, k, state);
    }
  }

 private:
  template <class S, class Rates, class V>
  BALLPARK_INLINE static void predict(const Method& m, int phase, const Rates& k, const S& state, V* trial) {
    copy<S::size>(state.y, trial);
    for (int i = S::Motion::momenta_begin; phase > 0 && i < S::Motion::momenta_end; ++i) {
      trial[i] += V(m.kick[phase]) * k(phase - 1, i);
    }
  }

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

}  // namespace ballpark::BALLPARK_PRECISION
