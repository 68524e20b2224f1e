// The grid beside its oracle: the same set of pairs, each once, whatever the scene.
#include "engine/collide/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "engine/collide/brute_force.h"
#include "tests/catch.h"
#include "tests/unit/world/allocation_counter.h"

using namespace ballpark::BALLPARK_PRECISION;
using ballpark::Workers;

namespace {

using PairSet = std::vector<std::pair<std::size_t, std::size_t>>;

struct Scene {
  std::vector<Real> x, y, z, radius;
  Real one_radius = 0, margin = 0;
  Period period;

  Balls balls() const {
    Balls b;
    b.position[0] = x.data(), b.position[1] = y.data(), b.position[2] = z.data();
    b.radius = {radius.empty() ? nullptr : radius.data(), one_radius};
    b.count = x.size();
    b.margin = margin;
    return b;
  }
  void add(Real a, Real b, Real c) { x.push_back(a), y.push_back(b), z.push_back(c); }
};

PairSet sorted(PairSet pairs) {
  for (auto& [a, b] : pairs) {
    if (a > b) std::swap(a, b);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

PairSet found_by(Grid& grid, const Scene& scene, Workers& workers) {
  grid.find(scene.balls(), scene.period, workers);
  PairSet pairs;
  for (std::size_t b = 0; b < grid.block_count(); ++b) {
    for (const Pair& pair : grid.pairs(b)) pairs.emplace_back(pair.a, pair.b);
  }
  CHECK(pairs.size() == grid.pair_count());
  return sorted(pairs);
}

PairSet oracle(const Scene& scene) {
  PairSet pairs;
  for_each_near_pair(scene.balls(), scene.period, [&](std::size_t a, std::size_t b) { pairs.emplace_back(a, b); });
  return sorted(pairs);
}

/// Equal to brute force, and without doubles; returns how many pairs there are.
std::size_t agrees(const Scene& scene) {
  static Workers workers(3);
  Grid grid;
  const PairSet pairs = found_by(grid, scene, workers), wanted = oracle(scene);
  CHECK(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
  CHECK(pairs == wanted);
  CHECK(grid.cell_count() <= 4 * scene.x.size() + 64);
  std::vector<std::uint32_t> order(grid.order().begin(), grid.order().end());
  REQUIRE(order.size() == scene.x.size());
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) REQUIRE(order[i] == i);
  return wanted.size();
}

class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  Real between(double a, double b) {
    return static_cast<Real>(a + (b - a) * static_cast<double>(engine_()) / 4294967296.0);
  }

 private:
  std::mt19937 engine_;
};

/// n balls at random in a box around `centre`.
Scene random_scene(unsigned seed, std::size_t n, double side, Real radius, double centre = 0) {
  Numbers numbers(seed);
  Scene scene;
  scene.one_radius = radius;
  for (std::size_t i = 0; i < n; ++i) {
    scene.add(numbers.between(centre - side / 2, centre + side / 2),
              numbers.between(centre - side / 2, centre + side / 2),
              numbers.between(centre - side / 2, centre + side / 2));
  }
  return scene;
}

}  // namespace

TEST_CASE("Grid: pairs equal brute force, at random", "[collide]") {
  for (const std::size_t n : {0u, 1u, 2u, 3u, 7u, 9u, 17u, 300u, 5000u}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      CAPTURE(n, seed);
      const double side = std::cbrt(static_cast<double>(n) / 0.57) + 0.1;  // packing 0.3 at diameter 1
      const std::size_t pairs = agrees(random_scene(seed, n, side, Real(0.5)));
      if (n >= 300) CHECK(pairs > n / 2);
      agrees(random_scene(seed, n, side, Real(0.5), -1000));
    }
  }
}

TEST_CASE("Grid: pairs equal brute force with unequal radii and a margin", "[collide]") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Scene scene = random_scene(seed, 800, 12, Real(0));
    Numbers numbers(seed + 100);
    for (std::size_t i = 0; i < 800; ++i) scene.radius.push_back(numbers.between(0.01, i % 50 == 0 ? 1.5 : 0.4));
    scene.margin = Real(0.1) * static_cast<Real>(seed % 2);
    CHECK(agrees(scene) > 50);
  }
}

TEST_CASE("Grid: pairs equal brute force where all stand close, and far apart", "[collide]") {
  Scene heap = random_scene(1, 200, 0.5, Real(1));  // all in one cell
  CHECK(agrees(heap) == 200 * 199 / 2);
  Scene same = random_scene(1, 50, 0, Real(0.5));  // in one point
  CHECK(agrees(same) == 50 * 49 / 2);
  same.one_radius = 0;
  CHECK(agrees(same) == 50 * 49 / 2);

  Scene clusters = random_scene(2, 600, 1, Real(0.1));
  for (std::size_t i = 0; i < 600; ++i) clusters.x[i] += static_cast<Real>(i % 3) * Real(1e6);  // two empty megametres
  CHECK(agrees(clusters) > 600);
  Scene sparse = random_scene(3, 400, 1e9, Real(0.1));
  CHECK(agrees(sparse) == 0);
  Scene line = random_scene(4, 400, 1, Real(0.01));
  for (std::size_t i = 0; i < 400; ++i) line.y[i] = line.z[i] = 0;
  CHECK(agrees(line) > 400);
}

