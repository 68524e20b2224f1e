// Floating-point numbers taken apart into integers: what the reproducible maths computes with.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace ballpark::maths {

using Word = std::uint64_t;
__extension__ typedef unsigned __int128 Wide;

/// mantissa * 2^(exponent - 63); the top bit of the mantissa is set, so 2^exponent <= value < 2^(exponent + 1).
struct Magnitude {
  Word mantissa;
  int exponent;
};

constexpr Word one = Word{1} << 63;  // as a mantissa

/// The same with 128 bits: mantissa * 2^(exponent - 127).
struct WideMagnitude {
  Wide mantissa;
  int exponent;
};

/// Zeros and infinities get exponents out of every finite number's reach, so most formulas need no case for them.
constexpr int zero_exponent = -40000;
constexpr int infinity_exponent = 20000;

struct Number {
  bool negative, zero, infinite, nan;
  Magnitude size;
};

template <class Real>
struct Format;
template <>
struct Format<float> {
  using Bits = std::uint32_t;
  static constexpr int fraction_bits = 23, bias = 127;
};
template <>
struct Format<double> {
  using Bits = std::uint64_t;
  static constexpr int fraction_bits = 52, bias = 1023;
};

constexpr Word high(Wide value) {
  return static_cast<Word>(value >> 64);
}
constexpr Wide full_product(Word a, Word b) {
  return static_cast<Wide>(a) * b;
}
constexpr Word high_product(Word a, Word b) {
  return high(full_product(a, b));
}

constexpr Wide wide(Word upper, Word lower) {
  return static_cast<Wide>(upper) << 64 | lower;
}
constexpr Wide high_product(Wide a, Wide b) {  // up to 3 units too small
  const Word low_a = static_cast<Word>(a), low_b = static_cast<Word>(b);
  return full_product(high(a), high(b)) + high_product(high(a), low_b) + high_product(low_a, high(b));
}

constexpr int leading_zeros(Wide value) {
  return high(value) != 0 ? std::countl_zero(high(value)) : 64 + std::countl_zero(static_cast<Word>(value));
}

/// The top 64 significant bits of value > 0, whose bit 127 is worth 2^top_exponent.
constexpr Magnitude leading(Wide value, int top_exponent) {
  const int zeros = leading_zeros(value);
  return {high(value << zeros), top_exponent - zeros};
}

constexpr Magnitude operator*(Magnitude a, Magnitude b) {
  return leading(full_product(a.mantissa, b.mantissa), a.exponent + b.exponent + 1);
}

constexpr Magnitude operator/(Magnitude a, Magnitude b) {
  const Wide quotient = (static_cast<Wide>(a.mantissa) << 63) / b.mantissa;
  return leading(quotient << 64, a.exponent - b.exponent);
}

/// a (1 - part / 2^64), for part below 2^63.
constexpr Magnitude reduced(Magnitude a, Word part) {
  return leading(static_cast<Wide>(a.mantissa - high_product(a.mantissa, part)) << 64, a.exponent);
}

/// value * 2^64 as an integer, for value < 1.
constexpr Word fixed_point(Magnitude value) {
  const int shift = -1 - value.exponent;
  return shift < 64 ? value.mantissa >> shift : 0;
}

/// c0 +- t c1 + t^2 c2 +- ... with t in units of 2^-64, in two interleaved chains: half the latency of one.
template <bool alternating, std::size_t n>
constexpr Word series(const std::array<Word, n>& coefficients, Word t) {
  static_assert(n % 2 == 0);
  const Word square = high_product(t, t);
  Word even = 0, odd = 0;
  for (std::size_t k = n; k > 0; k -= 2) {
    even = coefficients[k - 2] + high_product(square, even);
    odd = coefficients[k - 1] + high_product(square, odd);
  }
  odd = high_product(t, odd);
  return alternating ? even - odd : even + odd;
}

/// unit / n! for n = first, first + step, ...
template <std::size_t count>
constexpr std::array<Word, count> inverse_factorials(Wide unit, unsigned first, unsigned step) {
  std::array<Word, count> values{};
  Wide factorial = 1;
  for (unsigned n = 2; n <= first; ++n) factorial *= n;
  for (unsigned k = 0, n = first; k < count; ++k) {
    values[k] = static_cast<Word>(unit / factorial);
    for (unsigned i = 0; i < step; ++i) factorial *= ++n;
  }
  return values;
}

/// 2^64 / 3, 2^64 / 5, ...: the series of the inverse tangents.
template <std::size_t count>
constexpr std::array<Word, count> inverse_odds() {
  std::array<Word, count> values{};
  for (std::size_t k = 0; k < count; ++k) values[k] = static_cast<Word>(wide(1, 0) / (2 * k + 3));
  return values;
}

template <class Real>
constexpr Real infinity = std::numeric_limits<Real>::infinity();
template <class Real>
constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

template <class Real>
Number taken_apart(Real x) {
  using F = Format<Real>;
  constexpr Word first = Word{1} << F::fraction_bits;  // of the exponent
  constexpr Word beyond = (2 * F::bias + 1) * first;   // infinity; above it NaN
  constexpr Word sign = Word{1} << (8 * sizeof(Real) - 1);
  const Word bits = std::bit_cast<typename F::Bits>(x);
  const Word absolute = bits & ~sign;
  Number number{bits != absolute, absolute == 0, absolute == beyond, absolute > beyond, {one, zero_exponent}};
  if (absolute >= beyond) number.size.exponent = infinity_exponent;
  if (absolute == 0 || absolute >= beyond) return number;
  const bool normal = absolute >= first;
  const Word significand = normal ? absolute % first + first : absolute;
  const int zeros = std::countl_zero(significand);
  const int stored = normal ? static_cast<int>(absolute / first) : 1;
  number.size = {significand << zeros, stored - F::bias + 63 - F::fraction_bits - zeros};
  return number;
}

/// The nearest Real, ties to even; infinite or denormal where it must be.
template <class Real>
Real rounded(bool negative, Magnitude value) {
  using F = Format<Real>;
  constexpr Word first = Word{1} << F::fraction_bits;
  constexpr Word sign = Word{1} << (8 * sizeof(Real) - 1);
  const int biased = value.exponent + F::bias;
  Word bits = (2 * F::bias + 1) * first;
  if (biased <= 2 * F::bias) {
    const int dropped = 63 - F::fraction_bits + (biased > 0 ? 0 : 1 - biased);
    const Word rest = dropped > 64 ? 0 : value.mantissa << (64 - dropped);
    bits = dropped < 64 ? value.mantissa >> dropped : 0;
    bits += rest > one - bits % 2;                                  // ties to even
    if (biased > 0) bits += static_cast<Word>(biased - 1) * first;  // a carry raises the exponent, rightly
  }
  return std::bit_cast<Real>(static_cast<typename F::Bits>(negative ? bits | sign : bits));
}

}  // namespace ballpark::maths
