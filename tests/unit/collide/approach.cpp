// Continuous collision: when moving surfaces meet, beside many small steps along the way, and what the normal promises.
#include "engine/collide/approach.h"

#include <cmath>
#include <random>

#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

namespace {

using Point = Vector3<Real>;

class Dice {
 public:
  double number(double size) { return size * (static_cast<double>(engine_()) / 2147483648.0 - 1); }
  Point point(double size) {
    const double x = number(size), y = number(size);
    return {x, y, number(size)};
  }

 private:
  std::mt19937 engine_{7};
};

constexpr int fine = 4000;

/// The first of many small steps at which distance(share of the way) is below zero; 2 if none is.
template <class Distance>
double first_contact(Distance distance) {
  for (int i = 0; i <= fine; ++i) {
    const double share = static_cast<double>(i) / fine;
    if (distance(share) < 0) return share;
  }
  return 2;
}

/// What an approach must satisfy, given the distance along the way.
template <class Distance>
void check_approach(const Approach& approach, const Point& moved, Distance distance, double scale) {
  const double there = first_contact(distance), linear = approach.distance + dot(approach.normal, moved);
  CHECK(std::abs(length(approach.normal) - 1) <= 1e-12);
  if (distance(0) < -1e-9 * scale) {
    CHECK(approach.moment == 0);
    CHECK(std::abs(approach.distance - distance(0)) <= 1e-9 * scale);
  } else if (there <= 1) {  // met: at that moment the surfaces touch, and the half-space ends there
    CHECK(std::abs(approach.moment - there) <= 2.0 / fine);
    CHECK(std::abs(distance(approach.moment)) <= 1e-5 * scale);
    CHECK(std::abs(approach.distance + approach.moment * dot(approach.normal, moved)) <= 1e-5 * scale);
    CHECK(linear < 1e-5 * scale);
  } else {  // passed by: the half-space does not stop it
    CHECK(linear >= -1e-5 * scale);
  }
}

}  // namespace

TEST_CASE("Approach: two balls", "[collide]") {
  Dice dice;
  int met = 0;
  for (int n = 0; n < 400; ++n) {
    const Point apart = dice.point(2), moved = dice.point(6);
    const double reach = 1;
    const auto distance = [&](double share) { return length(apart + share * moved) - reach; };
    CAPTURE(n);
    check_approach(approach_between(apart, moved, reach), moved, distance, 1);
    CHECK(come_within(apart, moved, reach) == (first_contact(distance) <= 1));
    met += come_within(apart, moved, reach);
  }
  CHECK(met > 40);
  const Approach still = approach_between({1, 0, 0}, {0, 0, 0}, 0.5);
  CHECK(still.distance == 0.5);
  CHECK(approach_between({0, 0, 0}, {0, 0, 0}, 0.5).normal.z == 1);
}

TEST_CASE("Approach: plane, box from outside, tube from inside", "[collide]") {
  Dice dice;
  const Plane plane{{0.6, 0, 0.8}, -1};
  const Box box{{0.2, -0.1, 0.3}, {0.5, 0.8, 0.3}};
  const Tube tube{{1, 2, 0}, {0, 0.6, 0.8}, 4};
  const double radius = 0.25;
  for (int n = 0; n < 300; ++n) {
    const Point x = dice.point(2), moved = dice.point(6);
    CAPTURE(n);
    const auto along = [&](const auto& shape) {
      return [&](double share) { return gap_to(shape, x + share * moved, radius).distance; };
    };
    check_approach(approach_to(plane, x, moved, radius), moved, along(plane), 4);
    if (gap_to(box, x, radius).distance > -radius) {  // a centre inside is pushed through a face
      check_approach(approach_to(box, x, moved, radius), moved, along(box), 4);
    }
    check_approach(approach_to(tube, x, moved, radius), moved, along(tube), 4);
  }
}

TEST_CASE("Approach: leaving a sphere", "[collide]") {
  CHECK(moment_beyond({0, 0, 0}, {2, 0, 0}, 1) == 0.5);
  CHECK(moment_beyond({0.5, 0, 0}, {-3, 0, 0}, 1) == 0.5);
  CHECK(moment_beyond({0.5, 0, 0}, {0.1, 0, 0}, 1) == 1);
  CHECK(moment_beyond({2, 0, 0}, {1, 0, 0}, 1) == 0);
  CHECK(moment_beyond({2, 0, 0}, {-1, 0, 0}, 1) == 1);
  CHECK(moment_beyond({0, 0, 0}, {0, 0, 0}, 1) == 1);
}
