// Elliptic integrals and Jacobi's functions in any precision.
// A&S: Abramowitz & Stegun, Handbook of Mathematical Functions. DLMF: dlmf.nist.gov; its 19.36 is after Carlson,
// Numerical computation of real or complex elliptic integrals, Numer. Algorithms 10 (1995) 13.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace ballpark::cost {

/// Halvings until the series of RF and RJ, whose first term left out is of sixth order, is exact to rounding.
template <class R>
R carlson_limit() {
  return std::pow(std::numeric_limits<R>::epsilon() / 4, R(1) / 6);
}

/// RF(x, y, z) = 1/2 int_0^oo dt / sqrt((t + x)(t + y)(t + z)), at most one argument zero. DLMF 19.36.1.
template <class R>
R carlson_rf(R x, R y, R z) {
  const R start = (x + y + z) / 3, dx = start - x, dy = start - y;
  const R spread = std::max({std::abs(dx), std::abs(dy), std::abs(start - z)}) / carlson_limit<R>();
  R mean = start, scale = 1;
  for (; mean > 0 && spread * scale >= mean; scale /= 4) {
    const R rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z), lambda = rx * (ry + rz) + ry * rz;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    mean = (mean + lambda) / 4;
  }
  const R a = dx * scale / mean, b = dy * scale / mean, c = -a - b;
  const R e2 = a * b - c * c, e3 = a * b * c;
  return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(mean);
}

/// RC(1, 1 + e) for e > -1. DLMF 19.2.18, 19.2.19.
template <class R>
R carlson_rc(R e) {
  if (e == 0) return 1;
  const R root = std::sqrt(std::abs(e));
  return (e > 0 ? std::atan(root) : std::atanh(root)) / root;
}

/// RJ(x, y, z, p) = 3/2 int_0^oo dt / (sqrt((t + x)(t + y)(t + z)) (t + p)), p > 0. DLMF 19.36.2 and Carlson 1995, (2).
template <class R>
R carlson_rj(R x, R y, R z, R p) {
  const R start = (x + y + z + 2 * p) / 5, dx = start - x, dy = start - y, dz = start - z;
  const R spread = std::max({std::abs(dx), std::abs(dy), std::abs(dz), std::abs(start - p)}) / carlson_limit<R>();
  R mean = start, scale = 1, delta = (p - x) * (p - y) * (p - z), total = 0;
  for (; mean > 0 && spread * scale >= mean; scale /= 4, delta /= 64) {
    const R rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z), rp = std::sqrt(p);
    const R lambda = rx * (ry + rz) + ry * rz, d = (rp + rx) * (rp + ry) * (rp + rz);
    total += scale / d * carlson_rc(delta / (d * d));
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    p = (p + lambda) / 4;
    mean = (mean + lambda) / 4;
  }
  const R a = dx * scale / mean, b = dy * scale / mean, c = dz * scale / mean, q = -(a + b + c) / 2;
  const R abc = a * b * c, e2 = a * b + a * c + b * c - 3 * q * q, e3 = abc + 2 * e2 * q + 4 * q * q * q;
  const R e4 = (2 * abc + e2 * q + 3 * q * q * q) * q, e5 = abc * q * q;
  const R series = 1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26;
  return scale * series / (mean * std::sqrt(mean)) + 6 * total;
}

/// Jacobi's functions of one parameter 0 <= m <= 1. Its complement is given too: near 1 it cannot be had from m.
template <class R>
class Elliptic {
 public:
  struct Values {
    R sn, cn, dn, amplitude;  ///< the amplitude without jumps
  };

  Elliptic() : Elliptic(0, 1) {}
  /// Arithmetic-geometric mean, A&S 17.6.
  Elliptic(R m, R complement) : m_(m), m1_(complement) {
    R b = std::sqrt(m1_), c = std::sqrt(m_);
    mean_ = 1;
    while (m1_ > 0 && std::abs(c) > std::numeric_limits<R>::epsilon() / 4 * mean_) {
      const R next = (mean_ + b) / 2;
      b = std::sqrt(mean_ * b);
      c = c * c / (4 * next);  // (a - b)/2 without cancellation
      mean_ = next;
      ratios_[levels_++] = c / next;
    }
  }

  R m() const { return m_; }
  R complement() const { return m1_; }
  /// K, a quarter of the period. A&S 17.6.3.
  R quarter() const { return m1_ > 0 ? std::numbers::pi_v<R> / (2 * mean_) : std::numeric_limits<R>::infinity(); }

  /// Descending Landen transformation, A&S 16.4; m = 1: A&S 16.6.
  Values at(R u) const {
    R phi = m1_ > 0 ? std::ldexp(mean_ * u, levels_) : 2 * std::atan(std::tanh(u / 2));
    for (int n = levels_; n-- > 0;) phi = (phi + std::asin(ratios_[n] * std::sin(phi))) / 2;
    const R cn = m1_ > 0 ? std::cos(phi) : 1 / std::cosh(u);
    return {m1_ > 0 ? std::sin(phi) : std::tanh(u), cn, std::sqrt(m1_ + m_ * cn * cn), phi};
  }

  /// u in [-2K, 2K] of given sn and cn. DLMF 19.25.5.
  R argument(R sn, R cn) const {
    const R near = sn * carlson_rf(cn * cn, m1_ + m_ * cn * cn, R(1));
    return cn >= 0 ? near : std::copysign(2 * quarter(), sn) - near;
  }

  /// int_0^u dv / (p cn^2 v + q sn^2 v), p, q > 0, for m < 1. All terms are of one sign: where q > p the argument is
  /// shifted by K, sn(v) = -cd(v + K) (A&S 16.8), which makes the characteristic positive.
  R third_kind(R p, R q, R u) const {
    if (q <= p) return pi(q / p, u) / p;
    const R less = 1 - p / q, nc = m1_ * p / q, n = m_ + m1_ * less;
    const R moved = pi(nc, u + quarter()) - complete_pi(nc);
    return (m_ / n * u + m1_ * less / n * moved) / q;
  }

 private:
  /// Pi(n; u) = int_0^u dv / (1 - n sn^2 v), n = 1 - nc in [0, 1), whole periods apart. DLMF 19.25.14.
  R pi(R nc, R u) const {
    const R periods = std::nearbyint(u / (2 * quarter()));
    const Values v = at(u - periods * 2 * quarter());
    const R c = v.cn * v.cn, s = v.sn * v.sn, d = m1_ + m_ * c;
    const R part = v.sn * (carlson_rf(c, d, R(1)) + (1 - nc) / 3 * s * carlson_rj(c, d, R(1), c + nc * s));
    return 2 * periods * complete_pi(nc) + part;
  }
  R complete_pi(R nc) const { return quarter() + (1 - nc) / 3 * carlson_rj(R(0), m1_, R(1), nc); }

  R m_, m1_, mean_ = 1;
  int levels_ = 0;
  std::array<R, 24> ratios_{};  ///< c_n / a_n; they square: a dozen reach any exponent
};

}  // namespace ballpark::cost
