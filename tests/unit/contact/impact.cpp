// Impacts: worked cases to twelve digits, conserved quantities and the cone of friction over random ones, lanes.
#include "engine/contact/impact.h"

#include <array>
#include <cmath>
#include <random>

#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

namespace {

using Point = Vector3<Real>;
using Side = ImpactSide<Real>;

Side ball(double mass, double radius, const Point& velocity, const Point& spin) {
  return {Real(1 / mass), Real(1 / (0.4 * mass * radius * radius)), Real(radius), velocity, spin};
}

void collide(Side& one, Side& two, const Point& normal, double e, double mu) {
  apply_impact(impact_impulse(one, two, normal, {Real(e), Real(mu)}), normal, one, two);
}

void is(const Point& found, const Point& wanted) {
  const double scale = 1e-12 * (1 + static_cast<double>(length(wanted)));
  CHECK(std::abs(found.x - wanted.x) < scale);
  CHECK(std::abs(found.y - wanted.y) < scale);
  CHECK(std::abs(found.z - wanted.z) < scale);
}

class Numbers {
 public:
  Real positive() { return Real(0.2) + static_cast<Real>(engine_()) / Real(4294967296.0); }
  Real any() { return 4 * static_cast<Real>(engine_()) / Real(4294967296.0) - 2; }
  Point point() {
    const Real x = any(), y = any();
    return {x, y, any()};
  }
  Point unit() {
    const Point p = point();
    return (Real(1) / length(p)) * p;
  }

 private:
  std::mt19937 engine_{3};
};

Real energy(const Side& s) {
  return (dot(s.velocity, s.velocity) / s.inverse_mass + dot(s.spin, s.spin) / s.inverse_inertia) / 2;
}
Point momentum(const Side& s) {
  return (1 / s.inverse_mass) * s.velocity;
}
/// About the contact at the origin.
Point angular_momentum(const Side& s, const Point& centre) {
  return cross(centre, momentum(s)) + (1 / s.inverse_inertia) * s.spin;
}

}  // namespace

TEST_CASE("Impact: a sliding hit of equal balls", "[contact]") {
  Side one = ball(1, 0.5, {2, 1, 0}, {0, 0, 3}), two = ball(1, 0.5, {}, {});
  const Real before = energy(one) + energy(two);
  collide(one, two, {1, 0, 0}, 0.9, 0.1);
  is(one.velocity, {0.1, 0.81, 0});
  is(one.spin, {0, 0, 2.05});
  is(two.velocity, {1.9, 0.19, 0});
  is(two.spin, {0, 0, -0.95});
  CHECK(std::abs(before - 2.95) < 1e-12);
  CHECK(std::abs(energy(one) + energy(two) - 2.41135) < 1e-12);
}

TEST_CASE("Impact: a hit that ends sticking, out of the plane", "[contact]") {
  Side one = ball(1, 0.5, {2, 0.3, 0}, {0, 0.4, 0.2}), two = ball(1, 0.5, {}, {});
  collide(one, two, {1, 0, 0}, 0.9, 0.3);
  is(one.velocity, {0.1, 0.242857142857143, 0.0285714285714286});
  is(one.spin, {0, 0.257142857142857, -0.0857142857142857});
  is(two.velocity, {1.9, 0.0571428571428571, -0.0285714285714286});
  is(two.spin, {0, -0.142857142857143, -0.285714285714286});
}

TEST_CASE("Impact: unequal balls, any direction, sliding", "[contact]") {
  Side one = ball(2, 0.1, {1, -0.5, 0.25}, {5, -3, 8}), two = ball(0.5, 0.063, {-0.4, 0.2, 0.1}, {-2, 12, 7});
  collide(one, two, {Real(2) / 3, Real(1) / 3, Real(2) / 3}, 0.75, 0.2);
  is(one.velocity, {0.77177863071391, -0.571997893767394, 0.0942203161697874});
  is(one.spin, {4.9018008642048, -4.20736142426463, 8.70187984792752});
  is(two.velocity, {0.512885477144362, 0.487991575069576, 0.72311873532085});
  is(two.spin, {-2.62348657647748, 4.33421317927219, 11.4563799868414});
}

TEST_CASE("Impact: a billiard ball sticks to a cushion", "[contact]") {
  Side one = ball(0.17, 0.028575, {1.5, -2, 0}, {10, 0, -40}), wall;
  collide(one, wall, {0, -1, 0}, 0.85, 0.2);
  is(one.velocity, {1.398, 1.7, 0.0816428571428572});
  is(one.spin, {2.85714285714286, 0, -48.9238845144357});
  is(wall.velocity, {});
}

