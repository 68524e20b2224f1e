// Lanes, vectors, rotations: against plain arithmetic, lane by lane.
#include <array>
#include <cmath>

#include "engine/kernels/vector3.h"
#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

namespace {

using Pair = LanesOf<2>;
constexpr std::size_t lanes = lane_count<Pair>;

template <class V>
struct Turned {
  std::array<V, 4> q;
  Rotation<V> matrix() const { return {q[0], q[1], q[2], q[3]}; }
};

/// A unit quaternion in rational numbers: (1, 3, 5, 1)/6.
const Turned<Real> turned{{1.0 / 6, 3.0 / 6, 5.0 / 6, 1.0 / 6}};

bool near(const Vector3<Real>& a, const Vector3<Real>& b, double tolerance = 1e-15) {
  const Vector3<Real> d = a - b;
  return std::sqrt(dot(d, d)) <= tolerance * (1 + length(b));
}

/// v -> q v q*, by the product of quaternions.
Vector3<Real> by_quaternion(const std::array<Real, 4>& q, const Vector3<Real>& v) {
  const Vector3<Real> u{q[1], q[2], q[3]};
  return v + Real(2) * cross(u, cross(u, v) + q[0] * v);
}

}  // namespace

TEST_CASE("Lanes: load, store and select, from any address", "[kernels]") {
  std::array<Real, 3 * lanes + 1> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Real>(i);
  const Pair v = load<Pair>(values.data() + 1);
  const Pair chosen = select(v > Pair(Real(2)), v, -v);
  for (std::size_t i = 0; i < lanes; ++i) {
    CHECK(v[i] == static_cast<Real>(i + 1));
    CHECK(chosen[i] == (i + 1 > 2 ? v[i] : -v[i]));
    CHECK(lane_numbers<Pair>()[i] == static_cast<Real>(i));
  }
  store(values.data() + lanes + 1, v);
  CHECK(values[lanes] == static_cast<Real>(lanes));
  CHECK(values[lanes + 1] == 1);
  CHECK(values[2 * lanes] == static_cast<Real>(lanes));
  CHECK(values[2 * lanes + 1] == static_cast<Real>(2 * lanes + 1));
  CHECK(lane_count<Real> == 1);
  CHECK(load<Real>(values.data() + 1) == 1);
}

TEST_CASE("Lanes: arithmetic and comparisons, lane by lane", "[kernels]") {
  std::array<Real, lanes> a{}, b{};
  for (std::size_t i = 0; i < lanes; ++i) {
    a[i] = static_cast<Real>(i) - 2;
    b[i] = static_cast<Real>(3 * (i % 2)) - static_cast<Real>(1.5);
  }
  const Pair x = load<Pair>(a.data()), y = load<Pair>(b.data()), yes = Pair(Real(1)), no = Pair(Real(0));
  for (std::size_t i = 0; i < lanes; ++i) {
    CHECK((x + y)[i] == a[i] + b[i]);
    CHECK((x - y)[i] == a[i] - b[i]);
    CHECK((x * y)[i] == a[i] * b[i]);
    CHECK((x / y)[i] == a[i] / b[i]);
    CHECK((-x)[i] == -a[i]);
    CHECK(select(x > y, yes, no)[i] == (a[i] > b[i] ? 1 : 0));
    CHECK(select(x == Pair(Real(1)), yes, no)[i] == (a[i] == 1 ? 1 : 0));
    CHECK(select(x != Pair(Real(1)), yes, no)[i] == (a[i] != 1 ? 1 : 0));
  }
  CHECK(std::signbit(Pair(Real(-0.0))[lanes - 1]));
  CHECK_FALSE(std::signbit(Pair(Real(0))[0]));
}

TEST_CASE("Lanes: any_nonzero sees one lane, and NaN", "[kernels]") {
  CHECK_FALSE(any_nonzero(Pair(Real(0))));
  CHECK_FALSE(any_nonzero(Pair(Real(-0.0))));
  CHECK_FALSE(any_nonzero(Real(0)));
  CHECK(any_nonzero(Real(NAN)));
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    std::array<Real, lanes> values{};
    values[lane] = lane % 2 == 0 ? Real(NAN) : Real(1e-300);
    CHECK(any_nonzero(load<Pair>(values.data())));
  }
}

TEST_CASE("Lanes: square roots are correctly rounded in every lane", "[kernels]") {
  for (Real x : {Real(0), Real(2), Real(0.1), Real(1e-200), Real(7e150)}) {
    CHECK(square_root(x) == std::sqrt(x));
    for (std::size_t lane = 0; lane < lanes; ++lane) CHECK(square_root(Pair(x))[lane] == std::sqrt(x));
  }
}

TEST_CASE("Vectors: products", "[kernels]") {
  const Vector3<Real> a{1, 2, 3}, b{-4, 5, 0.5};
  CHECK(dot(a, b) == 7.5);
  CHECK(near(cross(a, b), {-14, -12.5, 13}, 0));
  CHECK(near(cross(a, a), {}, 0));
  CHECK(length(Vector3<Real>{2, 3, 6}) == 7);
  Vector3<Real> sum = a;
  sum += b;
  sum -= a;
  CHECK(near(sum, b, 0));
}

TEST_CASE("Rotations: turn as the quaternion does, and back", "[kernels]") {
  const Rotation<Real> r = turned.matrix();
  for (const Vector3<Real>& v : {Vector3<Real>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.3, -2, 5}}) {
    CHECK(near(r.to_world(v), by_quaternion(turned.q, v)));
    CHECK(near(r.to_body(r.to_world(v)), v));
    CHECK(std::abs(length(r.to_world(v)) - length(v)) < 1e-15 * length(v));
  }
  const Real h = std::sqrt(Real(0.5));
  CHECK(near(Rotation<Real>(h, 0, 0, h).to_world({1, 0, 0}), {0, 1, 0}));  // a quarter about z
}

TEST_CASE("Rotations: the quaternion's rate is that of a body that turns with w", "[kernels]") {
  const Vector3<Real> w{0.7, -1.3, 2};
  Real rate[4];
  quaternion_rate(w, turned.q.data(), rate);
  const Real t = 1e-6;
  Turned<Real> ahead = turned, behind = turned;
  Real change = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    ahead.q[c] += t * rate[c];
    behind.q[c] -= t * rate[c];
    change += rate[c] * turned.q[c];
  }
  CHECK(std::abs(change) < 1e-15);  // the length stays
  const Vector3<Real> v{0.3, -2, 5};
  const Vector3<Real> moved = (1 / (2 * t)) * (by_quaternion(ahead.q, v) - by_quaternion(behind.q, v));
  CHECK(near(moved, cross(w, by_quaternion(turned.q, v)), 1e-9));
}

TEST_CASE("Rotations: the inverse length", "[kernels]") {
  const Real q[4] = {1, -2, 4, 10};
  CHECK(std::abs(inverse_length(q) - Real(1) / 11) < 1e-17);
}
