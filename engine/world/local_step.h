// The step of bodies under local effects: families, motions and effects joined, as one fused kernel or as passes. Both
// call the same functions on the same values, so both give the same bits.
#pragma once

#include "engine/integrators/families.h"
#include "engine/world/kernel_table.h"

namespace ballpark::BALLPARK_PRECISION {

/// Turns NaN where any value of the state is not finite (or where their sum overflows: the caller looks closer).
template <class M, class V>
BALLPARK_INLINE void watch(V& poison, const V* y) {
  V sum = y[0];
  for (int i = 1; i < M::size; ++i) sum += y[i];
  poison += sum * V(Real(0));
}

template <class M, class V>
BALLPARK_INLINE void load_state(const StepGroup& group, std::size_t row, State<M, V>& state) {
  M::load(group.state, row, state.y);
  state.compensated = group.carry != nullptr;
  for (int i = 0; i < M::size; ++i) {
    state.carry[i] = state.compensated ? load<V>(group.carry[i] + row) : V(Real(0));
  }
}

template <class M, class V, class Constants>
BALLPARK_INLINE void store_state(const StepGroup& group, const Constants& c, const State<M, V>& state) {
  M::store(group.state, c, state.y);
  if (!state.compensated) return;
  for (int i = 0; i < M::size; ++i) store(group.carry[i] + c.row, state.carry[i]);
}

/// A whole step in registers: memory is read and written once.
template <class F, class M, class V>
static bool fused_step(const StepGroup& group, const Method& method, std::size_t first, std::size_t last) {
  V poison = V(Real(0));
  for (std::size_t row = first; row < last; row += lane_count<V>) {
    const auto c = M::template constants<V>(group.constants, row);
    State<M, V> state;
    V trial[M::size];
    LocalRates<M, V> k;
    load_state(group, row, state);
    for (int p = 0; p < method.phases; ++p) {
      F::prepare(method, p, c, state, k, trial);
      evaluate<M>(group.forces, c, trial, k.values[p]);
    }
    F::finish(method, c, group.forces, k, state);
    state.normalise();
    store_state(group, c, state);
    watch<M>(poison, state.y);
  }
  return !any_nonzero(poison);
}

template <class F, class M, class V>
static void prepare_pass(const StepGroup& group, const Method& method, int phase, std::size_t first, std::size_t last) {
  for (std::size_t row = first; row < last; row += lane_count<V>) {
    const auto c = M::template constants<V>(group.constants, row);
    State<M, V> state;
    V trial[M::size];
    load_state(group, row, state);
    F::prepare(method, phase, c, state, ColumnRates<M, V>{group.rates, row}, trial);
    if constexpr (F::prepare_moves) store_state(group, c, state);
    M::store(group.trial, c, trial);
    if constexpr (M::spins) {
      if (group.trial_spin[0]) {
        V spin[3];
        put(spin, M::body(c, trial).spin);
        store_columns(group.trial_spin, row, spin);
      }
    }
  }
}

template <class M, class V>
static void evaluate_pass(const StepGroup& group, int phase, std::size_t first, std::size_t last) {
  for (std::size_t row = first; row < last; row += lane_count<V>) {
    const auto c = M::template constants<V>(group.constants, row);
    V trial[M::size], rate[M::size];
    M::load(group.trial, row, trial);
    evaluate<M>(group.forces, c, trial, rate);
    for (int i = 0; i < M::size; ++i) store(group.rates[phase * M::size + i] + row, rate[i]);
  }
}

template <class F, class M, class V>
static bool finish_pass(const StepGroup& group, const Method& method, std::size_t first, std::size_t last) {
  V poison = V(Real(0));
  for (std::size_t row = first; row < last; row += lane_count<V>) {
    const auto c = M::template constants<V>(group.constants, row);
    State<M, V> state;
    load_state(group, row, state);
    F::finish(method, c, group.forces, ColumnRates<M, V>{group.rates, row}, state);
    state.normalise();
    store_state(group, c, state);
    watch<M>(poison, state.y);
  }
  return !any_nonzero(poison);
}

template <class V, class... M>
static constexpr KernelTable make_table(const char* target) {
  return {
      target,
      lane_count<V>,
      {{&fused_step<ExplicitRungeKutta, M, V>...}, {&fused_step<Taylor, M, V>...}, {&fused_step<Splitting, M, V>...}},
      {{&prepare_pass<ExplicitRungeKutta, M, V>...},
       {&prepare_pass<Taylor, M, V>...},
       {&prepare_pass<Splitting, M, V>...}},
      {&evaluate_pass<M, V>...},
      {{&finish_pass<ExplicitRungeKutta, M, V>...},
       {&finish_pass<Taylor, M, V>...},
       {&finish_pass<Splitting, M, V>...}}};
}

/// In the order of MotionKind.
template <class V>
static constexpr KernelTable table_of_all_motions(const char* target) {
  return make_table<V, FreeMotion<Spin::none>, FreeMotion<Spin::carried>, FreeMotion<Spin::oriented>,
                    FreeMotion<Spin::rigid>, PivotedMotion>(target);
}

}  // namespace ballpark::BALLPARK_PRECISION
