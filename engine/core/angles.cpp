// sin, cos, acos, atan2 on integers (see maths.cpp).
#include <cmath>

#include "engine/core/magnitude.h"
#include "engine/core/maths.h"

namespace ballpark::maths {
namespace {

constexpr Magnitude half_pi{0xc90fdaa22168c234, 0};

/// 128 zeros, then the binary digits of 2 / pi: enough for the largest double.
constexpr std::array<Word, 20> two_over_pi = {
    0x0000000000000000, 0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041,
    0xfe5163abdebbc561, 0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484,
    0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f,
    0x6d367ecf27cb09b7, 0x4f463f669e5fea2d, 0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08};

/// x = quadrant pi/2 + angle, with angle below zero if `before`, and at most pi/4 in size.
struct Turn {
  unsigned quadrant;
  bool before;
  Magnitude angle;
};

/// Payne and Hanek: of x * 2/pi only the digits between the multiples of four and what rounding drops are formed.
inline Turn quarter_turns(Magnitude x) {
  if (x.exponent < -32) return {0, false, x};
  const int first = x.exponent + 63;  // the digit that, times the mantissa's unit, is worth 2
  const auto digits = [&](int word) {
    const auto at = static_cast<std::size_t>(first / 64 + word);
    return static_cast<Word>(wide(two_over_pi[at], two_over_pi[at + 1]) >> (64 - first % 64));
  };
  const Wide middle = full_product(x.mantissa, digits(1)) + high_product(x.mantissa, digits(2));
  const Wide turns = (full_product(x.mantissa, digits(0)) << 64) + middle;  // modulo 4, in units of 2^-126
  Wide fraction = turns << 2;
  const bool before = high(fraction) >> 63 != 0;
  if (before) fraction = -fraction;
  return {static_cast<unsigned>(turns >> 126) + before, before, leading(fraction, -1) * half_pi};
}

inline Magnitude sine(Magnitude angle) {
  static constexpr auto coefficients = inverse_factorials<10>(wide(1, 0), 3, 2);
  const Word x = fixed_point(angle), t = high_product(x, x);
  return reduced(angle, high_product(t, series<true>(coefficients, t)));
}

inline Magnitude cosine(Magnitude angle) {
  static constexpr auto coefficients = inverse_factorials<10>(wide(1, 0), 2, 2);
  const Word x = fixed_point(angle), t = high_product(x, x);
  const Word lack = high_product(t, series<true>(coefficients, t));
  return lack == 0 ? Magnitude{one, 0} : Magnitude{-lack, -1};
}

/// sin(x + ahead pi/2)
template <class Real>
Real circular(Real x, unsigned ahead) {
  const Number number = taken_apart(x);
  if (number.nan || number.infinite) return not_a_number<Real>;
  const Turn turn = quarter_turns(number.size);
  const unsigned quadrant = turn.quadrant + ahead;
  const bool odd = quadrant % 2 != 0;
  bool negative = quadrant % 4 > 1;
  if (ahead == 0) negative ^= number.negative;
  if (!odd) negative ^= turn.before;
  return rounded<Real>(negative, odd ? cosine(turn.angle) : sine(turn.angle));
}

constexpr int angle_top = 7;  // angles as Wide in units of 2^-120
constexpr Wide quarter_turn = wide(0x01921fb54442d184, 0x69898cc51701b839);

/// atan(j / 8) in units of 2^-64
constexpr std::array<Word, 9> arctangent_of_eighths = {0x0000000000000000, 0x1fd5ba9aac2f6dc6, 0x3eb6ebf25901bac5,
                                                       0x5bd86507937bc239, 0x76b19c1586ed3da2, 0x8f005d5ef7f59f9b,
                                                       0xa4bc7d1934f70924, 0xb8053e2bc2319e73, 0xc90fdaa22168c234};

/// atan(s) for s <= 1/8
inline Magnitude small_arctangent(Magnitude s) {
  static constexpr auto coefficients = inverse_odds<8>();
  const Word x = fixed_point(s), t = high_product(x, x);
  return reduced(s, high_product(t, series<true>(coefficients, t)));
}

/// base +- size, all in units of 2^-120
Wide moved(Wide base, bool back, Magnitude size) {
  const int shift = angle_top - 64 - size.exponent;
  const Wide change = shift < 0 ? static_cast<Wide>(size.mantissa) << -shift : shift < 64 ? size.mantissa >> shift : 0;
  return back ? base - change : base + change;
}

/// The angle in [0, pi] of the point (+-x, y).
Magnitude direction(Magnitude y, Magnitude x, bool x_negative) {
  const bool steep = y.exponent > x.exponent || (y.exponent == x.exponent && y.mantissa > x.mantissa);
  const Magnitude near = steep ? x : y, far = steep ? y : x;
  const int gap = far.exponent - near.exponent;
  Magnitude ratio{};
  Wide base = 0;
  bool back = false;
  if (gap > 4) {
    ratio = near / far;
  } else {
    const Word eighths = ((near.mantissa >> gap >> 4) / (far.mantissa >> 8) + 1) / 2;
    const Wide n = static_cast<Wide>(near.mantissa) << (56 - gap), f = static_cast<Wide>(far.mantissa) << 56;
    back = 8 * n < eighths * f;
    const Wide numerator = back ? eighths * f - 8 * n : 8 * n - eighths * f;
    ratio = numerator == 0 ? Magnitude{one, zero_exponent} : leading(numerator, 0) / leading(8 * f + eighths * n, 0);
    base = static_cast<Wide>(arctangent_of_eighths[eighths]) << 56;
  }
  const Magnitude part = small_arctangent(ratio);
  if (base == 0 && !steep && !x_negative) return part;
  Wide angle = moved(base, back, part);
  if (steep) angle = quarter_turn - angle;
  if (x_negative) angle = 2 * quarter_turn - angle;
  return leading(angle, angle_top);
}

template <class Real>
Real angle_of(Real y, Real x) {
  const Number height = taken_apart(y);
  Number width = taken_apart(x);
  if (height.nan || width.nan) return not_a_number<Real>;
  if (width.zero) width.size.exponent /= 2;  // so that atan2(0, 0) is 0, as C wants
  return rounded<Real>(height.negative, direction(height.size, width.size, width.negative));
}

/// sqrt(1 - x^2) for x <= 1. The first guess is all the floating-point work in this file.
Magnitude circle_height(Magnitude x) {
  constexpr Word unit = one / 2;
  const Word fixed = x.exponent == 0 ? unit : fixed_point(x) >> 2;
  const Wide square = full_product(unit - fixed, unit + fixed);
  if (square == 0) return {one, zero_exponent};
  const int up = (leading_zeros(square) & ~1) - 2;
  const Wide scaled = square << up;  // in [2^124, 2^126)
  const Word guess = static_cast<Word>(std::sqrt(static_cast<double>(high(scaled))) * 4294967296.0);
  const Word root = static_cast<Word>((scaled / guess + guess) / 2);
  return leading(static_cast<Wide>(root) << 64, 1 - up / 2);
}

template <class Real>
Real arc_cosine(Real x) {
  const Number number = taken_apart(x);
  const bool beyond = number.size.exponent > 0 || (number.size.exponent == 0 && number.size.mantissa << 1 != 0);
  if (number.nan || beyond) return not_a_number<Real>;
  return rounded<Real>(false, direction(circle_height(number.size), number.size, number.negative));
}

}  // namespace

float sin(float x) {
  return circular(x, 0);
}
double sin(double x) {
  return circular(x, 0);
}
long double sin(long double x) {
  return std::sin(x);
}

float cos(float x) {
  return circular(x, 1);
}
double cos(double x) {
  return circular(x, 1);
}
long double cos(long double x) {
  return std::cos(x);
}

float acos(float x) {
  return arc_cosine(x);
}
double acos(double x) {
  return arc_cosine(x);
}
long double acos(long double x) {
  return std::acos(x);
}

float atan2(float y, float x) {
  return angle_of(y, x);
}
double atan2(double y, double x) {
  return angle_of(y, x);
}
long double atan2(long double y, long double x) {
  return std::atan2(y, x);
}

}  // namespace ballpark::maths
