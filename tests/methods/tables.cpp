// The rows' coefficients, and the stability limits that the catalogue tells.
#include <map>
#include <set>

#include "engine/integrators/rows.h"
#include "tests/catch.h"
#include "tests/methods/rows.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

using Numbers4 = long double[f64::max_phases];

/// Sum over a Runge-Kutta row's stages of b_i times f(i).
template <class F>
long double weighted(const f64::Row& row, F f) {
  long double sum = 0;
  for (int i = 0; i < row.phases; ++i) sum += row.b[i] * f(i);
  return sum;
}
/// Sum over the stages before i of a_ij times f(j).
template <class F>
long double inner(const f64::Row& row, int i, F f) {
  long double sum = 0;
  for (int j = 0; j < i; ++j) sum += row.a[i][j] * f(j);
  return sum;
}

long double sum(const Numbers4& values, int count) {
  long double total = 0;
  for (int i = 0; i < count; ++i) total += values[i];
  return total;
}

bool vanishes(long double x) {
  return std::abs(x) < 1e-15L;
}

}  // namespace

TEST_CASE("Runge-Kutta rows satisfy the order conditions up to their order", "[methods]") {
  for (const f64::Row& row : f64::rows()) {
    if (row.family != f64::Family::explicit_runge_kutta) continue;
    INFO(row.name);
    const auto one = [](int) { return 1.0L; };
    const auto c = [&](int i) { return inner(row, i, one); };
    const auto c2 = [&](int i) { return c(i) * c(i); };
    const auto ac = [&](int i) { return inner(row, i, c); };
    const auto ac2 = [&](int i) { return inner(row, i, c2); };
    const auto aac = [&](int i) { return inner(row, i, ac); };
    // Trees of order 1, 2, 3, 4: Hairer, Norsett & Wanner, Solving ODEs I, table II.2.2.
    std::vector<std::vector<long double>> residuals = {
        {weighted(row, one) - 1},
        {weighted(row, c) - 1.0L / 2},
        {weighted(row, c2) - 1.0L / 3, weighted(row, ac) - 1.0L / 6},
        {weighted(row, [&](int i) { return c2(i) * c(i); }) - 1.0L / 4,
         weighted(row, [&](int i) { return c(i) * ac(i); }) - 1.0L / 8, weighted(row, ac2) - 1.0L / 12,
         weighted(row, aac) - 1.0L / 24}};
    REQUIRE(row.order <= 4);
    for (int order = 1; order <= 4; ++order) {
      bool holds = true;
      for (const long double residual : residuals[static_cast<std::size_t>(order - 1)])
        holds = holds && vanishes(residual);
      INFO("order " << order);
      if (order <= row.order) CHECK(holds);
      if (order == row.order + 1) CHECK(!holds);  // the order told is the order it has
    }
  }
}

TEST_CASE("splitting rows are consistent, and symmetric if of even order", "[methods]") {
  for (const f64::Row& row : f64::rows()) {
    if (row.family != f64::Family::splitting) continue;
    INFO(row.name);
    CHECK(vanishes(sum(row.kick, row.phases) - 1));
    CHECK(vanishes(sum(row.drift, row.phases) - 1));
    std::vector<long double> sequence;  // kick, drift, kick, ... without an empty last drift
    for (int i = 0; i < row.phases; ++i) {
      sequence.push_back(row.kick[i]);
      sequence.push_back(row.drift[i]);
    }
    if (sequence.back() == 0) sequence.pop_back();
    const bool symmetric = sequence.size() % 2 == 1 && std::equal(sequence.begin(), sequence.end(), sequence.rbegin());
    CHECK(symmetric == (row.order % 2 == 0));
  }
}

TEST_CASE("the catalogue tells of every row once, with its order and evaluations", "[methods]") {
  std::set<std::string> names;
  for (const IntegratorDescription& told : integrators()) {
    INFO(told.name);
    const f64::Row* row = f64::find_row(told.name);
    REQUIRE(row != nullptr);
    CHECK(told.order == row->order);
    CHECK(names.insert(told.name).second);
    World world(scene(particle({1, 0, 0}), {spring(1)}, 1, 0.1, told.name));
    world.step(7);
    CHECK(world.counters().force_evaluations == static_cast<std::uint64_t>(7 * told.evaluations));
  }
  CHECK(names ==
        std::set<std::string>{"euler", "midpoint", "heun", "rk4", "taylor2", "semi_implicit_euler", "velocity_verlet"});
}

TEST_CASE("stability limits are those of the methods' polynomials", "[methods]") {
  struct Limits {
    double real, imaginary;
  };
  // Splitting rows have no real limit in the literature: forces are not to read velocity. Kicked by damping alone,
  // velocity is multiplied by 1 - t (semi-implicit Euler) or, with velocity predicted, 1 - t + t^2/2: both end at 2.
  const std::map<std::string, Limits> limits = {{"euler", {2, 0}},
                                                {"midpoint", {2, 0}},
                                                {"heun", {2, 0}},
                                                {"taylor2", {2, 0}},
                                                {"rk4", {2.785293563405282, 2.828427124746190}},
                                                {"semi_implicit_euler", {2, 2}},
                                                {"velocity_verlet", {2, 2}}};
  for (const IntegratorDescription& row : integrators()) {
    INFO(row.name << ": " << row.real_limit << ", " << row.imaginary_limit);
    REQUIRE(limits.count(row.name) == 1);
    CHECK(std::abs(row.real_limit - limits.at(row.name).real) < 1e-6);
    CHECK(std::abs(row.imaginary_limit - limits.at(row.name).imaginary) < 1e-6);
  }
}

TEST_CASE("runs stay bounded inside the limits told and grow outside, and what is outside is reported", "[methods]") {
  for (const IntegratorDescription& row : integrators()) {
    for (const double fraction : {0.999, 1.001}) {
      const bool inside = fraction < 1;
      INFO(row.name << " at " << fraction << " of its limit");
      World damped(scene(particle(Vector3d::Zero(), {1, 0, 0}), {effect("linear_drag", 1)}, 20000,
                         fraction * row.real_limit, row.name));
      CHECK((damped.status().code == Status::Code::ok) == inside);
      damped.step(10000);
      CHECK((velocity(damped)[0] < 1) == inside);
      if (row.imaginary_limit == 0) continue;
      World oscillating(scene(particle({1, 0, 0}), {spring(1)}, 20000, fraction * row.imaginary_limit, row.name));
      CHECK((oscillating.status().code == Status::Code::ok) == inside);
      oscillating.step(10000);
      CHECK((std::abs(position(oscillating)[0]) < 100) == inside);
    }
  }
}

TEST_CASE("an oscillation that no step keeps stable is reported when it grows by a tenth", "[methods]") {
  // Over 1000 steps at z = 0.01, Euler's energy grows by (1 + z^2)^1000, the midpoint rule's by (1 + z^4 / 4)^1000.
  for (const auto& [name, code] : {std::pair{"euler", Status::Code::ok}, std::pair{"midpoint", Status::Code::ok}}) {
    INFO(name);
    CHECK(World(scene(particle({1, 0, 0}), {spring(1)}, 10, 0.01, name)).status().code == code);
  }
  const World growing(scene(particle({1, 0, 0}), {spring(1)}, 100, 0.1, "euler"));
  CHECK(growing.status().code == Status::Code::stability);
  CHECK(growing.status().sentence.find("euler") != std::string::npos);
}
