#include "engine/world/motion_calls.h"

#include "engine/kernels/dual.h"
#include "engine/world/local_step.h"
#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// The motion's and the effects' own code, run on duals: by state, then (if pulled) by pull.
template <class M, bool pulled>
void differentiate(const StepGroup& group, std::size_t row, const Real* y, double after, const Vector3<Real>& pull,
                   BodyRates& out) {
  using V = Dual<M::size + (pulled ? 3 : 0)>;
  V state[M::size], rate[M::size];
  for (int i = 0; i < M::size; ++i) state[i] = V::variable(y[i], i);
  const auto c = M::template constants<V>(group.constants, row);
  const Body<V> body = M::body(c, state);
  Loads<V> loads = group.forces.loads(body, after);
  if constexpr (pulled) {
    loads.force += {V::variable(pull.x, M::size), V::variable(pull.y, M::size + 1), V::variable(pull.z, M::size + 2)};
    V place[6];
    put(place, body.position);
    put(place + 3, body.velocity);
    for (int i = 0; i < 6; ++i) copy<M::size>(place[i].by, out.place_by_state[i]);
  }
  M::rates(c, state, body, loads, rate);
  for (int i = 0; i < M::size; ++i) {
    out.rate[i] = rate[i].value;
    copy<M::size>(rate[i].by, out.by_state[i]);
    if constexpr (pulled) copy<3>(rate[i].by + M::size, out.by_pull[i]);
  }
}

template <class M>
struct Calls {
  static void load(const StepGroup& group, std::size_t row, Real* y) { M::load(group.state, row, y); }

  static void units(const StepGroup& group, std::size_t row, Real h, Real* unit) {
    for (int i = 0; i < M::size; ++i) unit[i] = i < M::position_end ? 1 : 1 / h;
    if constexpr (M::spins) {
      const auto c = M::template constants<Real>(group.constants, row);
      for (int i = 0; i < 3; ++i) unit[M::momentum + i] = 1 / (h * M::spin_per_momentum(c));
    }
    for (int i = 0; M::turns && i < 4; ++i) unit[M::quaternion + i] = 1;
  }

  static void place(const StepGroup& group, std::size_t row, const Real* y, Real (&place)[6]) {
    const Body<Real> body = M::body(M::template constants<Real>(group.constants, row), y);
    put(place, body.position);
    put(place + 3, body.velocity);
  }

  static void rates(const StepGroup& group, std::size_t row, const Real* y, double after, BodyRates& out) {
    differentiate<M, false>(group, row, y, after, {}, out);
  }

  static bool move(const StepGroup& group, std::size_t row, const Real* change) {
    return group.carry ? move<true>(group, row, change) : move<false>(group, row, change);
  }

  static constexpr MotionCalls all() {
    MotionCalls calls{M::size, {}, &load, &units, &place, &rates, &differentiate<M, true>, &move};
    for (int i = 0; i < M::size; ++i)
      calls.quantity_begin[i] = M::turns && i >= M::quaternion ? M::quaternion : i / 3 * 3;
    return calls;
  }

 private:
  template <bool compensated>
  static bool move(const StepGroup& group, std::size_t row, const Real* change) {
    State<M, Real, compensated> state;
    load_state(group, row, state);
    state.add(0, M::size, change);
    state.normalise();
    store_state(group, M::template constants<Real>(group.constants, row), state);
    Real poison = 0;
    watch<M::size>(poison, state.y);
    return poison == 0;
  }
};

}  // namespace

const MotionCalls& calls_of(MotionKind kind) {
  return with_carried(kind, []<class M>() -> const MotionCalls& {
    static constexpr MotionCalls calls = Calls<M>::all();
    return calls;
  });
}

}  // namespace ballpark::BALLPARK_PRECISION
