// Powers and waves on lanes and on plain numbers, against long double. Included once for each precision.
#pragma once

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "engine/kernels/power.h"
#include "engine/kernels/wave.h"
#include "tests/catch.h"

namespace ballpark::BALLPARK_PRECISION {

/// f on all lanes and on each number: the same bits.
template <class F>
void on_lanes(const Real (&x)[32], Real (&out)[32], F f) {
  for (std::size_t i = 0; i < 32; i += lane_count<Lanes>) store(out + i, f(load<Lanes>(x + i)));
  for (std::size_t i = 0; i < 32; ++i) {
    const Real one = f(x[i]);
    REQUIRE(std::memcmp(&one, &out[i], sizeof one) == 0);
  }
}

/// Of numbers of 2^-widest to 2^widest, and of such near 1.
inline void check_power(double widest) {
  constexpr Real p = Real(0.687);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponents(-widest, widest);
  for (int round = 0; round < 2000; ++round) {
    Real x[32], found[32];
    for (Real& value : x) value = static_cast<Real>(std::exp2(exponents(random) / (round % 2 ? 1 : 64)));
    on_lanes(x, found, [](const auto& v) { return power(v, p); });
    for (int i = 0; i < 32; ++i) {
      const long double exact = std::pow(static_cast<long double>(x[i]), static_cast<long double>(p));
      const long double roundings = 1.3L * (1 + std::abs(std::log2(static_cast<long double>(x[i]))));
      const long double error = std::abs(static_cast<long double>(found[i]) / exact - 1);
      CAPTURE(x[i], static_cast<double>(error));
      REQUIRE(error < roundings * std::numeric_limits<Real>::epsilon() / 2);
    }
  }
  CHECK(power(Real(0), p) == 0);
  CHECK(power(-Real(0), p) == 0);
  CHECK(power(std::numeric_limits<Real>::min() / 2, p) == 0);
  CHECK(power(Real(1), p) == 1);
}

inline void check_wave() {
  constexpr long double two_pi = 6.28318530717958647692528676655900577L;
  constexpr Real most = 8 * std::numeric_limits<Real>::epsilon();
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> turns(-20, 20);
  for (int round = 0; round < 2000; ++round) {
    Real x[32], sine[32], cosine[32];
    for (Real& value : x) value = static_cast<Real>(turns(random));
    on_lanes(x, sine, [](const auto& v) { return wave(v).sine; });
    on_lanes(x, cosine, [](const auto& v) { return wave(v).cosine; });
    for (int i = 0; i < 32; ++i) {
      const long double angle = two_pi * static_cast<long double>(x[i]);
      REQUIRE(std::abs(sine[i] - std::sin(angle)) < most);
      REQUIRE(std::abs(cosine[i] - std::cos(angle)) < most);
    }
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
