// Rotations as vectors: the axis times the angle. The exponential map takes one to its quaternion, and the inverse of
// its differential a turning state to the rate of its vector. (Hairer, Lubich & Wanner, Geometric Numerical
// Integration, IV.7 and IV.8.) Polynomials, so that bits are the same on every machine.
#pragma once

#include "engine/kernels/vector3.h"

namespace ballpark::BALLPARK_PRECISION {

/// Terms of the power series below that Real can tell from rounding, for angles up to a quarter turn.
inline constexpr int series_terms = sizeof(Real) == 4 ? 7 : sizeof(Real) == 8 ? 12 : 15;

/// sum of (-1)^k c_k u^k.
struct AlternatingSeries {
  Real c[series_terms];

  template <class V>
  BALLPARK_INLINE V at(const V& u) const {
    V sum = V(c[series_terms - 1]);
    for (int k = series_terms - 2; k >= 0; --k) sum = V(c[k]) - u * sum;
    return sum;
  }
};

/// c_k = 1 / (2 k + first)!, less 1 / (2 k + second)! if that is asked for.
constexpr AlternatingSeries inverse_factorials(int first, int second = 0) {
  AlternatingSeries series{};
  for (int k = 0; k < series_terms; ++k) {
    const auto inverse_factorial = [](int n) {
      long double product = 1;
      for (int i = 2; i <= n; ++i) product *= i;
      return 1 / product;
    };
    const long double value =
        inverse_factorial(2 * k + first) - (second > 0 ? inverse_factorial(2 * k + second) : 0.0L);
    series.c[k] = static_cast<Real>(value);
  }
  return series;
}

inline constexpr AlternatingSeries cosine_series = inverse_factorials(0);         ///< cos h, of h^2
inline constexpr AlternatingSeries sine_series = inverse_factorials(1);           ///< sin h / h
inline constexpr AlternatingSeries difference_series = inverse_factorials(2, 3);  ///< (sin h / h - cos h) / h^2

/// The nearest whole number, where Real has room for its halves.
template <class V>
BALLPARK_INLINE V nearest_whole(const V& x) {
  constexpr Real shift = sizeof(Real) == 4   ? Real(12582912)
                         : sizeof(Real) == 8 ? Real(6755399441055744)
                                             : Real(13835058055282163712.0L);  // 1.5 times the last that has halves
  return (x + V(shift)) - V(shift);
}

/// The unit quaternion that turns by the vector: (cos h, sin h r / |r|), h = |r| / 2. Whole turns of h by pi are taken
/// off, which may change its sign: the same rotation.
template <class V>
BALLPARK_INLINE void exponential(const Vector3<V>& r, V* q) {
  constexpr Real pi_high = Real(3.140625), pi_low = Real(9.67653589793238462643383279502884e-4L);  // pi, in two parts
  const V zero = V(Real(0)), one = V(Real(1));
  const V half = V(Real(0.5)) * length(r);
  const V turns = nearest_whole(half * V(Real(0.318309886183790671537767526745028724L)));
  const V rest = (half - turns * V(pi_high)) - turns * V(pi_low), square = rest * rest;
  const V share = select(half > zero, rest / half, one);
  const V sine = V(Real(0.5)) * (share * sine_series.at(square));
  q[0] = cosine_series.at(square);
  q[1] = sine * r.x;
  q[2] = sine * r.y;
  q[3] = sine * r.z;
}

/// a b: first b, then a, in the world's axes; first a, then b, in the body's.
template <class V>
BALLPARK_INLINE void product(const V* a, const V* b, V* out) {
  out[0] = a[0] * b[0] - (a[1] * b[1] + a[2] * b[2] + a[3] * b[3]);
  out[1] = a[0] * b[1] + a[1] * b[0] + (a[2] * b[3] - a[3] * b[2]);
  out[2] = a[0] * b[2] + a[2] * b[0] + (a[3] * b[1] - a[1] * b[3]);
  out[3] = a[0] * b[3] + a[3] * b[0] + (a[1] * b[2] - a[2] * b[1]);
}

/// q turned by the vector, in the world's axes.
template <class V>
BALLPARK_INLINE void turn(const Vector3<V>& r, V* q) {
  V by[4], turned[4];
  exponential(r, by);
  product(by, q, turned);
  for (int c = 0; c < 4; ++c) q[c] = turned[c];
}

/// One Newton step towards unit length, for quaternions that only rounding has taken from it.
template <class V>
BALLPARK_INLINE void tidy(V* q) {
  const V scale = V(Real(1.5)) - V(Real(0.5)) * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (int c = 0; c < 4; ++c) q[c] *= scale;
}

/// r' of exp(r) q at the angular velocity w: w - r x w / 2 + (1 - h cot h) / (4 h^2) r x (r x w), h = |r| / 2. (HLW
/// IV.7, dexp^-1; in closed form as in Bullo & Murray 1995.) Where a step turns by more than half a turn its last term
/// stays at that angle: no method follows such a step, and it vanishes about a fixed axis.
template <class V>
BALLPARK_INLINE Vector3<V> rotation_vector_rate(const Vector3<V>& r, const Vector3<V>& w) {
  constexpr Real largest = Real(2.4674011002723397L);  // (pi / 2)^2
  const V square = V(Real(0.25)) * dot(r, r), most = V(largest), u = select(square > most, most, square);
  const V last = V(Real(0.25)) * difference_series.at(u) / sine_series.at(u);
  const Vector3<V> across = cross(r, w);
  return w - V(Real(0.5)) * across + last * cross(r, across);
}

}  // namespace ballpark::BALLPARK_PRECISION
