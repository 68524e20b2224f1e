// Rows as data, and scaled by the step. Order conditions: tests/methods/tables.cpp.
#include "engine/integrators/rows.h"

#include <cmath>
#include <set>

#include "engine/world/interface.h"
#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

TEST_CASE("Rows: a stage reads only those before it", "[integrators]") {
  for (const Row& row : rows()) {
    CAPTURE(row.name);
    if (row.family == Family::implicit_runge_kutta) continue;
    for (int i = 0; i < max_phases; ++i) {
      for (int j = i; j < max_phases; ++j) CHECK(row.a[i][j] == 0);
    }
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
