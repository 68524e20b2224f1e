#include "engine/core/maths.h"

#if __has_include(<mpfr.h>)
#include <mpfr.h>
#define WITH_MPFR
#endif

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/core/flush_denormals.h"
#include "engine/core/hash.h"
#include "engine/core/random.h"
#include "tests/catch.h"

namespace maths = ballpark::maths;
namespace numbers = ballpark::random;

namespace {

template <class Real>
struct Function {
  std::string name;
  Real (*one)(Real);        // either this
  Real (*two)(Real, Real);  // or that
  Real lower, upper;        // an interval worth a dense look
  std::uint64_t golden;     // hash of the results for `points`
  Real operator()(Real x, Real y) const { return one ? one(x) : two(x, y); }
};

template <class Real>
std::vector<Function<Real>> functions() {
  constexpr bool single = std::is_same_v<Real, float>;
  const auto golden = [](std::uint64_t of_float, std::uint64_t of_double) { return single ? of_float : of_double; };
  const Real range = single ? 105 : 750;
  return {{"sin", maths::sin, nullptr, -20, 20, golden(0x42ffe607024db033, 0x362c3b2a8b84477e)},
          {"cos", maths::cos, nullptr, -20, 20, golden(0xb87a60bbe1d6df21, 0x301a8dd55d241ae)},
          {"exp", maths::exp, nullptr, -range, range, golden(0x3b35a99786253968, 0x37d7c95e87d1294e)},
          {"log", maths::log, nullptr, 0, 3, golden(0xaa781b89d00063fa, 0xc7f8dd0a5e2e9b93)},
          {"cbrt", maths::cbrt, nullptr, -9, 9, golden(0x31e8ab22ddf8e913, 0x4eedf1cbb9d4aa6)},
          {"acos", maths::acos, nullptr, -1, 1, golden(0x9dca0497cb3e40b4, 0x493e9d4317f51929)},
          {"pow", nullptr, maths::pow, 0, 40, golden(0x5a758d27eb09ea71, 0x898c5dca696747e3)},
          {"atan2", nullptr, maths::atan2, -1, 1, golden(0x4f120cb71c9b7b60, 0x2c110ae57b4953a7)}};
}

template <class Real>
struct Point {
  Real x, y;
};

/// Half of them random bits (all magnitudes, infinities, NaN), half from the function's interval.
template <class Real>
std::vector<Point<Real>> points(const Function<Real>& function, std::uint64_t count) {
  using Bits = std::conditional_t<std::is_same_v<Real, float>, std::uint32_t, std::uint64_t>;
  std::vector<Point<Real>> result;
  for (std::uint64_t i = 0; i < count / 2; ++i) {
    const auto bits = numbers::bits({1, 0, i});
    result.push_back(
        {std::bit_cast<Real>(static_cast<Bits>(bits[0])), std::bit_cast<Real>(static_cast<Bits>(bits[1]))});
    result.push_back({numbers::uniform({1, 1, i}, function.lower, function.upper),
                      numbers::uniform({1, 2, i}, function.lower, function.upper)});
  }
  return result;
}

template <class Real>
std::uint64_t hash_of_results(const Function<Real>& function) {
  std::vector<Real> results;
  for (const auto& [x, y] : points(function, 100'000)) results.push_back(function(x, y));
  return ballpark::hash(results.data(), results.size() * sizeof(Real));
}

template <class Real>
bool same(Real a, Real b) {
  return std::memcmp(&a, &b, sizeof(Real)) == 0;
}

}  // namespace

TEMPLATE_TEST_CASE("maths gives the same bits for every compiler, flag and processor", "[maths]", float, double) {
  for (const auto& function : functions<TestType>()) {
    CAPTURE(function.name);
    CHECK(hash_of_results(function) == function.golden);
  }
}

TEMPLATE_TEST_CASE("maths gives the same bits while denormals are flushed", "[maths]", float, double) {
  const ballpark::FlushDenormals flush;
  for (const auto& function : functions<TestType>()) {
    CAPTURE(function.name);
    CHECK(hash_of_results(function) == function.golden);
  }
}

TEMPLATE_TEST_CASE("maths gives C's special values", "[maths]", float, double) {
  using Real = TestType;
  using Limits = std::numeric_limits<Real>;
  const Real inf = Limits::infinity(), nan = Limits::quiet_NaN(), least = Limits::denorm_min(), most = Limits::max();
  const Real pi = static_cast<Real>(3.14159265358979323846L), zero = 0;
  for (const Real x : {nan, -nan, inf, -inf}) CHECK((same(maths::sin(x), nan) && same(maths::cos(x), nan)));
  for (const Real x : {zero, -zero, least, -least}) {
    CHECK((same(maths::sin(x), x) && same(maths::cos(x), Real(1)) && same(maths::exp(x), Real(1))));
  }
  CHECK((same(maths::exp(-nan), nan) && maths::exp(inf) == inf && same(maths::exp(-inf), zero)));
  CHECK((maths::exp(most) == inf && same(maths::exp(-most), zero)));
  CHECK((same(maths::log(-nan), nan) && same(maths::log(Real(-1)), nan) && same(maths::log(-inf), nan)));
  CHECK((maths::log(inf) == inf && maths::log(zero) == -inf && maths::log(-zero) == -inf));
  CHECK(same(maths::log(Real(1)), zero));
  for (const Real x : {zero, -zero, inf, -inf}) CHECK(same(maths::cbrt(x), x));
  CHECK((same(maths::cbrt(-nan), nan) && maths::cbrt(Real(-27)) == -3 && maths::cbrt(Real(0.001953125)) == 0.125));
  for (const Real x : {nan, -nan, inf, -inf, Real(1) + Limits::epsilon(), Real(-2)}) CHECK(same(maths::acos(x), nan));
  CHECK((same(maths::acos(Real(1)), zero) && maths::acos(Real(-1)) == pi && maths::acos(-zero) == pi / 2));
}

TEMPLATE_TEST_CASE("pow and atan2 agree with the C library on special arguments", "[maths]", float, double) {
  using Real = TestType;
  using Limits = std::numeric_limits<Real>;
  const Real inf = Limits::infinity(), nan = Limits::quiet_NaN(), zero = 0;
  const Real values[] = {zero,
                         Limits::denorm_min(),
                         Limits::min(),
                         Real(0.5),
                         1,
                         2,
                         3,
                         Real(2.5),
                         1e10f,
                         Limits::max(),
                         inf,
                         1 / Limits::epsilon(),
                         1 / Limits::epsilon() - 1,
                         2 / Limits::epsilon()};
  std::vector<Real> arguments{nan};
  for (const Real value : values) arguments.insert(arguments.end(), {value, -value});
  const auto near = [](Real ours, Real theirs) {
    if (std::isnan(theirs)) return same(ours, Limits::quiet_NaN());
    if (theirs == 0 || std::isinf(theirs)) return same(ours, theirs);
    return std::abs(ours - theirs) <= 2 * Limits::epsilon() * std::abs(theirs) + Limits::denorm_min();
  };
  for (const Real x : arguments) {
    for (const Real y : arguments) {
      CAPTURE(x, y);
      CHECK(near(maths::pow(x, y), std::pow(x, y)));
      CHECK(near(maths::atan2(x, y), std::atan2(x, y)));
    }
  }
}

TEMPLATE_TEST_CASE("maths is exact where the result is", "[maths]", float, double) {
  using Real = TestType;
  for (int n = 1; n <= 200; ++n) {
    const Real x = static_cast<Real>(n);
    CHECK(maths::cbrt(x * x * x) == x);
    CHECK(maths::pow(x, Real(2)) == x * x);
    CHECK(maths::pow(-x, Real(3)) == -(x * x * x));
    CHECK(maths::pow(x * x, Real(0.5)) == x);
  }
  for (int n = std::numeric_limits<Real>::min_exponent - 1; n < std::numeric_limits<Real>::max_exponent; ++n) {
    CHECK(maths::pow(Real(2), static_cast<Real>(n)) == std::ldexp(Real(1), n));
  }
}

TEST_CASE("long double overloads are the platform's", "[maths]") {
  const volatile long double x = 0.3L, y = 3;  // else the compiler computes the platform's value, and rounds it better
  CHECK(maths::sin(x) == std::sin(x));
  CHECK(maths::cos(x) == std::cos(x));
  CHECK(maths::exp(x) == std::exp(x));
  CHECK(maths::log(x) == std::log(x));
  CHECK(maths::pow(x, y) == std::pow(x, y));
  CHECK(maths::cbrt(x) == std::cbrt(x));
  CHECK(maths::acos(x) == std::acos(x));
  CHECK(maths::atan2(x, y) == std::atan2(x, y));
}

#ifdef WITH_MPFR
namespace {

struct Precise {
  mpfr_t value;
  Precise() { mpfr_init2(value, 200); }
  ~Precise() { mpfr_clear(value); }
  Precise(const Precise&) = delete;
  Precise& operator=(const Precise&) = delete;
};

void evaluate(const std::string& name, Precise& result, double x, double y) {
  Precise first, second;
  mpfr_set_d(first.value, x, MPFR_RNDN);
  mpfr_set_d(second.value, y, MPFR_RNDN);
  if (name == "pow") {
    mpfr_pow(result.value, first.value, second.value, MPFR_RNDN);
  } else if (name == "atan2") {
    mpfr_atan2(result.value, first.value, second.value, MPFR_RNDN);
  } else {
    const auto function = name == "sin"    ? mpfr_sin
                          : name == "cos"  ? mpfr_cos
                          : name == "exp"  ? mpfr_exp
                          : name == "log"  ? mpfr_log
                          : name == "cbrt" ? mpfr_cbrt
                                           : mpfr_acos;
    function(result.value, first.value, MPFR_RNDN);
  }
}

/// Error in units of the last place of the exact value; where that overflows or is none, 0 if `measured` agrees.
template <class Real>
double ulps(Real measured, const Precise& exact) {
  using Limits = std::numeric_limits<Real>;
  const Real nearest = std::is_same_v<Real, float> ? static_cast<Real>(mpfr_get_flt(exact.value, MPFR_RNDN))
                                                   : static_cast<Real>(mpfr_get_d(exact.value, MPFR_RNDN));
  if (std::isnan(nearest)) return std::isnan(measured) ? 0 : INFINITY;
  if (std::isinf(nearest) || std::isinf(measured)) return nearest == measured ? 0 : INFINITY;
  const long least = Limits::min_exponent;
  const long exponent =
      mpfr_zero_p(exact.value) ? least : std::max(least, static_cast<long>(mpfr_get_exp(exact.value)));
  Precise error;
  mpfr_sub_d(error.value, exact.value, measured, MPFR_RNDN);
  mpfr_mul_2si(error.value, error.value, Limits::digits - exponent, MPFR_RNDN);
  return std::abs(mpfr_get_d(error.value, MPFR_RNDN));
}

/// Where reduction, cancellation, overflow or denormals are hardest.
template <class Real>
std::vector<Real> hard_points() {
  using Limits = std::numeric_limits<Real>;
  std::vector<Real> result = {0,
                              Limits::denorm_min(),
                              Limits::min(),
                              Limits::max(),
                              Real(709.78271289338397),
                              Real(-745.13321910194111),
                              Real(88.7228394),
                              Real(-103.972084)};
  result.push_back(static_cast<Real>(std::ldexp(6381956970095103.0, std::is_same_v<Real, float> ? 60 : 797)));
  for (int k = 1; k < 1000; ++k) {
    const Real quarter_turns = static_cast<Real>(k * 1.5707963267948966);
    const Real power = std::ldexp(Real(1), k - 500);
    for (const Real x : {quarter_turns, std::ldexp(quarter_turns, 20), power, 1 + power, 1 - power, Real(k) / 500}) {
      result.insert(result.end(), {x, -x, std::nextafter(x, Real(0)), std::nextafter(x, Limits::max())});
    }
  }
  return result;
}

}  // namespace

TEMPLATE_TEST_CASE("maths is within 0.6 units in the last place of MPFR", "[maths]", float, double) {
  using Real = TestType;
  for (const auto& function : functions<Real>()) {
    auto arguments = points(function, 20'000);
    const auto hard = hard_points<Real>();
    for (std::size_t i = 0; i < hard.size(); ++i) arguments.push_back({hard[i], hard[(7 * i + 3) % hard.size()]});
    if (function.name == "pow") {  // results over the whole range from bases near one
      for (auto& [x, y] : points(function, 10'000)) {
        const Real base = 1 + std::min(std::abs(x), Real(40)) / 50;
        arguments.push_back({base, (y - 20) / 20 * function.lower + (y - 20) * 36 / std::log(base)});
      }
    }
    Precise exact;
    double worst = 0;
    Point<Real> at{};
    for (const auto& [x, y] : arguments) {
      evaluate(function.name, exact, x, y);
      const double error = ulps(function(x, y), exact);
      if (!(error <= worst)) worst = error, at = {x, y};
    }
    CAPTURE(function.name, arguments.size(), at.x, at.y, worst);
    CHECK(worst < 0.6);
  }
}
#endif
