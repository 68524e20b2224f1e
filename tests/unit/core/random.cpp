#include "engine/core/random.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <vector>

#include "engine/core/hash.h"
#include "tests/catch.h"

namespace numbers = ballpark::random;
using numbers::Draw;
using numbers::Words;

namespace {

constexpr std::uint64_t draws = 100'000;

/// Mean of f over many draws, in standard errors from what is expected.
double surprise(double expected, double variance, const std::function<double(Draw)>& f) {
  double sum = 0;
  for (std::uint64_t i = 0; i < draws; ++i) sum += f({11, 3, i});
  return (sum / draws - expected) / std::sqrt(variance / draws);
}

}  // namespace

TEST_CASE("Philox4x32-10 gives its authors' known answers", "[random]") {
  CHECK(numbers::philox({0, 0, 0, 0}, {0, 0}) == Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
  constexpr std::uint32_t ones = 0xffffffff;
  CHECK(numbers::philox({ones, ones, ones, ones}, {ones, ones}) ==
        Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
  CHECK(numbers::philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
        Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("a draw's seed, stream and counter are Philox's key and counter", "[random]") {
  constexpr auto bits = numbers::bits({0x299f31d0a4093822, 0x0370734413198a2e, 0x85a308d3243f6a88});
  CHECK(bits[0] == 0xd16cfe0994fdcceb);
  CHECK(bits[1] == 0x5001e42024126ea1);
}

TEST_CASE("draws do not depend on their order, and differ in seed, stream and counter", "[random]") {
  std::vector<double> forwards(1000), backwards(1000);
  for (std::uint64_t i = 0; i < 1000; ++i) forwards[i] = numbers::normal({5, 6, i});
  for (std::uint64_t i = 1000; i-- > 0;) backwards[i] = numbers::normal({5, 6, i});
  CHECK(forwards == backwards);
  std::set<double> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint64_t stream = 0; stream < 20; ++stream) {
      for (std::uint64_t i = 0; i < 20; ++i) seen.insert(numbers::uniform<double>({seed, stream, i}));
    }
  }
  CHECK(seen.size() == 8000);
}

TEST_CASE("uniform numbers lie in their interval and have the moments of their law", "[random]") {
  const auto u = [](Draw draw) { return numbers::uniform<double>(draw); };
  const auto single = [](Draw draw) { return static_cast<double>(numbers::uniform<float>(draw)); };
  for (std::uint64_t i = 0; i < draws; ++i) {
    const double x = u({11, 3, i}), y = single({11, 3, i}), z = numbers::uniform({11, 3, i}, -3.0, 5.0);
    if (x < 0 || x >= 1 || y < 0 || y >= 1 || z < -3 || z > 5) FAIL(i << ": " << x << " " << y << " " << z);
  }
  CHECK(std::abs(surprise(0.5, 1 / 12.0, u)) < 4);
  CHECK(std::abs(surprise(0.5, 1 / 12.0, single)) < 4);
  CHECK(std::abs(surprise(1, 16 / 3.0, [](Draw draw) { return numbers::uniform(draw, -3.0, 5.0); })) < 4);
  CHECK(std::abs(surprise(1 / 12.0, 1 / 180.0, [&](Draw draw) { return std::pow(u(draw) - 0.5, 2); })) < 4);
  CHECK(std::abs(surprise(1 / 80.0, 1 / 3600.0, [&](Draw draw) { return std::pow(u(draw) - 0.5, 4); })) < 4);
}

TEST_CASE("uniform numbers use every bit of the mantissa", "[random]") {
  std::uint64_t ones = 0, zeros = 0;
  std::uint32_t single_ones = 0, single_zeros = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const auto bits = static_cast<std::uint64_t>(std::ldexp(numbers::uniform<double>({1, 2, i}), 53));
    const auto single = static_cast<std::uint32_t>(std::ldexp(numbers::uniform<float>({1, 2, i}), 24));
    ones |= bits, zeros |= ~bits, single_ones |= single, single_zeros |= ~single;
  }
  CHECK((ones & zeros) == (std::uint64_t{1} << 53) - 1);
  CHECK((single_ones & single_zeros) == (1u << 24) - 1);
}

TEST_CASE("an interval's ends are kept even where rounding would pass them", "[random]") {
  CHECK(numbers::uniform({1, 2, 3}, 0.25, 0.25) == 0.25);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const double upper = std::nextafter(1e16, 2e16), x = numbers::uniform({1, 2, i}, 1e16, upper);
    const bool an_end = x == 1e16 || x == upper;
    CHECK(an_end);
  }
}

