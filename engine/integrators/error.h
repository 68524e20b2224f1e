// How far a step's estimated error is from what a tolerance allows.
#pragma once

#include "engine/integrators/method.h"
#include "engine/kernels/motion.h"

namespace ballpark::BALLPARK_PRECISION {

/// NaN if one is.
template <class V>
BALLPARK_INLINE V larger(const V& a, const V& b) {
  return select(a > b, a, select(a != a, a, b));
}

/// Sum of the squares of `count` values.
template <class V>
BALLPARK_INLINE V square(const V* a, int count) {
  V sum = V(Real(0));
  for (int i = 0; i < count; ++i) sum += a[i] * a[i];
  return sum;
}

/// |e|^2 / (absolute + relative max(|y|, |y'|))^2 of one quantity of `count` values and that length; of two estimates,
/// the one that Hairer, Norsett & Wanner (II.10, dop853) make of them: |e|^2 / sqrt(|e|^2 + 0.01 |e'|^2) in place of
/// |e|. `unit` times the quantity is what the tolerance is of.
template <class V>
BALLPARK_INLINE V over_tolerance(const Method& m, const V& length, const V (*error)[max_errors], int count,
                                 const V& unit) {
  const V share = unit / (V(m.absolute) + V(m.relative) * unit * length);  // first, so that no square underflows
  V parts[max_errors] = {V(Real(0)), V(Real(0))};
  for (int e = 0; e < m.errors; ++e) {
    for (int i = 0; i < count; ++i) parts[e] += (share * error[i][e]) * (share * error[i][e]);
  }
  if (m.errors < 2) return parts[0];
  const V zero = V(Real(0)), both = parts[0] + V(Real(0.01)) * parts[1];
  return select(both == zero, zero, parts[0] * (parts[0] / both));
}

/// The largest over_tolerance of the body's quantities: position [m], velocity [m/s], angular momentum as spin [rad/s],
/// orientation as an angle [rad].
template <class S, class Constants, class V>
BALLPARK_INLINE V over_tolerance(const Method& m, const Constants& c, const V* y, const S& next,
                                 const V (*error)[max_errors]) {
  using M = typename S::Motion;
  const V one = V(Real(1));
  V worst = V(Real(0));
  const auto judge = [&](int at, int count, const V& unit) BALLPARK_INLINE_LAMBDA {
    const V length = square_root(larger(square(y + at, count), square(next.y + at, count)));
    worst = larger(worst, over_tolerance(m, length, error + at, count, unit));
  };
  if constexpr (M::position_end > 0) {
    judge(0, 3, one);
    judge(M::position_end, 3, one);
  }
  if constexpr (M::spins) judge(M::momentum, 3, M::spin_per_momentum(c));
  if constexpr (M::turns && M::by_vector) {  // as much as of a quaternion, whose length is 1 and turns by half
    worst = larger(worst, over_tolerance(m, V(Real(2)), error + M::quaternion, 3, one));
  } else if constexpr (M::turns) {
    judge(M::quaternion, 4, V(Real(2)));
  }
  return worst;
}

}  // namespace ballpark::BALLPARK_PRECISION
