// Integer arithmetic throughout: no FMA, flush mode or compiler can change a bit. SLEEF 3.5.1 (its cinz functions)
// holds its bits too, but Debian has it as a shared library only: one more run-time dependency for all who link ours.
#include "engine/core/maths.h"

#include <cmath>

#include "engine/core/magnitude.h"

namespace ballpark::maths {
namespace {

constexpr WideMagnitude log2_of_e{wide(0xb8aa3b295c17f0bb, 0xbe87fed0691d3e88), 0};
constexpr Magnitude log_of_2{0xb17217f7d1cf79ab, -1};

/// 2^(+-factor * logarithm)
inline Magnitude power_of_two(bool negative, Magnitude factor, WideMagnitude logarithm) {
  static constexpr auto coefficients = inverse_factorials<20>(one, 0, 1);
  const int exponent = factor.exponent + logarithm.exponent;
  if (exponent > 10) return {one, negative ? zero_exponent : infinity_exponent};
  const Wide product = full_product(factor.mantissa, high(logarithm.mantissa)) +
                       high_product(factor.mantissa, static_cast<Word>(logarithm.mantissa));
  const int shift = 62 - exponent;
  Wide fixed = shift < 128 ? product >> shift : 0;  // in units of 2^-64
  if (negative) fixed = -fixed;
  const Word x = high_product(static_cast<Word>(fixed), log_of_2.mantissa);
  return {series<false>(coefficients, x), static_cast<int>(high(fixed))};
}

/// s (1 + s^2/3 + s^4/5 + ...) for s = numerator / denominator < 0.172, to 2^-67 of itself.
inline WideMagnitude inverse_hyperbolic_tangent(Word numerator, Word denominator) {
  static constexpr auto coefficients = inverse_odds<14>();
  const int up = std::countl_zero(numerator), down = std::countl_zero(denominator);
  const Wide dividend = static_cast<Wide>(numerator << up) << 62;
  const Word divisor = denominator << down;
  const Word upper = static_cast<Word>(dividend / divisor);
  const Wide rest = wide(static_cast<Word>(dividend % divisor), 0);
  const Wide s = wide(upper, static_cast<Word>(rest / divisor));
  const int exponent = 1 + down - up;
  const Word x = static_cast<Word>(s >> (61 - exponent));  // in units of 2^-66, its square of 2^-68: pow needs the bits
  const Word square = high_product(x, x);
  const Word part = high_product(square, series<false>(coefficients, square >> 4));
  return {s + (full_product(upper, part) >> 4), exponent};
}

struct Logarithm {
  bool negative;
  WideMagnitude size;
};

/// whole +- fraction, not zero
Logarithm sum(int whole, bool minus, WideMagnitude fraction) {
  constexpr int top = 11;  // whole < 2^11
  const int shift = top - fraction.exponent;
  const Wide part = shift < 128 ? fraction.mantissa >> shift : 0;
  const bool negative = whole < 0;
  const Wide size = wide(static_cast<Word>(negative ? -whole : whole) << (63 - top), 0);
  return {negative, {negative == minus ? size + part : size - part, top}};
}

/// log2 x, to 2^-67; of itself where it is small.
Logarithm binary_logarithm(Magnitude x) {
  constexpr Word root_two = 0xb504f333f9de6484;
  const bool below = x.mantissa > root_two;  // x = 2^whole m with m from sqrt(1/2) to sqrt(2)
  const int whole = x.exponent + below;
  const Word m = x.mantissa >> (below ? 2 : 1);  // exact: arguments have at most 53 bits
  Logarithm result{below, {0, 0}};
  if (m != one / 2) {
    result.size = inverse_hyperbolic_tangent(below ? one / 2 - m : m - one / 2, one / 2 + m);
    result.size.mantissa = high_product(result.size.mantissa, log2_of_e.mantissa);
    result.size.exponent += 2;
  }
  if (whole != 0) result = sum(whole, below, result.size);
  if (result.size.mantissa == 0) return result;
  const int zeros = leading_zeros(result.size.mantissa);
  return {result.negative, {result.size.mantissa << zeros, result.size.exponent - zeros}};
}

template <class Real>
Real exponential(Real x) {
  const Number number = taken_apart(x);
  if (number.nan) return not_a_number<Real>;
  return rounded<Real>(false, power_of_two(number.negative, number.size, log2_of_e));
}

template <class Real>
Real natural_logarithm(Real x) {
  const Number number = taken_apart(x);
  if (number.zero) return -infinity<Real>;
  if (number.nan || number.negative) return not_a_number<Real>;
  if (number.infinite) return x;
  const Logarithm logarithm = binary_logarithm(number.size);
  if (logarithm.size.mantissa == 0) return 0;
  return rounded<Real>(logarithm.negative,
                       Magnitude{high(logarithm.size.mantissa), logarithm.size.exponent} * log_of_2);
}

bool is_integer(Magnitude x) {
  return x.exponent >= 63 || (x.exponent >= 0 && x.mantissa << (x.exponent + 1) == 0);
}
bool is_odd(Magnitude x) {
  return is_integer(x) && x.exponent < 64 && (x.mantissa >> (63 - x.exponent) & 1) != 0;
}

template <class Real>
bool is_one(Real x) {
  return std::bit_cast<typename Format<Real>::Bits>(x) == std::bit_cast<typename Format<Real>::Bits>(Real(1));
}

template <class Real>
Real power(Real x, Real y) {
  const Number base = taken_apart(x), exponent = taken_apart(y);
  if (exponent.zero || is_one(x)) return 1;
  if (base.nan || exponent.nan) return not_a_number<Real>;
  const bool negative = base.negative && is_odd(exponent.size);
  if (base.zero || base.infinite) {
    const Real size = base.zero == exponent.negative ? infinity<Real> : Real(0);
    return negative ? -size : size;
  }
  if (base.negative && !is_integer(exponent.size)) return not_a_number<Real>;
  const Logarithm logarithm = binary_logarithm(base.size);
  if (logarithm.size.mantissa == 0) return Real(negative ? -1 : 1);
  return rounded<Real>(negative, power_of_two(logarithm.negative != exponent.negative, exponent.size, logarithm.size));
}

template <class Real>
Real cube_root(Real x) {
  const Number number = taken_apart(x);
  if (number.nan) return not_a_number<Real>;
  if (number.zero || number.infinite) return x;
  Logarithm third = binary_logarithm(number.size);
  third.size.mantissa /= 3;
  return rounded<Real>(number.negative, power_of_two(third.negative, {one, 0}, third.size));
}

}  // namespace

float exp(float x) {
  return exponential(x);
}
double exp(double x) {
  return exponential(x);
}
long double exp(long double x) {
  return std::exp(x);
}

float log(float x) {
  return natural_logarithm(x);
}
double log(double x) {
  return natural_logarithm(x);
}
long double log(long double x) {
  return std::log(x);
}

float pow(float x, float y) {
  return power(x, y);
}
double pow(double x, double y) {
  return power(x, y);
}
long double pow(long double x, long double y) {
  return std::pow(x, y);
}

float cbrt(float x) {
  return cube_root(x);
}
double cbrt(double x) {
  return cube_root(x);
}
long double cbrt(long double x) {
  return std::cbrt(x);
}

}  // namespace ballpark::maths
