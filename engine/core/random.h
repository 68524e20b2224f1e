// Random numbers without state: each is a function of (seed, stream, counter) alone, so neither order nor threads
// matter. Use a stream for each purpose and a counter for each body; one draw serves one call.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "engine/core/maths.h"

namespace ballpark::random {

struct Draw {
  std::uint64_t seed, stream, counter;
};

using Words = std::array<std::uint32_t, 4>;

/// Philox4x32-10 (Salmon, Moraes, Dror and Shaw, Parallel random numbers: as easy as 1, 2, 3, 2011).
constexpr Words philox(Words counter, std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

/// 128 random bits, as two halves.
constexpr std::array<std::uint64_t, 2> bits(Draw draw) {
  const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); };
  const Words words = philox({low(draw.counter), high(draw.counter), low(draw.stream), high(draw.stream)},
                             {low(draw.seed), high(draw.seed)});
  return {std::uint64_t{words[0]} << 32 | words[1], std::uint64_t{words[2]} << 32 | words[3]};
}

/// The top `count` bits as a number in [0, 1); exact for up to 53.
template <int count>
constexpr double fraction(std::uint64_t word) {
  return static_cast<double>(word >> (64 - count)) / static_cast<double>(std::uint64_t{1} << count);
}

/// Uniform in [0, 1), with all bits of Real's mantissa.
template <class Real>
constexpr Real uniform(Draw draw) {
  static_assert(std::is_same_v<Real, float> || std::is_same_v<Real, double>);
  return static_cast<Real>(fraction < std::is_same_v<Real, float> ? 24 : 53 > (bits(draw)[0]));
}

/// Uniform in [lower, upper].
template <class Real>
constexpr Real uniform(Draw draw, Real lower, Real upper) {
  return std::min(upper, lower + (upper - lower) * uniform<Real>(draw));
}

/// A unit quaternion (w, x, y, z), uniform over all rotations (Shoemake, Graphics Gems III, 1992).
inline std::array<double, 4> rotation(Draw draw) {
  constexpr double two_pi = 6.283185307179586;
  const auto [a, b] = bits(draw);
  const double share = fraction<42>(a), first = two_pi * fraction<42>(b);
  const double second = two_pi * fraction<42>(a << 42 | (b & 0x3FFFFF) << 20);  // the bits that are left
  const double outer = std::sqrt(1 - share), inner = std::sqrt(share);
  return {inner * maths::cos(second), outer * maths::sin(first), outer * maths::cos(first), inner * maths::sin(second)};
}

/// Standard normal, up to 8.6 (Box and Muller 1958).
inline double normal(Draw draw) {
  constexpr double two_pi = 6.283185307179586;
  const auto [a, b] = bits(draw);
  return std::sqrt(-2 * maths::log(1 - fraction<53>(a))) * maths::cos(two_pi * fraction<53>(b));
}

}  // namespace ballpark::random
