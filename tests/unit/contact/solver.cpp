// The coloured Gauss-Seidel solver beside an oracle of another kind: damped projected Jacobi over a plain list of
// contacts, without colours, cones or warm starts. Both must find the one motion that is nearest to the trial, weighed
// by mass, of all that keep the balls apart.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "engine/contact/impulse_solver.h"
#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;
using ballpark::Workers;

namespace {

constexpr Real h = 0.01, push_out = Real(0.2);

/// A shaken lattice of balls of three masses, in a corner of two walls, that overlap a little; the trial falls.
void fill(ImpulseSolver& solver, std::size_t side) {
  ContactBodies& bodies = solver.bodies;
  std::mt19937 engine(3);
  const auto number = [&](double size) { return size * (static_cast<double>(engine()) / 2147483648.0 - 1); };
  bodies.per_copy = side * side * side;
  bodies.resize(bodies.per_copy, true);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    bodies.radius[i] = 0.5;
    bodies.inverse_mass[i] = 1.0 / static_cast<double>(1 + i % 3);
    bodies.mobility[i] = 0;
    bodies.material[i] = 0;
    const auto along = [&](std::size_t k) { return 0.47 + 0.96 * static_cast<double>(k) + number(0.02); };
    const Real x = along(i % side), y = along(i / side % side);
    bodies.position.put(i, {x, y, along(i / side / side)});
    bodies.velocity.put(i, {0, 0, 0});
    bodies.end_position.put(i, bodies.position.at(i) + h * Vector3<Real>{number(0.3), number(0.3), number(0.3) - 0.5});
    bodies.end_velocity.put(i, {0, 0, 0});
  }
  solver.laws = {{{0, 0}}, 1};
  solver.walls.resize(2);
  solver.walls[0].shape = Plane{{0, 0, 1}, 0};
  solver.walls[1].shape = Plane{{1, 0, 0}, 0};
}

struct Touch {
  int a;  ///< -1: a wall
  std::size_t b;
  Vector3<Real> normal;
  Real least, impulse = 0;
};

std::vector<Touch> touches_of(const ContactBodies& bodies) {
  std::vector<Touch> list;
  for (std::size_t b = 0; b < bodies.count; ++b) {
    const Vector3<Real> x = bodies.position.at(b);
    for (std::size_t a = 0; a < b; ++a) {
      const Vector3<Real> apart = x - bodies.position.at(a);
      const Real gap = length(apart) - 1;
      if (gap < 0) list.push_back({static_cast<int>(a), b, (1 / length(apart)) * apart, -push_out * gap / h});
    }
    if (x.z < 0.5) list.push_back({-1, b, {0, 0, 1}, push_out * (0.5 - x.z) / h});
    if (x.x < 0.5) list.push_back({-1, b, {1, 0, 0}, push_out * (0.5 - x.x) / h});
  }
  return list;
}

/// Mean velocities that keep the balls apart, by projected Jacobi.
std::vector<Vector3<Real>> oracle(const ContactBodies& bodies) {
  std::vector<Touch> touches = touches_of(bodies);
  std::vector<Vector3<Real>> start(bodies.count), v(bodies.count);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    start[i] = (1 / h) * (bodies.end_position.at(i) - bodies.position.at(i));
  }
  for (int n = 0; n < 60000; ++n) {
    v = start;
    for (const Touch& t : touches) {
      v[t.b] += (bodies.inverse_mass[t.b] * t.impulse) * t.normal;
      if (t.a >= 0)
        v[static_cast<std::size_t>(t.a)] -= (bodies.inverse_mass[static_cast<std::size_t>(t.a)] * t.impulse) * t.normal;
    }
    for (Touch& t : touches) {
      Vector3<Real> over = v[t.b];
      Real inverse = bodies.inverse_mass[t.b];
      if (t.a >= 0)
        over -= v[static_cast<std::size_t>(t.a)], inverse += bodies.inverse_mass[static_cast<std::size_t>(t.a)];
      t.impulse = std::max(Real(0), t.impulse + Real(0.15) / inverse * (t.least - dot(t.normal, over)));
    }
  }
  return v;
}

