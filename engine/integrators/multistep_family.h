// Adams methods: their phases.
#pragma once

#include "engine/integrators/state.h"

namespace ballpark::BALLPARK_PRECISION {

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
      evaluate<M>(forces, c, trial, m.offset[p], now[p]);
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

}  // namespace ballpark::BALLPARK_PRECISION
