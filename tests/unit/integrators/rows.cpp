// Rows as data: order conditions, consistency of splittings, scaling by the step.
#include "engine/integrators/rows.h"

#include <cmath>
#include <numeric>
#include <set>

#include "engine/world/interface.h"
#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

namespace {

/// Hairer, Norsett & Wanner, Solving ODEs I, table II.2.2: sums over trees, up to order 4. Returns the order met.
int order_met(const Row& row) {
  const int s = row.phases;
  const auto a = [&](int i, int j) { return row.a[i][j]; };
  const auto c = [&](int i) { return std::accumulate(row.a[i], row.a[i] + s, 0.0L); };
  const auto sum = [&](auto term) {
    long double total = 0;
    for (int i = 0; i < s; ++i) total += row.b[i] * term(i);
    return total;
  };
  const auto inner = [&](int i, auto term) {
    long double total = 0;
    for (int j = 0; j < s; ++j) total += a(i, j) * term(j);
    return total;
  };
  const auto met = [](long double value, long double expected) { return std::abs(value - expected) < 1e-17L; };
  const auto ac = [&](int i) { return inner(i, c); };
  if (!met(sum([](int) { return 1.0L; }), 1)) return 0;
  if (!met(sum(c), 0.5L)) return 1;
  if (!met(sum([&](int i) { return c(i) * c(i); }), 1.0L / 3) || !met(sum(ac), 1.0L / 6)) return 2;
  if (!met(sum([&](int i) { return c(i) * c(i) * c(i); }), 0.25L)) return 3;
  if (!met(sum([&](int i) { return c(i) * ac(i); }), 0.125L)) return 3;
  if (!met(sum([&](int i) { return inner(i, [&](int j) { return c(j) * c(j); }); }), 1.0L / 12)) return 3;
  if (!met(sum([&](int i) { return inner(i, ac); }), 1.0L / 24)) return 3;
  return 4;
}

bool is_palindrome(const Row& row) {
  // kick_0, drift_0, kick_1, ..., the last drift being zero
  for (int i = 0; i < row.phases; ++i) {
    if (row.kick[i] != row.kick[row.phases - 1 - i]) return false;
    if (i + 1 < row.phases && row.drift[i] != row.drift[row.phases - 2 - i]) return false;
  }
  return row.drift[row.phases - 1] == 0;
}

}  // namespace

TEST_CASE("Rows: Runge-Kutta weights meet the conditions of the order they claim, and no more", "[integrators]") {
  for (const Row& row : rows()) {
    if (row.family != Family::explicit_runge_kutta) continue;
    CAPTURE(row.name);
    CHECK(order_met(row) == row.order);
    for (int i = 0; i < row.phases; ++i) {
      for (int j = i; j < max_phases; ++j) CHECK(row.a[i][j] == 0);
    }
  }
}

TEST_CASE("Rows: splittings kick and drift by one step in all; second order by symmetry", "[integrators]") {
  for (const Row& row : rows()) {
    if (row.family != Family::splitting) continue;
    CAPTURE(row.name);
    CHECK(std::accumulate(row.kick, row.kick + max_phases, 0.0L) == 1);
    CHECK(std::accumulate(row.drift, row.drift + max_phases, 0.0L) == 1);
    CHECK(row.symplectic);
    CHECK((row.order == 2) == is_palindrome(row));
  }
}

TEST_CASE("Rows: each has a name, a sentence and a source of its own", "[integrators]") {
  std::set<std::string> names;
  for (const Row& row : rows()) {
    CAPTURE(row.name);
    CHECK(names.insert(row.name).second);
    CHECK(std::string(row.doc).size() > 10);
    CHECK_FALSE(std::string(row.source).empty());
    CHECK(row.phases <= max_phases);
    CHECK(find_row(row.name) == &row);
  }
  CHECK(names ==
        std::set<std::string>{"euler", "midpoint", "heun", "rk4", "taylor2", "semi_implicit_euler", "velocity_verlet"});
  CHECK(find_row("rk5") == nullptr);
}

TEST_CASE("Rows: scaled by the step, in the run's precision", "[integrators]") {
  const double h = 0.1;
  const Method m = method_for(*find_row("rk4"), h);
  CHECK(m.phases == 4);
  CHECK(m.step == h);
  CHECK(m.a[1][0] == h * 0.5);
  CHECK(m.a[3][2] == h);
  CHECK(m.b[0] == h * (1.0 / 6));
  CHECK(m.offset[0] == 0);
  CHECK(m.offset[1] == h / 2);
  CHECK(m.offset[3] == h);
  const Method verlet = method_for(*find_row("velocity_verlet"), h);
  CHECK(verlet.kick[0] == h / 2);
  CHECK(verlet.drift[0] == h);
  CHECK(verlet.offset[0] == 0);
  CHECK(verlet.offset[1] == h);
  CHECK(method_for(*find_row("taylor2"), h).half_square == h * h / 2);
}

TEST_CASE("Rows: stability limits are those of the stability polynomials", "[integrators]") {
  const auto row = [](const std::string& name) {
    for (const ballpark::IntegratorDescription& d : describe_integrators()) {
      if (d.name == name) return d;
    }
    return ballpark::IntegratorDescription{};
  };
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-6 * (1 + std::abs(b)); };
  for (const char* name : {"euler", "midpoint", "heun", "taylor2"}) {
    CAPTURE(name);
    CHECK(near(row(name).real_limit, 2));
    CHECK(row(name).imaginary_limit == 0);
  }
  CHECK(near(row("rk4").real_limit, 2.785293563405282));
  CHECK(near(row("rk4").imaginary_limit, 2.828427124746190));
  CHECK(near(row("semi_implicit_euler").imaginary_limit, 2));
  CHECK(near(row("velocity_verlet").imaginary_limit, 2));
  CHECK(row("rk4").evaluations == 4);
  CHECK(row("velocity_verlet").symplectic);
  CHECK_FALSE(row("rk4").symplectic);
}