TEST_CASE("Grid: touching balls on the borders of cells are near, with and without a margin", "[collide]") {
  for (const double spacing : {1.0, 1.0 / 3, 0.1}) {
    for (const double shift : {0.0, -7.0, 1e5}) {
      Scene lattice;
      lattice.one_radius = static_cast<Real>(spacing / 2);
      lattice.margin = static_cast<Real>(1e-9 * (1 + std::abs(shift)));  // distances are rounded
      for (int i = 0; i < 9 * 9 * 9; ++i) {
        lattice.add(static_cast<Real>(shift + spacing * (i % 9)), static_cast<Real>(shift + spacing * (i / 9 % 9)),
                    static_cast<Real>(shift + spacing * (i / 81)));
      }
      CAPTURE(spacing, shift);
      CHECK(agrees(lattice) == 3 * 9 * 9 * 8);
    }
  }
}

TEST_CASE("Grid: balls a reach apart are near wherever the cells begin, along every axis", "[collide]") {
  Numbers numbers(10);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Scene line;
    line.one_radius = Real(0.5);
    for (int i = 0; i < 1000; ++i) {
      const Real start = static_cast<Real>(3 * i) + numbers.between(0, 1);
      for (const Real at : {start, start + 1 - Real(1e-12)}) {
        Real x[3] = {};
        x[axis] = at;
        line.add(x[0], x[1], x[2]);
      }
    }
    CHECK(agrees(line) == 1000);
  }
}

TEST_CASE("Grid: pairs equal brute force in periodic boxes, thin ones and unwrapped positions too", "[collide]") {
  for (const double thin : {8.0, 4.0, 3.0, 2.1, 2.0}) {  // cells of 1: 8 to 2 along z
    for (const bool wrapped : {true, false}) {
      Scene scene = random_scene(5, 250, 8, Real(0.49));
      scene.period = {{8, 0, static_cast<Real>(thin)}};
      for (std::size_t i = 0; i < 250; ++i) {
        scene.z[i] *= static_cast<Real>(thin / 8);
        if (!wrapped) scene.x[i] += Real(8) * static_cast<Real>(i % 5);
      }
      CAPTURE(thin, wrapped);
      CHECK(agrees(scene) > 100);
    }
  }
  Scene two;
  two.one_radius = Real(0.5);
  two.period = {{10, 10, 10}};
  two.add(Real(0.1), Real(9.9), Real(0.2));
  two.add(Real(9.7), Real(0.3), Real(9.8));
  CHECK(agrees(two) == 1);
  two.period.length[1] = 0;
  CHECK(agrees(two) == 0);
}

TEST_CASE("Grid: a ball that is nowhere is near nothing, and the others keep their pairs", "[collide]") {
  constexpr Real infinite = std::numeric_limits<Real>::infinity(), nan = std::numeric_limits<Real>::quiet_NaN();
  Scene scene = random_scene(6, 500, 9, Real(0.5));
  const std::size_t before = agrees(scene);
  scene.add(nan, 0, 0);
  scene.add(0, infinite, 0);
  scene.add(0, 0, -infinite);
  CHECK(agrees(scene) == before);
  scene.add(std::numeric_limits<Real>::max(), 0, 0);  // finite, and so far that extents overflow
  scene.add(-std::numeric_limits<Real>::max(), 0, 0);
  CHECK(agrees(scene) == before);
  Scene nowhere;
  nowhere.one_radius = 1;
  for (int i = 0; i < 5; ++i) nowhere.add(nan, nan, nan);
  CHECK(agrees(nowhere) == 0);
}

TEST_CASE("Grid: the pairs in their order are the same for any number of threads", "[collide]") {
  const Scene scene = random_scene(7, 20'000, 33, Real(0.5));
  std::vector<std::uint32_t> order;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> first;
  for (const int threads : {1, 2, 3, 5, 8}) {
    Workers workers(threads);
    Grid grid;
    grid.find(scene.balls(), scene.period, workers);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t b = 0; b < grid.block_count(); ++b) {
      for (const Pair& pair : grid.pairs(b)) pairs.emplace_back(pair.a, pair.b);
    }
    if (threads == 1) {
      first = pairs;
      order.assign(grid.order().begin(), grid.order().end());
    }
    CHECK(pairs == first);
    CHECK(std::equal(order.begin(), order.end(), grid.order().begin(), grid.order().end()));
  }
}

TEST_CASE("Grid: allocates nothing below its earlier peak", "[collide]") {
  const Scene scene = random_scene(8, 3000, 17, Real(0.5)), smaller = random_scene(9, 2000, 17, Real(0.5));
  Workers workers(2);
  Grid grid;
  grid.find(scene.balls(), scene.period, workers);
  const std::uint64_t before = allocation_counter::allocations();
  grid.find(smaller.balls(), smaller.period, workers);
  grid.find(scene.balls(), scene.period, workers);
  CHECK(allocation_counter::allocations() == before);
}
