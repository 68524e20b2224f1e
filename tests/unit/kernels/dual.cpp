// Dual numbers: values with their derivatives.
#include "engine/kernels/dual.h"

#include <cmath>

#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

namespace {

using V = Dual<2>;

/// Derivatives by x and y at (x, y) = (1.5, -0.5) are these.
bool derives(const V& v, Real value, Real by_x, Real by_y) {
  const auto near = [](Real a, Real b) { return std::abs(a - b) <= 4e-16 * (1 + std::abs(b)); };
  return near(v.value, value) && near(v.by[0], by_x) && near(v.by[1], by_y);
}

}  // namespace

TEST_CASE("Dual: arithmetic follows the rules of sums, products, quotients and roots", "[kernels]") {
  const Real a = 1.5, b = -0.5;
  const V x = V::variable(a, 0), y = V::variable(b, 1), three = V(Real(3));
  CHECK(derives(three, 3, 0, 0));
  CHECK(derives(x + y, a + b, 1, 1));
  CHECK(derives(x - y, a - b, 1, -1));
  CHECK(derives(-x, -a, -1, 0));
  CHECK(derives(x * y, a * b, b, a));
  CHECK(derives(x * x, a * a, 2 * a, 0));
  CHECK(derives(x / y, a / b, 1 / b, -a / (b * b)));
  CHECK(derives(three / x, 3 / a, -3 / (a * a), 0));
  CHECK(derives(square_root(x), std::sqrt(a), 1 / (2 * std::sqrt(a)), 0));
  V power = x;
  power *= power;
  power /= y;
  CHECK(derives(power, a * a / b, 2 * a / b, -a * a / (b * b)));
}

TEST_CASE("Dual: a vector type with one lane", "[kernels]") {
  const V x = V::variable(2, 0), zero = V(Real(0));
  CHECK(lane_count<V> == 1);
  CHECK((x > zero && !(zero > x) && x == V(Real(2)) && x != zero));
  CHECK(derives(select(x > zero, x * x, zero), 4, 4, 0));
  const Real memory[] = {5, 7};
  CHECK(derives(load<V>(memory + 1), 7, 0, 0));
  CHECK(derives(lane_numbers<V>(), 0, 0, 0));
  const Vector3<V> a = {x, zero, zero}, b = {zero, V::variable(3, 1), zero};
  CHECK(derives(cross(a, b).z, 6, 3, 2));
  CHECK(derives(length(a), 2, 1, 0));
}

TEST_CASE("Dual: |v| v has no derivative by v at rest", "[kernels]") {
  const Vector3<V> rest = {V::variable(0, 0), V(Real(0)), V(Real(0))};
  CHECK(derives((length(rest) * rest).x, 0, 0, 0));
}
