// Roots that are bracketed, to the last bit.
#pragma once

#include <cmath>
#include <limits>

namespace ballpark::cost {

/// The root between `low` and `high`, at which f rises through zero. `f(x)` gives its value and slope. Newton's steps
/// while they stay inside the bracket and shrink it well, else halves.
template <class R, class F>
R rising_root(F f, R low, R high) {
  R x = low + (high - low) / 2, last = high - low;
  for (int round = 0; round < 400 && x != low && x != high; ++round) {
    const auto [value, slope] = f(x);
    if (value == 0) return x;
    (value < 0 ? low : high) = x;
    R next = x - value / slope;
    if (!(next > low && next < high) || std::abs(next - x) > last / 2) next = low + (high - low) / 2;
    last = std::abs(next - x);
    if (last <= std::numeric_limits<R>::epsilon() / 2 * std::abs(next)) return next;
    x = next;
  }
  return x;
}

}  // namespace ballpark::cost
