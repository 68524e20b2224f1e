// The octree of attraction: against the sum over all pairs, and its cells against the bodies that they stand for.
#include "engine/effects/gravity_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/core/random.h"
#include "engine/world/world.h"
#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

namespace {

/// Bodies of unequal mass, denser towards the middle.
struct Cloud {
  std::vector<Real> x[3], mass;

  explicit Cloud(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = [&](std::uint64_t stream) {
        return ballpark::random::uniform<double>({5, stream, i}, -1.0, 1.0);
      };
      const double out = std::abs(number(3)) * 2;
      for (std::size_t c = 0; c < 3; ++c) x[c].push_back(static_cast<Real>(out * number(c)));
      mass.push_back(static_cast<Real>(1.5 + number(4)));
    }
  }
  void build(GravityTree& tree) const {
    const Real* const columns[3] = {x[0].data(), x[1].data(), x[2].data()};
    tree.build(columns, mass.data(), mass.size());
  }
};

const PairKernels& kernels() {
  return kernel_table("base")->pair;
}

struct Field {
  std::vector<std::array<Real, 3>> acceleration;
  std::vector<Real> potential;
};

Pull pull_at(const Real* const (&at)[3], std::size_t bodies, const GravityTree::Sources& sources, Real softening) {
  Pull pull{.position = {},
            .bodies = bodies,
            .points = {},
            .point_count = sources.points[0].size(),
            .cells = {},
            .cell_count = sources.cells[0].size(),
            .softening_squared = softening * softening};
  std::copy(at, at + 3, pull.position);
  for (std::size_t k = 0; k < 4; ++k) pull.points[k] = sources.points[k].data();
  for (std::size_t k = 0; k < 10; ++k) pull.cells[k] = sources.cells[k].data();
  return pull;
}

Field field_of(const Cloud& cloud, Real opening_angle, Real softening) {
  GravityTree tree(opening_angle);
  cloud.build(tree);
  Field field;
  field.acceleration.resize(cloud.mass.size());
  field.potential.resize(cloud.mass.size());
  std::vector<int> seen(cloud.mass.size());
  for (const GravityTree::Group& group : tree.groups()) {
    GravityTree::Sources sources;
    tree.find_sources(group, sources);
    const Real* const at[3] = {tree.place(0, group.first), tree.place(1, group.first), tree.place(2, group.first)};
    const Pull pull = pull_at(at, group.last - group.first, sources, softening);
    Real columns[4][GravityTree::group_size + 16];
    Real* const acceleration[3] = {columns[0], columns[1], columns[2]};
    kernels().pull(pull, acceleration);
    kernels().pull_potential(pull, columns[3]);
    for (std::size_t i = 0; i < pull.bodies; ++i) {
      const std::uint32_t slot = tree.slot(group.first + i);
      ++seen[slot];
      field.acceleration[slot] = {columns[0][i], columns[1][i], columns[2][i]};
      field.potential[slot] = columns[3][i];
    }
  }
  CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
  return field;
}

Field exact_field(const Cloud& cloud, Real softening) {
  Field field;
  for (std::size_t i = 0; i < cloud.mass.size(); ++i) {
    long double sum[3] = {}, potential = 0;
    for (std::size_t j = 0; j < cloud.mass.size(); ++j) {
      long double r[3], square = static_cast<long double>(softening) * static_cast<long double>(softening);
      for (std::size_t c = 0; c < 3; ++c) {
        r[c] = static_cast<long double>(cloud.x[c][j]) - static_cast<long double>(cloud.x[c][i]);
        square += r[c] * r[c];
      }
      if (square == 0) continue;
      potential -= static_cast<long double>(cloud.mass[j]) / std::sqrt(square);
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += static_cast<long double>(cloud.mass[j]) * r[c] / (square * std::sqrt(square));
      }
    }
    field.acceleration.push_back({static_cast<Real>(sum[0]), static_cast<Real>(sum[1]), static_cast<Real>(sum[2])});
    field.potential.push_back(static_cast<Real>(potential));
  }
  return field;
}

double norm(const std::array<Real, 3>& a) {
  return std::sqrt(static_cast<double>(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]));
}

/// RMS of |dF| / |F|.
double error(const Field& a, const Field& exact) {
  double sum = 0;
  for (std::size_t i = 0; i < a.acceleration.size(); ++i) {
    std::array<Real, 3> off;
    for (std::size_t c = 0; c < 3; ++c) off[c] = a.acceleration[i][c] - exact.acceleration[i][c];
    sum += std::pow(norm(off) / norm(exact.acceleration[i]), 2);
  }
  return std::sqrt(sum / static_cast<double>(a.acceleration.size()));
}

}  // namespace

