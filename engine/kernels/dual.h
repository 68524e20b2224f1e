// A value and its derivatives by n variables (forward mode). A vector type of kernels with one lane: code that is a
// template on V gives its exact derivatives by running on this.
#pragma once

#include "engine/kernels/power.h"

namespace ballpark::BALLPARK_PRECISION {

template <int n>
struct Dual {
  Real value;
  Real by[n];  ///< derivatives

  Dual() = default;
  explicit Dual(Real constant) : value(constant), by{} {}
  /// The i-th variable itself.
  static Dual variable(Real value, int i) {
    Dual v(value);
    v.by[i] = 1;
    return v;
  }

  Dual operator-() const { return scaled(-1, -value); }
  Dual& operator+=(const Dual& b) {
    for (int i = 0; i < n; ++i) by[i] += b.by[i];
    value += b.value;
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    for (int i = 0; i < n; ++i) by[i] -= b.by[i];
    value -= b.value;
    return *this;
  }
  Dual& operator*=(const Dual& b) {
    for (int i = 0; i < n; ++i) by[i] = by[i] * b.value + value * b.by[i];
    value *= b.value;
    return *this;
  }
  Dual& operator/=(const Dual& b) {
    value /= b.value;
    for (int i = 0; i < n; ++i) by[i] = (by[i] - value * b.by[i]) / b.value;
    return *this;
  }
  friend Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
  friend Dual operator*(Dual a, const Dual& b) { return a *= b; }
  friend Dual operator/(Dual a, const Dual& b) { return a /= b; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend bool operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }

  /// At 0, where the root has no derivative, 0: that of |v| v is then right.
  friend Dual square_root(const Dual& a) {
    const Real root = BALLPARK_PRECISION::square_root(a.value);
    return a.scaled(root > 0 ? 1 / (2 * root) : 0, root);
  }
  /// Likewise.
  friend Dual power(const Dual& a, Real p) {
    const Real raised = BALLPARK_PRECISION::power(a.value, p);
    return a.scaled(raised > 0 ? p * raised / a.value : 0, raised);
  }
  friend Dual nearest_whole(const Dual& a) { return Dual(BALLPARK_PRECISION::nearest_whole(a.value)); }

 private:
  /// Derivatives times a factor, beside a value.
  Dual scaled(Real factor, Real other) const {
    Dual v(other);
    for (int i = 0; i < n; ++i) v.by[i] = factor * by[i];
    return v;
  }
};

template <int n>
inline constexpr std::size_t lane_count<Dual<n>> = 1;

}  // namespace ballpark::BALLPARK_PRECISION
