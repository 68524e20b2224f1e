// The narrow phase: known gaps, the gap as a distance function (|gradient| = 1, along the normal), lanes beside
// scalars.
#include "engine/collide/gap.h"

#include <array>
#include <cmath>
#include <random>

#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

namespace {

using Point = Vector3<Real>;

Point random_point(std::mt19937& engine, double size) {
  const auto number = [&] { return static_cast<Real>(size * (static_cast<double>(engine()) / 2147483648.0 - 1)); };
  const Real x = number(), y = number();
  return {x, y, number()};
}

bool near(const Point& a, const Point& b, double tolerance = 1e-15) {
  return static_cast<double>(length(a - b)) <= tolerance;
}

const Plane slope{{0.6, 0, 0.8}, 0.5};
const Box brick{{1, -2, 3}, {0.5, 1, 2}};
const Tube drum{{1, 2, 0}, {0, 0.6, 0.8}, 4};

/// The gap grows by one metre a metre along the normal, and by nothing across it (away from edges of the field).
template <class Shape>
void is_a_distance(const Shape& shape, double size) {
  std::mt19937 engine(1);
  const double h = 1e-5;
  int smooth = 0;
  for (int i = 0; i < 500; ++i) {
    const Point x = random_point(engine, size);
    const Gap<Real> gap = gap_to(shape, x, Real(0.25));
    CHECK(std::abs(length(gap.normal) - 1) < 1e-14);
    const Gap<Real> further = gap_to(shape, x + Real(h) * gap.normal, Real(0.25));
    const Gap<Real> back = gap_to(shape, x - Real(h) * gap.normal, Real(0.25));
    if (!near(further.normal, gap.normal, 1e-8) || !near(back.normal, gap.normal, 1e-8)) continue;  // over an edge
    ++smooth;
    CHECK(std::abs((further.distance - back.distance) / (2 * h) - 1) < 1e-8);
    const Point across = cross(gap.normal, random_point(engine, 1));
    const Real sideways = gap_to(shape, x + Real(h) * across, Real(0.25)).distance - gap.distance;
    CHECK(std::abs(sideways) < 1e-6 * h * 100);
  }
  CHECK(smooth > 450);
}

/// Vectors of bodies give the bits of scalars.
template <class Shape>
void is_the_same_in_lanes(const Shape& shape) {
  using V = LanesOf<2>;
  std::mt19937 engine(2);
  for (int round = 0; round < 50; ++round) {
    std::array<Point, lane_count<V>> points;
    std::array<std::array<Real, lane_count<V>>, 3> columns;
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = i == 0 ? Point{1, -2, 3} : random_point(engine, 4);
      columns[0][i] = points[i].x, columns[1][i] = points[i].y, columns[2][i] = points[i].z;
    }
    const Vector3<V> x{load<V>(columns[0].data()), load<V>(columns[1].data()), load<V>(columns[2].data())};
    const Gap<V> lanes = gap_to(shape, x, V(Real(0.25)));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Gap<Real> one = gap_to(shape, points[i], Real(0.25));
      CHECK(lanes.distance[i] == one.distance);
      CHECK(lanes.normal.x[i] == one.normal.x);
      CHECK(lanes.normal.y[i] == one.normal.y);
      CHECK(lanes.normal.z[i] == one.normal.z);
    }
  }
}

}  // namespace

TEST_CASE("Gap: between two balls", "[collide]") {
  const Gap<Real> apart = gap_between<Real>({2, 3, 6}, Real(1), Real(2));
  CHECK(apart.distance == 4);
  CHECK(near(apart.normal, {Real(2) / 7, Real(3) / 7, Real(6) / 7}));
  CHECK(gap_between<Real>({0, -0.5, 0}, Real(1), Real(2)).distance == -2.5);
  const Gap<Real> same = gap_between<Real>({0, 0, 0}, Real(1), Real(2));
  CHECK(same.distance == -3);
  CHECK(near(same.normal, {0, 0, 1}));
}

TEST_CASE("Gap: to a plane", "[collide]") {
  CHECK(gap_to<Real>(slope, {0, 0, 0}, Real(0.25)).distance == -0.75);
  CHECK(near(gap_to<Real>(slope, {5, 5, 5}, Real(1)).normal, slope.normal));
  is_a_distance(slope, 5);
}

TEST_CASE("Gap: to a box from outside, over a face, an edge and a corner, and from inside", "[collide]") {
  const Gap<Real> face = gap_to<Real>(brick, {1.2, -2.5, 6}, Real(0.25));
  CHECK(std::abs(face.distance - 0.75) < 1e-15);
  CHECK(near(face.normal, {0, 0, 1}));
  const Gap<Real> edge = gap_to<Real>(brick, {1.5 + 3, -3 - 4, 3}, Real(0.25));
  CHECK(std::abs(edge.distance - 4.75) < 1e-14);
  CHECK(near(edge.normal, {0.6, -0.8, 0}));
  const Gap<Real> corner = gap_to<Real>(brick, {0.5 - 2, -3 - 3, 1 - 6}, Real(0.25));
  CHECK(std::abs(corner.distance - 6.75) < 1e-14);
  CHECK(near(corner.normal, {-Real(2) / 7, -Real(3) / 7, -Real(6) / 7}));
  const Gap<Real> inside = gap_to<Real>(brick, {0.6, -2, 3}, Real(0.25));
  CHECK(std::abs(inside.distance + 0.35) < 1e-15);
  CHECK(near(inside.normal, {-1, 0, 0}));
  const Gap<Real> middle = gap_to<Real>(brick, brick.centre, Real(0.25));
  CHECK(middle.distance == -0.75);
  CHECK(near(middle.normal, {1, 0, 0}));
  is_a_distance(brick, 6);
}

TEST_CASE("Gap: to a tube from inside, and on its axis", "[collide]") {
  const Gap<Real> gap = gap_to<Real>(drum, {3, 2, 0}, Real(0.25));
  CHECK(std::abs(gap.distance - 1.75) < 1e-14);
  CHECK(near(gap.normal, {-1, 0, 0}));
  const Gap<Real> slid = gap_to<Real>(drum, Point{3, 2, 0} + Real(7) * drum.axis, Real(0.25));
  CHECK(std::abs(slid.distance - 1.75) < 1e-13);
  for (const Point& axis : {drum.axis, Point{1, 0, 0}, Point{0, 0, 1}}) {
    const Gap<Real> on_axis = gap_to<Real>({{1, 2, 0}, axis, 4}, {1, 2, 0}, Real(0.25));
    CHECK(on_axis.distance == 3.75);
    CHECK(std::abs(dot(on_axis.normal, axis)) < 1e-15);
    CHECK(std::abs(length(on_axis.normal) - 1) < 1e-15);
  }
  is_a_distance(drum, 3);
}

TEST_CASE("Gap: lanes give the bits of scalars", "[collide]") {
  is_the_same_in_lanes(slope);
  is_the_same_in_lanes(brick);
  is_the_same_in_lanes(drum);
}
