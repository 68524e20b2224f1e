#include "perf/cost/statistics.h"

#include <cmath>
#include <limits>

namespace ballpark::cost {

namespace {

/// The continued fraction of the incomplete beta function (DLMF 8.17.22), by Lentz's method as modified by Thompson
/// and Barnett (1986, J. Comput. Phys. 64, 490). It converges fast for x < (a + 1) / (a + b + 2).
double beta_fraction(double x, double a, double b) {
  constexpr double tiny = 1e-300;
  constexpr int most_terms = 1000;
  const auto not_zero = [](double v) { return std::abs(v) < tiny ? tiny : v; };
  double c = 1, d = 1 / not_zero(1 - (a + b) * x / (a + 1)), fraction = d;
  for (int m = 1; m < most_terms; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    double change = 1;
    for (const double term : {even, odd}) {
      d = 1 / not_zero(1 + term * d);
      c = not_zero(1 + term / c);
      change = c * d;
      fraction *= change;
    }
    if (std::abs(change - 1) < std::numeric_limits<double>::epsilon()) break;
  }
  return fraction;
}

/// The regularised incomplete beta function (DLMF 8.17.2, 8.17.4).
double incomplete_beta(double x, double a, double b) {
  if (x <= 0) return 0;
  if (x > (a + 1) / (a + b + 2)) return 1 - incomplete_beta(1 - x, b, a);
  const double logarithm = std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x);
  return std::exp(logarithm) * beta_fraction(x, a, b) / a;
}

}  // namespace

/// Abramowitz & Stegun 26.7.1 and 26.5.27.
double student_tails(double t, double freedom) {
  if (std::isinf(t)) return 0;
  return incomplete_beta(freedom / (freedom + t * t), freedom / 2, 0.5);
}

double student_quantile(double probability, double freedom) {
  const double tails = 2 * (1 - probability);
  double low = 0, high = 1;
  while (student_tails(high, freedom) > tails) high *= 2;
  for (int halving = 0; halving < 200 && low < high; ++halving) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (student_tails(middle, freedom) > tails ? low : high) = middle;
  }
  return high;
}

Mean mean_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  Mean mean{0, 0, static_cast<int>(values.size())};
  for (const double value : values) mean.value += value / n;
  double squares = 0;
  for (const double value : values) squares += (value - mean.value) * (value - mean.value);
  if (values.size() > 1) mean.error = std::sqrt(squares / (n - 1) / n);
  return mean;
}

double Mean::margin() const {
  return count > 1 && error > 0 ? student_quantile(0.975, count - 1) * error : 0;
}

Difference difference_of(const Mean& a, const Mean& b) {
  const double va = a.error * a.error, vb = b.error * b.error;
  Difference difference{a.value - b.value, std::sqrt(va + vb), 1};
  if (difference.value == 0) return difference;
  // Degrees of freedom by Welch and Satterthwaite (1946, Biometrics Bulletin 2, 110).
  const double share = va + vb > 0 ? va / (va + vb) : 0.5;
  const double freedom = 1 / (share * share / (a.count - 1) + (1 - share) * (1 - share) / (b.count - 1));
  difference.chance = student_tails(difference.sigmas(), freedom);
  return difference;
}

double Difference::sigmas() const {
  return value == 0 ? 0 : std::abs(value) / error;
}

}  // namespace ballpark::cost
