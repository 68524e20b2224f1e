// Functions that closed forms divide by what may be zero: exact in that limit too.
#pragma once

#include <cmath>
#include <limits>

namespace ballpark::cost {

/// sum_k z^k n! / (n + k)!, for |z| of a few.
template <class R>
R tail_series(R z, int n, int stride = 1) {
  R term = 1, total = 1;
  for (int k = n; std::abs(term) > std::numeric_limits<R>::epsilon() / 8 * std::abs(total);) {
    for (int s = 0; s < stride; ++s) term /= R(++k);
    term *= z;
    total += term;
  }
  return total;
}

/// phi_1(z) = (e^z - 1)/z and phi_2(z) = (e^z - 1 - z)/z^2 (Hochbruck & Ostermann, Acta Numerica 19 (2010) 2.1).
template <class R>
R phi1(R z) {
  return z == 0 ? R(1) : std::expm1(z) / z;
}
template <class R>
R phi2(R z) {
  return std::abs(z) < 1 ? tail_series(z, 2) / 2 : (std::expm1(z) - z) / (z * z);
}

/// Stumpff's functions c_k(x) = sum_j (-x)^j / (2j + k)! (Danby, Fundamentals of Celestial Mechanics, ch. 6).
template <class R>
struct Stumpff {
  R c0, c1, c2, c3, c4;

  explicit Stumpff(R x) {
    const R s = std::sqrt(std::abs(x));
    if (std::abs(x) < 3) {  // beyond, the differences below lose no more than a bit or two
      c3 = tail_series(-x, 3, 2) / 6;
      c4 = tail_series(-x, 4, 2) / 24;
      c2 = R(0.5) - x * c4;
      c1 = 1 - x * c3;
      c0 = 1 - x * c2;
      return;
    }
    const R half = x > 0 ? std::sin(s / 2) : std::sinh(s / 2);
    c0 = x > 0 ? std::cos(s) : std::cosh(s);
    c1 = (x > 0 ? std::sin(s) : std::sinh(s)) / s;
    c2 = 2 * half * half / std::abs(x);
    c3 = (1 - c1) / x;
    c4 = (R(0.5) - c2) / x;
  }
};

}  // namespace ballpark::cost
