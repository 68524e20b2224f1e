// x^p for 0 < p < 1 and x >= 0, in arithmetic that gives the same bits on every target: x = 2^e m,
// x^p = 2^(p (e + log2 m)), both functions by their power series. The error is about 1 + |log2 x| roundings.
// x below the smallest normal number counts as 0, infinity as 2^(largest exponent + 1).
#pragma once

#include "engine/kernels/rotation_vector.h"

namespace ballpark::BALLPARK_PRECISION {

/// Unsigned integers as long as a register's lanes, or (0 bytes) as a number.
template <class T, std::size_t bytes>
struct Words {
  typedef std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t> Type __attribute__((vector_size(bytes)));
};
template <class T>
struct Words<T, 0> {
  using Type = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
};

/// The parts of a number, or of each lane of a register.
template <class T, std::size_t bytes>
struct Bits {
  using Word = typename Words<T, 0>::Type;
  using All = typename Words<T, bytes>::Type;
  static constexpr int mantissa = sizeof(T) == 4 ? 23 : 52, bias = sizeof(T) == 4 ? 127 : 1023;
  static constexpr Word one = static_cast<Word>(bias) << mantissa;
  static constexpr Word fraction = (Word(1) << mantissa) - 1;
  static constexpr Word integers = static_cast<Word>(bias + mantissa) << mantissa;  ///< + n: the number 2^mantissa + n

  /// Of x = 2^e m, 1 <= m < 2: e + 2^mantissa + bias.
  template <class Register>
  BALLPARK_INLINE static Register shifted_exponent(const Register& x) {
    return __builtin_bit_cast(Register, (__builtin_bit_cast(All, x) >> mantissa) | integers);
  }
  template <class Register>
  BALLPARK_INLINE static Register significand(const Register& x) {
    return __builtin_bit_cast(Register, (__builtin_bit_cast(All, x) & fraction) | one);
  }
  /// 2^n from n + 1.5 2^mantissa, whose last bits are those of n.
  template <class Register>
  BALLPARK_INLINE static Register power_of_two(const Register& shifted) {
    return __builtin_bit_cast(Register, (__builtin_bit_cast(All, shifted) << mantissa) + one);
  }
};

/// f(Bits, register) on each register of x.
template <class V, class F>
BALLPARK_INLINE V by_register(V x, F f) {
  if constexpr (std::is_same_v<V, Real>) {
    return f(Bits<Real, 0>{}, x);
  } else {
    for (auto& part : x.part) part = f(Bits<Real, sizeof part>{}, part);
    return x;
  }
}

/// sum of c_k u^k.
template <int terms>
struct PowerSeries {
  Real c[terms];

  template <class V>
  BALLPARK_INLINE V at(const V& u) const {
    V sum = V(c[terms - 1]);
    for (int k = terms - 2; k >= 0; --k) sum = V(c[k]) + u * sum;
    return sum;
  }
};

/// log2 of (1 + s) / (1 - s) is s times this of s^2, for s^2 up to 0.0295.
constexpr auto logarithm_series() {
  constexpr int terms = sizeof(Real) == 4 ? 6 : 12;
  PowerSeries<terms> series{};
  for (int k = 0; k < terms; ++k) {
    series.c[k] = static_cast<Real>(2.88539008177792681471984936200378427L / (2 * k + 1));  // 2 / ln 2
  }
  return series;
}
/// 2^f for |f| up to a half.
constexpr auto power_of_two_series() {
  constexpr int terms = sizeof(Real) == 4 ? 9 : 15;
  PowerSeries<terms> series{};
  long double c = 1;
  for (int k = 0; k < terms; ++k) {
    series.c[k] = static_cast<Real>(c);
    c *= 0.693147180559945309417232121458176568L / (k + 1);
  }
  return series;
}

template <class V>
BALLPARK_INLINE V power(const V& x, Real p) {
  if constexpr (std::is_same_v<V, long double>) {
    return x > 0 ? __builtin_powl(x, p) : 0;
  } else {
    constexpr bool narrow = sizeof(Real) == 4;
    constexpr Real least = narrow ? Real(0x1p-126) : Real(0x1p-1022), root_two = Real(1.41421356237309504880L);
    constexpr Real bias = narrow ? Real(0x1p23) + 127 : Real(0x1p52) + 1023;
    constexpr Real shift = narrow ? Real(0x1.8p23) : Real(0x1.8p52);
    const V one = V(Real(1)), half = V(Real(0.5));
    const V low = by_register(x, [](auto bits, const auto& r) BALLPARK_INLINE_LAMBDA { return bits.significand(r); });
    const V e =
        by_register(x, [](auto bits, const auto& r) BALLPARK_INLINE_LAMBDA { return bits.shifted_exponent(r); }) -
        V(bias);
    const auto high = low > V(root_two);
    const V m = select(high, half * low, low), s = (m - one) / (m + one);
    const V whole = V(p) * select(high, e + one, e);
    constexpr auto logarithm = logarithm_series();
    constexpr auto exponential = power_of_two_series();
    const V part = V(p) * (s * logarithm.at(s * s));
    const V shifted = (whole + part) + V(shift), n = shifted - V(shift);
    const V scale =
        by_register(shifted, [](auto bits, const auto& r) BALLPARK_INLINE_LAMBDA { return bits.power_of_two(r); });
    const V result = scale * exponential.at((whole - n) + part);
    return select(V(least) > x, V(Real(0)), result);
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
