// The step of bodies under local effects: families, motions and effects joined, as one fused kernel or as passes. Both
// call the same functions on the same values, so both give the same bits.
#pragma once

#include "engine/effects/mutual_gravity.h"
#include "engine/integrators/families.h"
#include "engine/kernels/exponential_motion.h"
#include "engine/world/kernel_table.h"

namespace ballpark::BALLPARK_PRECISION {

/// Turns NaN where any value of the state is not finite (or where their sum overflows: the caller looks closer).
/// Summed as a tree: short chains of additions.
template <int size, class V>
BALLPARK_INLINE void watch(V& poison, const V* y) {
  V sum[size];
  copy<size>(y, sum);
  for (int n = size; n > 1; n = (n + 1) / 2) {
    for (int i = 0; i < n / 2; ++i) sum[i] += sum[n - 1 - i];
  }
  poison += sum[0] * V(Real(0));
}

template <class M, class V, bool compensated>
BALLPARK_INLINE void load_state(const StepGroup& group, std::size_t row, State<M, V, compensated>& state) {
  M::load(group.state, row, state.y);
  for (int i = 0; compensated && i < M::size; ++i) state.carry[i] = load<V>(group.carry[i] + row);
}

template <class M, class V, bool compensated, class Constants>
BALLPARK_INLINE void store_state(const StepGroup& group, const Constants& c, const State<M, V, compensated>& state) {
  M::store(group.state, c, state.y);
  for (int i = 0; compensated && i < M::size; ++i) store(group.carry[i] + c.row, state.carry[i]);
}

/// Moves rows by move(constants, state), which is all of a step or its end. `embeds`: it may be undone, and tells its
/// error.
template <class S, bool embeds, class Move>
BALLPARK_INLINE Moved move_rows(const StepGroup& group, std::size_t first, std::size_t last, Move move) {
  using M = typename S::Motion;
  using V = typename S::Value;
  V poison = V(Real(0)), over = V(Real(0));
  for (std::size_t row = first; row < last; row += lane_count<V>) {
    const auto c = M::template constants<V>(group.constants, row);
    S state;
    load_state(group, row, state);
    if constexpr (embeds) {
      if (group.before.velocity[0]) M::store(group.before, c, state.y);
    }
    move(c, state);
    state.normalise();
    store_state(group, c, state);
    if constexpr (embeds) {  // padding may go where no body goes
      const V zero = V(Real(0)), bodies = V(static_cast<Real>(row < group.live ? group.live - row : 0));
      V part = zero;
      watch<M::size>(part, state.y);
      part += state.over * zero;
      const bool padded = row + lane_count<V> > group.live;
      poison += padded ? select(bodies > lane_numbers<V>(), part, zero) : part;
      over = larger(over, padded ? select(bodies > lane_numbers<V>(), state.over, zero) : state.over);
    } else {
      watch<M::size>(poison, state.y);
    }
  }
  return {!any_nonzero(poison), embeds ? largest(over) : Real(0)};
}

/// A whole step in registers: memory is read and written once.
template <class F, class M, class V, bool compensated>
BALLPARK_INLINE Moved step_rows(const StepGroup& group, const Method& method, std::size_t first, std::size_t last) {
  return move_rows<State<M, V, compensated>, F::embeds>(
      group, first, last, [&](const auto& c, auto& state) BALLPARK_INLINE_LAMBDA {
        whole_step<F>(method, c, group.forces, ColumnRates<M, V>{group.rates, c.row}, state);
      });
}

/// Before effects add to them.
template <class V>
BALLPARK_INLINE void clear(Real* const (&sums)[3], std::size_t row) {
  for (int c = 0; sums[0] && c < 3; ++c) store(sums[c] + row, V(Real(0)));
}

/// Two registers of particles at a time, unless all of them fit in one; a turning body's state fills the registers
/// alone. `vector<n>` is the vector type of n registers, or Real.
template <class F, class M, template <int> class Vector, bool compensated>
static Moved fused_step(const StepGroup& group, const Method& method, std::size_t first, std::size_t last) {
  if constexpr (!M::turns && !M::spins) {
    if (last - first > lane_count<Vector<1>>) {
      return step_rows<F, M, Vector<2>, compensated>(group, method, first, last);
    }
  }
  return step_rows<F, M, Vector<1>, compensated>(group, method, first, last);
}

template <class F, class M, class V, bool compensated>
static void prepare_pass(const StepGroup& group, const Method& method, int phase, std::size_t first, std::size_t last) {
  for (std::size_t row = first; row < last; row += lane_count<V>) {
    const auto c = M::template constants<V>(group.constants, row);
    State<M, V, compensated> state;
    V trial[M::size];
    load_state(group, row, state);
    F::prepare(method, phase, c, group.forces, state, ColumnRates<M, V>{group.rates, row}, trial);
    if constexpr (F::prepare_moves) store_state(group, c, state);
    M::store(group.trial, c, trial);
    if constexpr (M::spins) {
      if (group.trial_spin[0]) {
        V spin[3];
        put(spin, M::body(c, trial).spin);
        store_columns(group.trial_spin, row, spin);
      }
    }
    clear<V>(group.forces.sums.force, row);
    clear<V>(group.forces.sums.torque, row);
  }
}

template <class M, class V>
static void evaluate_pass(const StepGroup& group, const Method& method, int phase, std::size_t first,
                          std::size_t last) {
  for (std::size_t row = first; row < last; row += lane_count<V>) {
    const auto c = M::template constants<V>(group.constants, row);
    V trial[M::size], rate[M::size];
    M::load(group.trial, row, trial);
    evaluate<M>(group.forces, c, trial, method.offset[phase], rate);
    for (int i = 0; i < M::size; ++i) store(group.rates[phase * M::size + i] + row, rate[i]);
  }
}

template <class F, class M, class V, bool compensated>
static Moved finish_pass(const StepGroup& group, const Method& method, std::size_t first, std::size_t last) {
  return move_rows<State<M, V, compensated>, F::embeds>(
      group, first, last, [&](const auto& c, auto& state) BALLPARK_INLINE_LAMBDA {
        F::finish(method, c, group.forces, ColumnRates<M, V>{group.rates, c.row}, state);
      });
}

/// Special motions are for Runge-Kutta methods alone, whatever their tableau, and are never compensated: null.
template <class F, class M, bool compensated>
inline constexpr bool runs = !M::special || (std::is_same_v<typename F::Staged, ExplicitRungeKutta> && !compensated);

template <class F, class M, template <int> class Vector, bool compensated>
static constexpr FusedStep* fused_kernel() {
  using Whole = std::conditional_t<M::special, typename F::Staged, F>;
  if constexpr (runs<F, M, compensated>) return &fused_step<Whole, M, Vector, compensated>;
  return nullptr;
}
/// Passes wait for memory rather than for results: one register at a time.
template <class F, class M, template <int> class Vector, bool compensated>
static constexpr Prepare* prepare_kernel() {
  if constexpr (runs<F, M, compensated>) {
    return &prepare_pass < typename F::Staged, M, Vector<1>, compensated && F::prepare_moves > ;
  }
  return nullptr;
}
template <class F, class M, template <int> class Vector, bool compensated>
static constexpr Finish* finish_kernel() {
  if constexpr (runs<F, M, compensated>) return &finish_pass<typename F::Staged, M, Vector<1>, compensated>;
  return nullptr;
}

template <class F, bool compensated, template <int> class Vector, class... M>
static constexpr FamilyKernels family_kernels() {
  return {{fused_kernel<F, M, Vector, compensated>()...},
          {prepare_kernel<F, M, Vector, compensated>()...},
          {finish_kernel<F, M, Vector, compensated>()...}};
}

template <bool compensated, template <int> class Vector, class... M>
static constexpr StepKernels step_kernels() {
  StepKernels kernels = {{family_kernels<ExplicitRungeKutta, compensated, Vector, M...>(),
                          family_kernels<ChainedRungeKutta, compensated, Vector, M...>(),
                          family_kernels<Taylor, compensated, Vector, M...>(),
                          family_kernels<Splitting, compensated, Vector, M...>(),
                          family_kernels<Multistep, compensated, Vector, M...>()}};
  return kernels;
}

template <template <int> class Vector, class... M>
static constexpr KernelTable make_table(const char* target) {
  return {target,
          {step_kernels<false, Vector, M...>(), step_kernels<true, Vector, M...>()},
          {&evaluate_pass<M, Vector<1>>...},
          pair_kernels<Vector<1>>()};
}

/// In the order of MotionKind.
template <template <int> class Vector>
static constexpr KernelTable table_of_all_motions(const char* target) {
  return make_table<Vector, FreeMotion<Spin::none>, FreeMotion<Spin::carried>, FreeMotion<Spin::oriented>,
                    FreeMotion<Spin::rigid>, PivotedMotion, FreeMotion<Spin::body>,
                    ExponentialMotion<FreeMotion<Spin::oriented>>, ExponentialMotion<FreeMotion<Spin::rigid>>,
                    ExponentialMotion<PivotedMotion>>(target);
}

}  // namespace ballpark::BALLPARK_PRECISION