TEST_CASE("Gravity tree: with every cell opened it is the sum over all pairs", "[effects]") {
  for (const std::size_t count : {1, 2, 16, 17, 129, 1000}) {
    for (const Real softening : {Real(0), Real(0.1)}) {
      CAPTURE(count, softening);
      const Cloud cloud(count);
      const Field exact = exact_field(cloud, softening), found = field_of(cloud, Real(1e-9), softening);
      if (count > 1) CHECK(error(found, exact) < 1e-13);
      for (std::size_t i = 0; i < count; ++i) {
        CHECK(std::abs(found.potential[i] - exact.potential[i]) <= 1e-13 * std::abs(exact.potential[i]));
      }
    }
  }
}

TEST_CASE("Gravity tree: errors fall with the opening angle, by far more than its square", "[effects]") {
  const Cloud cloud(4000);
  const Field exact = exact_field(cloud, 0);
  double last = 1;
  for (const double angle : {1.0, 0.7, 0.5, 0.35, 0.25}) {
    const double now = error(field_of(cloud, static_cast<Real>(angle), 0), exact);
    CAPTURE(angle, now, last);
    CHECK(now < (angle == 1.0 ? 0.01 : last / 2));
    last = now;
  }
  CHECK(last < 5e-5);
}

TEST_CASE("Gravity tree: a cell pulls by the slope of its potential, and to second order as its bodies do",
          "[effects]") {
  const Cloud cloud(16);
  GravityTree tree(1);
  cloud.build(tree);
  for (const Real softening : {Real(0), Real(0.7)}) {
    double last = 0;
    for (const Real away : {Real(20), Real(40), Real(80)}) {
      const Real from[3] = {away, away / 2, -away / 3};
      const auto look = [&](const Real(&at)[3], bool as_cell, Real(&acceleration)[3]) {
        std::vector<Real> place[3];
        for (std::size_t c = 0; c < 3; ++c) place[c].assign(32, at[c]);
        GravityTree::Sources sources;
        // One cell of a tree, as a group of bodies without weight sees it from there.
        Cloud both = cloud;
        both.mass.resize(cloud.mass.size() + GravityTree::group_size, Real(1e-30));
        for (std::size_t c = 0; c < 3; ++c) both.x[c].resize(both.mass.size(), at[c]);
        GravityTree seen(as_cell ? Real(0.9) : Real(1e-9));
        both.build(seen);
        for (const GravityTree::Group& group : seen.groups()) {
          if (seen.slot(group.first) >= cloud.mass.size()) seen.find_sources(group, sources);
        }
        CHECK(sources.cells[0].empty() != as_cell);
        const Real* const columns[3] = {place[0].data(), place[1].data(), place[2].data()};
        const Pull pull = pull_at(columns, 1, sources, softening);
        Real out[4][32];
        Real* const to[3] = {out[0], out[1], out[2]};
        kernels().pull(pull, to);
        kernels().pull_potential(pull, out[3]);
        for (std::size_t c = 0; c < 3; ++c) acceleration[c] = out[c][0];
        return out[3][0];
      };
      Real of_cell[3], of_bodies[3], unused[3];
      look(from, true, of_cell);
      look(from, false, of_bodies);
      double off = 0, size = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        Real up[3], down[3];
        std::copy(from, from + 3, up), std::copy(from, from + 3, down);
        const Real step = away * Real(1e-4);
        up[c] += step, down[c] -= step;
        const Real slope = (look(up, true, unused) - look(down, true, unused)) / (2 * step);
        CHECK(std::abs(of_cell[c] + slope) < 1e-7 * std::abs(of_cell[c]));
        off += std::pow(of_cell[c] - of_bodies[c], 2);
        size += std::pow(of_bodies[c], 2);
      }
      const double relative = std::sqrt(off / size);
      CAPTURE(softening, away, relative, last);
      if (last > 0) CHECK(std::abs(std::log2(last / relative) - 3) < 0.35);  // octupoles are left
      last = relative;
    }
  }
}

TEST_CASE("Gravity tree: bodies at one place, on a line, far off or nowhere are taken as they come", "[effects]") {
  Cloud cloud(200);
  for (std::size_t i = 0; i < 90; ++i) {
    for (std::size_t c = 0; c < 3; ++c) cloud.x[c][i] = Real(0.25);
  }
  for (std::size_t i = 90; i < 130; ++i) cloud.x[1][i] = cloud.x[2][i] = 0;
  cloud.x[0][199] = Real(1e12);
  const Field exact = exact_field(cloud, Real(0.1));
  CHECK(error(field_of(cloud, Real(0.3), Real(0.1)), exact) < 1e-3);
  cloud.x[2][198] = std::numeric_limits<Real>::quiet_NaN();
  cloud.x[1][197] = std::numeric_limits<Real>::infinity();
  GravityTree tree(Real(0.5));
  cloud.build(tree);
  std::size_t bodies = 0;
  for (const GravityTree::Group& group : tree.groups()) bodies += group.last - group.first;
  CHECK(bodies == 200);
}