TEST_CASE("Impact: momenta are kept, energy never grows, friction stays in its cone", "[contact]") {
  Numbers numbers;
  int sliding = 0, sticking = 0;
  for (int i = 0; i < 2000; ++i) {
    Side one = ball(numbers.positive(), numbers.positive(), numbers.point(), numbers.point());
    Side two = ball(numbers.positive(), numbers.positive(), numbers.point(), numbers.point());
    const Point normal = numbers.unit();
    const Real approach = dot(slip_of(one, two, normal), normal);
    const ImpactLaw law{numbers.positive() - Real(0.2), numbers.positive() - Real(0.2)};
    const auto spun = [&] {
      return angular_momentum(one, -one.radius * normal) + angular_momentum(two, two.radius * normal);
    };
    const Real energy_before = energy(one) + energy(two);
    const Point p = momentum(one) + momentum(two), l = spun();
    const Point impulse = impact_impulse(one, two, normal, law);
    apply_impact(impulse, normal, one, two);
    if (approach <= 0) {
      CHECK(length(impulse) == 0);
      continue;
    }
    const Point u = slip_of(one, two, normal);
    CHECK(std::abs(dot(u, normal) + law.restitution * approach) < 1e-12);
    CHECK(length(momentum(one) + momentum(two) - p) < 1e-12);
    CHECK(length(spun() - l) < 1e-12);
    CHECK(energy(one) + energy(two) <= energy_before * (1 + 1e-14));
    const Real pressed = dot(impulse, normal), along = length(impulse - pressed * normal);
    CHECK(along <= law.friction * pressed * (1 + 1e-12));
    const bool sticks = length(u - dot(u, normal) * normal) < 1e-12;
    sticks ? ++sticking : ++sliding;
    if (!sticks) CHECK(std::abs(along - law.friction * pressed) < 1e-12);
  }
  CHECK(sliding > 200);
  CHECK(sticking > 200);
}

TEST_CASE("Impact: elastic and frictionless, equal balls exchange their normal velocities at any speed", "[contact]") {
  for (const double speed : {1e-3, 10.0}) {
    Side one = ball(0.17, 0.03, {Real(speed), 0, 0}, {0, 0, 7}), two = ball(0.17, 0.03, {}, {});
    collide(one, two, {1, 0, 0}, 1, 0);
    CHECK(std::abs(one.velocity.x) < 1e-15 * speed);
    CHECK(std::abs(two.velocity.x - speed) < 1e-15 * speed);
    is(one.spin, {0, 0, 7});
  }
}

TEST_CASE("Impact: lanes give the bits of scalars", "[contact]") {
  using V = LanesOf<1>;
  constexpr std::size_t lanes = lane_count<V>;
  Numbers numbers;
  for (int round = 0; round < 100; ++round) {
    std::array<Side, lanes> one, two;
    std::array<Real, lanes> column;
    const auto gather = [&](auto member) {
      for (std::size_t i = 0; i < lanes; ++i) column[i] = member(i);
      return load<V>(column.data());
    };
    for (std::size_t i = 0; i < lanes; ++i) {
      one[i] = ball(numbers.positive(), numbers.positive(), numbers.point(), numbers.point());
      two[i] = ball(numbers.positive(), numbers.positive(), numbers.point(), numbers.point());
      if (i == 0) two[i] = Side{};
    }
    const auto side = [&](const std::array<Side, lanes>& s) {
      const auto vector = [&](auto of) {
        return Vector3<V>{gather([&](std::size_t i) { return of(s[i]).x; }),
                          gather([&](std::size_t i) { return of(s[i]).y; }),
                          gather([&](std::size_t i) { return of(s[i]).z; })};
      };
      return ImpactSide<V>{gather([&](std::size_t i) { return s[i].inverse_mass; }),
                           gather([&](std::size_t i) { return s[i].inverse_inertia; }),
                           gather([&](std::size_t i) { return s[i].radius; }),
                           vector([](const Side& a) { return a.velocity; }),
                           vector([](const Side& a) { return a.spin; })};
    };
    const Point n = numbers.unit();
    const Vector3<V> found = impact_impulse(side(one), side(two), {V(n.x), V(n.y), V(n.z)}, {Real(0.8), Real(0.3)});
    for (std::size_t i = 0; i < lanes; ++i) {
      const Point wanted = impact_impulse(one[i], two[i], n, {Real(0.8), Real(0.3)});
      CHECK(found.x[i] == wanted.x);
      CHECK(found.y[i] == wanted.y);
      CHECK(found.z[i] == wanted.z);
    }
  }
}