TEST_CASE("neighbouring counters, streams and seeds are uncorrelated", "[random]") {
  const auto u = [](Draw draw) { return numbers::uniform<double>(draw) - 0.5; };
  constexpr double variance = 1 / 144.0;
  CHECK(std::abs(surprise(0, variance, [&](Draw d) { return u(d) * u({d.seed, d.stream, d.counter + 1}); })) < 4);
  CHECK(std::abs(surprise(0, variance, [&](Draw d) { return u(d) * u({d.seed, d.stream + 1, d.counter}); })) < 4);
  CHECK(std::abs(surprise(0, variance, [&](Draw d) { return u(d) * u({d.seed + 1, d.stream, d.counter}); })) < 4);
}

TEST_CASE("normal numbers have the moments of their law", "[random]") {
  const double moments[] = {1, 0, 1, 0, 3, 0, 15, 0, 105, 0, 945, 0, 10395};
  for (int power = 1; power <= 6; ++power) {
    CAPTURE(power);
    const double variance = moments[2 * power] - moments[power] * moments[power];
    CHECK(std::abs(surprise(moments[power], variance, [&](Draw d) { return std::pow(numbers::normal(d), power); })) <
          4);
  }
  const auto beyond = [](Draw draw) { return std::abs(numbers::normal(draw)) > 3 ? 1.0 : 0.0; };
  CHECK(std::abs(surprise(0.0026997960632602, 0.0026925, beyond)) < 4);
}

TEST_CASE("rotations are unit quaternions, uniform over all rotations", "[random]") {
  for (std::uint64_t i = 0; i < draws; ++i) {
    const auto [w, x, y, z] = numbers::rotation({11, 3, i});
    if (std::abs(w * w + x * x + y * y + z * z - 1) > 1e-15) FAIL("not a unit quaternion at " << i);
  }
  // On the unit sphere in four dimensions: <q_i q_j> = delta / 4, <q_i^4> = 1/8, <q_i^2 q_j^2> = 1/24.
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK(std::abs(surprise(0, 0.25, [&](Draw d) { return numbers::rotation(d)[i]; })) < 4);
    CHECK(std::abs(surprise(1 / 8.0, 7 / 128.0 - 1 / 64.0,
                            [&](Draw d) { return std::pow(numbers::rotation(d)[i], 4); })) < 4);
    for (std::size_t j = 0; j <= i; ++j) {
      const auto product = [&](Draw d) { return numbers::rotation(d)[i] * numbers::rotation(d)[j]; };
      CHECK(std::abs(i == j ? surprise(0.25, 1 / 16.0, product) : surprise(0, 1 / 24.0, product)) < 4);
    }
  }
}

TEST_CASE("random numbers are the same bits everywhere", "[random]") {
  std::uint64_t sum = 0;
  const auto add = [&](auto value) { sum = ballpark::combine(sum, ballpark::hash(&value, sizeof(value))); };
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const Draw draw{1, 2, i};
    add(numbers::uniform<float>(draw));
    add(numbers::uniform(draw, -1.0, 3.0));
    add(numbers::normal(draw));
    add(numbers::rotation(draw));
  }
  CHECK(sum == 0xfbaf73c7735faa5e);
}