/// Of the solver after so many sweeps, in units of velocity.
Real error_after(int iterations, std::size_t side, int threads) {
  ImpulseSolver solver;
  fill(solver, side);
  solver.settings.iterations = iterations;
  solver.settings.push_out = push_out;
  const std::vector<Vector3<Real>> right = oracle(solver.bodies);
  Workers workers(threads);
  solver.find(0, h, workers);
  solver.reflect(0, h, workers);
  solver.solve(workers);
  CHECK(solver.counters().impacts == 0);
  Real most = 0;
  for (std::size_t i = 0; i < solver.bodies.count; ++i) {
    const Vector3<Real> mean = (1 / h) * (solver.bodies.end_position.at(i) - solver.bodies.position.at(i));
    most = std::max(most, length(mean - right[i]));
  }
  return most;
}

}  // namespace

TEST_CASE("Solver: Gauss-Seidel by colours and projected Jacobi keep balls apart in the same way", "[contact]") {
  CHECK(error_after(20000, 4, 1) <= 1e-9);
  CHECK(error_after(20000, 4, 2) <= 1e-9);
  CHECK(error_after(20000, 1, 1) <= 1e-12);
}

TEST_CASE("Solver: more sweeps come nearer", "[contact]") {
  const Real few = error_after(4, 4, 1), more = error_after(40, 4, 1), many = error_after(400, 4, 1);
  CHECK(few > 1e-4);
  CHECK(more < few / 2);
  CHECK(many < more / 10);
}

namespace {

/// Falling balls over many steps, with bodies sorted in memory every so many of them; the end by rank.
std::vector<Vector3<Real>> run_sorted(std::size_t from, std::size_t every, int threads) {
  ImpulseSolver solver;
  fill(solver, 8);
  solver.laws = {{{Real(0.4), Real(0.3)}}, 1};
  solver.settings.sort_from = from;
  solver.settings.sort_every = every;
  ContactBodies& bodies = solver.bodies;
  bodies.spins = true;
  for (std::size_t i = 0; i < bodies.count; ++i) bodies.mobility[i] = Real(2.5) * bodies.inverse_mass[i];
  std::vector<Vector3<Real>> x, v, surface(bodies.count);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    const std::size_t shuffled = i * 389 % bodies.count;  // neighbours are far in the order of ranks
    x.push_back(bodies.position.at(shuffled));
    v.push_back(solver.bodies.end_position.at(shuffled) - bodies.position.at(shuffled));
    v.back() = (1 / h) * v.back();
  }
  Workers workers(threads);
  for (int step = 0; step < 40; ++step) {
    solver.sort_bodies();
    for (std::size_t rank = 0; rank < bodies.count; ++rank) {
      const std::size_t slot = bodies.slot_of(rank);
      bodies.position.put(slot, x[rank]), bodies.velocity.put(slot, v[rank]), bodies.surface.put(slot, surface[rank]);
      const Vector3<Real> later = v[rank] + Vector3<Real>{0, 0, -h * 10};
      bodies.end_position.put(slot, x[rank] + h * later), bodies.end_velocity.put(slot, later);
      bodies.end_surface.put(slot, surface[rank]);
    }
    solver.find(step * h, h, workers);
    solver.reflect(step * h, h, workers);
    solver.solve(workers);
    solver.relax(workers);
    for (std::size_t rank = 0; rank < bodies.count; ++rank) {
      const std::size_t slot = bodies.slot_of(rank);
      x[rank] = bodies.end_position.at(slot), v[rank] = bodies.end_velocity.at(slot);
      surface[rank] = bodies.end_surface.at(slot);
    }
  }
  CHECK(solver.counters().impacts > 100);
  CHECK(solver.counters().contacts > 1000);
  CHECK(bodies.ranks.empty() == (from > bodies.count));
  if (!bodies.ranks.empty()) CHECK_FALSE(std::is_sorted(bodies.ranks.begin(), bodies.ranks.end()));
  x.insert(x.end(), v.begin(), v.end());
  x.insert(x.end(), surface.begin(), surface.end());
  return x;
}

}  // namespace

TEST_CASE("Solver: the order of bodies in memory changes no bit", "[contact]") {
  const std::vector<Vector3<Real>> unsorted = run_sorted(100000, 1, 1);
  for (const std::size_t every : {1, 7}) {
    for (const int threads : {1, 2}) {
      const std::vector<Vector3<Real>> sorted = run_sorted(0, every, threads);
      REQUIRE(sorted.size() == unsorted.size());
      CAPTURE(every, threads);
      CHECK(std::memcmp(sorted.data(), unsorted.data(), sorted.size() * sizeof(sorted[0])) == 0);
    }
  }
}
