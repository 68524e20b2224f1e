// The rows' coefficients, and the stability limits that the catalogue tells.
#include <complex>
#include <map>
#include <set>

#include "engine/integrators/rows.h"
#include "tests/catch.h"
#include "tests/methods/order_conditions.h"
#include "tests/methods/rows.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

/// Sources print coefficients to 16 or more digits.
constexpr long double printed = 1e-15L;

/// The first step at which holds(z) ends, by steps of 1e-3 and then by halving.
template <class Holds>
double end_of(Holds holds) {
  double low = 0.05;
  while (low < 100 && holds(low + 1e-3)) low += 1e-3;
  double high = low + 1e-3;
  for (int i = 0; i < 50; ++i) (holds((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

double decay_limit(const char* name) {
  return end_of([&](double t) { return std::abs(stability_function(*f64::find_row(name), -t)) <= 1; });
}
double swing_limit_of_stages(const char* name) {
  return end_of([&](double z) { return std::abs(stability_function(*f64::find_row(name), {0, z})) <= 1 + 1e-14L; });
}

/// Largest root of x^n = sum of c_j x^(n - 1 - j), by the method of Durand and Kerner.
double largest_root(const std::vector<double>& c) {
  const std::size_t n = c.size();
  const auto value = [&](std::complex<double> x) {
    std::complex<double> sum = 1;
    for (const double coefficient : c) sum = sum * x - coefficient;
    return sum;
  };
  std::vector<std::complex<double>> roots;
  for (std::size_t i = 0; i < n; ++i) roots.push_back(std::pow(std::complex<double>(0.4, 0.9), static_cast<double>(i)));
  for (int sweep = 0; sweep < 300; ++sweep) {
    for (std::size_t i = 0; i < n; ++i) {
      std::complex<double> product = 1;
      for (std::size_t j = 0; j < n; ++j) product *= j == i ? 1 : roots[i] - roots[j];
      roots[i] -= value(roots[i]) / product;
    }
  }
  double most = 0;
  for (const auto& root : roots) most = std::max(most, std::abs(root));
  return most;
}

/// Adams-Bashforth-Moulton of order 4 as PECE on y' = -t y: y' = y - t (9/24 (y - t sum of b_j y_j) + sum of c_j y_j).
double moulton_limit() {
  return end_of([](double t) {
    const double b[] = {55.0 / 24, -59.0 / 24, 37.0 / 24, -9.0 / 24}, c[] = {19.0 / 24, -5.0 / 24, 1.0 / 24, 0};
    std::vector<double> polynomial;
    for (int j = 0; j < 4; ++j) {
      const double own = j == 0 ? 1 : 0;
      polynomial.push_back(own - t * (9.0 / 24 * (own - t * b[j]) + c[j]));
    }
    return largest_root(polynomial) <= 1 + 1e-13;
  });
}

/// |R(iz)| <= 1 for Dormand-Prince's fifth-order weights: R(w) = exp's series to w^5 + w^6 / 600 (HNW II, IV.2).
double dormand_prince_limit() {
  return end_of([](double z) {
    const double re = 1 - z * z / 2 + std::pow(z, 4) / 24 - std::pow(z, 6) / 600;
    const double im = z - std::pow(z, 3) / 6 + std::pow(z, 5) / 120;
    return re * re + im * im <= 1 + 1e-14;
  });
}

/// |trace| <= 2 of the product of kicks v -= z c x and drifts x += z d v.
double swing_limit(const char* name) {
  const f64::Row& row = *f64::find_row(name);
  return end_of([&](double z) {
    double trace = 0;
    for (int column = 0; column < 2; ++column) {
      double x = column == 0, v = column == 1;
      x += z * static_cast<double>(row.lead) * v;
      for (int i = 0; i < row.phases; ++i) {
        v -= z * static_cast<double>(row.kick[i]) * x;
        x += z * static_cast<double>(row.drift[i]) * v;
      }
      trace += column == 0 ? x : v;
    }
    return std::abs(trace) <= 2;
  });
}

}  // namespace

TEST_CASE("there are as many rooted trees as counted", "[methods]") {
  std::vector<int> counts(9, 0);
  for (const Tree& tree : rooted_trees(8)) ++counts[static_cast<std::size_t>(tree.vertices)];
  CHECK(counts == std::vector<int>{0, 1, 1, 2, 4, 9, 20, 48, 115});  // Solving ODEs I, table II.2.3
}

TEST_CASE("Runge-Kutta rows satisfy the order conditions up to their order, and no more", "[methods]") {
  for (const f64::Row& row : f64::rows()) {
    if (row.family != f64::Family::explicit_runge_kutta && row.family != f64::Family::implicit_runge_kutta) continue;
    CAPTURE(row.name);
    CHECK(order_met(row.a, row.b, row.phases, row.order + 1, printed) == row.order);
  }
}

TEST_CASE("embedded pairs hold their weights against formulas of lower order", "[methods]") {
  const std::map<std::string, std::vector<int>> lower = {{"bogacki_shampine3", {2}},
                                                         {"dormand_prince5", {4}},
                                                         {"tsitouras5", {4}},
                                                         {"dormand_prince8", {5, 3}},
                                                         {"gragg_bulirsch_stoer10", {8}}};
  std::size_t pairs = 0;
  for (const f64::Row& row : f64::rows()) {
    CHECK(row.embeds() == (lower.count(row.name) == 1));
    if (!row.embeds()) continue;
    ++pairs;
    CAPTURE(row.name);
    const f64::Method pair = f64::pair_for(row, 1e-6, 1e-6);
    CHECK(pair.phases == row.phases + 1);
    CHECK(pair.errors == static_cast<int>(lower.at(row.name).size()));
    long double a[f64::max_phases][f64::max_phases] = {};
    for (int i = 0; i <= row.phases; ++i) {
      for (int j = 0; j < i; ++j) a[i][j] = i < row.phases ? row.a[i][j] : row.b[j];
    }
    for (int e = 0; e < pair.errors; ++e) {
      long double other[f64::max_phases];
      for (int i = 0; i < f64::max_phases; ++i) other[i] = row.b[i] - row.error[e][i];
      const int order = lower.at(row.name)[static_cast<std::size_t>(e)];
      CHECK(order_met(a, other, pair.phases, order + 1, 2 * printed) == order);
    }
  }
  CHECK(pairs == lower.size());
}

TEST_CASE("multistep rows are exact for polynomials up to their order", "[methods]") {
  // y' = t^q from -history to 1: sum over past rates of b_j (-j)^q = 1 / (q + 1)  (HNW III.2, eq. 2.6)
  const auto order_of = [](const long double* weights, int first, int count) {
    for (int q = 0; q < 8; ++q) {
      long double sum = 0;
      for (int j = 0; j < count; ++j) sum += weights[j] * std::pow(static_cast<long double>(first - j), q);
      if (std::abs(sum - 1.0L / (q + 1)) > printed) return q;
    }
    return 8;
  };
  int rows = 0;
  for (const f64::Row& row : f64::rows()) {
    if (row.family != f64::Family::multistep) continue;
    ++rows;
    CAPTURE(row.name);
    CHECK(order_of(row.past, 0, row.history + 1) == row.order);
    if (row.phases > 1) CHECK(order_of(row.corrector, 1, row.history + 2) == row.order);
  }
  CHECK(rows == 5);
  f64::Row wrong = *f64::find_row("ab4");
  wrong.past[2] += 1e-12L;
  CHECK(order_of(wrong.past, 0, 4) < 4);
}

TEST_CASE("a wrong weight, stage or kick costs a row its order", "[methods]") {
  f64::Row wrong = *f64::find_row("rk4");
  std::swap(wrong.b[0], wrong.b[1]);
  CHECK(order_met(wrong.a, wrong.b, 4, 5, printed) < 4);
  wrong = *f64::find_row("dormand_prince5");
  wrong.a[4][2] += 1e-12L;
  CHECK(order_met(wrong.a, wrong.b, 6, 6, printed) < 5);
  wrong = *f64::find_row("yoshida6");
  wrong.kick[3] += 1e-12L;
  CHECK(splitting_order(wrong, 7, printed) < 6);
}

TEST_CASE("splitting rows have the order they tell, and are symmetric if it is even", "[methods]") {
  for (const f64::Row& row : f64::rows()) {
    if (row.family != f64::Family::splitting) continue;
    CAPTURE(row.name);
    CHECK(splitting_order(row, row.order + 1, 4 * printed) == row.order);
    std::vector<long double> sequence{row.lead};  // drift, kick, drift, ..., kick, drift
    for (int i = 0; i < row.phases; ++i) {
      sequence.push_back(row.kick[i]);
      sequence.push_back(row.drift[i]);
    }
    bool symmetric = true;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      symmetric = symmetric && std::abs(sequence[i] - sequence[sequence.size() - 1 - i]) < 1e-18L;
    }
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
    CHECK(told.implicit == (row->family == f64::Family::implicit_runge_kutta));
    if (told.implicit) continue;  // as many as its iterations take
    World world(scene(particle({1, 0, 0}), {spring(1)}, 1, 0.1, told.name));
    world.step(7);
    const int first = told.start_steps * (4 - told.evaluations);  // by rk4
    CHECK(world.counters().force_evaluations == static_cast<std::uint64_t>(7 * told.evaluations + first));
  }
  CHECK(names == std::set<std::string>{"boris",
                                       "euler",
                                       "midpoint",
                                       "heun",
                                       "ralston",
                                       "rk3",
                                       "rk4",
                                       "rk4_38",
                                       "taylor2",
                                       "bogacki_shampine3",
                                       "dormand_prince5",
                                       "tsitouras5",
                                       "dormand_prince8",
                                       "gragg_bulirsch_stoer10",
                                       "ab2",
                                       "ab3",
                                       "ab4",
                                       "ab5",
                                       "abm4",
                                       "semi_implicit_euler",
                                       "velocity_verlet",
                                       "ruth3",
                                       "forest_ruth",
                                       "yoshida4",
                                       "pefrl",
                                       "yoshida6",
                                       "backward_euler",
                                       "implicit_midpoint",
                                       "gauss4"});
}

TEST_CASE("stability limits are those of the methods' polynomials", "[methods]") {
  struct Limits {
    double real, imaginary;
  };
  // Splitting rows have no real limit in the literature: forces are not to read velocity. Kicked by damping alone,
  // velocity is multiplied by 1 - t (semi-implicit Euler) or, with velocity predicted, 1 - t + t^2/2: both end at 2.
  // The imaginary limits of the longer splittings are where |trace| of their step's matrix reaches 2.
  constexpr double second = 2, third = 2.512745326618329, fourth = 2.785293563405282;
  const std::map<std::string, Limits> limits = {
      {"euler", {second, 0}},
      {"midpoint", {second, 0}},
      {"heun", {second, 0}},
      {"ralston", {second, 0}},
      {"taylor2", {second, 0}},
      {"rk3", {third, std::sqrt(3.0)}},
      {"rk4", {fourth, 2 * std::sqrt(2.0)}},
      {"rk4_38", {fourth, 2 * std::sqrt(2.0)}},
      {"bogacki_shampine3", {third, std::sqrt(3.0)}},
      {"dormand_prince5", {3.306567892634947, dormand_prince_limit()}},
      {"tsitouras5", {decay_limit("tsitouras5"), swing_limit_of_stages("tsitouras5")}},
      {"dormand_prince8", {decay_limit("dormand_prince8"), swing_limit_of_stages("dormand_prince8")}},
      {"gragg_bulirsch_stoer10", {decay_limit("gragg_bulirsch_stoer10"), 0}},
      {"ab2", {1, 0}},
      {"ab3", {6.0 / 11, 0.7236}},
      {"ab4", {0.3, 0.4300}},
      {"ab5", {90.0 / 551, 0}},
      {"abm4", {moulton_limit(), 0}},
      {"semi_implicit_euler", {2, 2}},
      {"velocity_verlet", {2, 2}},
      {"boris", {0, 2}},
      {"ruth3", {0, swing_limit("ruth3")}},
      {"forest_ruth", {0, swing_limit("forest_ruth")}},
      {"yoshida4", {0, swing_limit("yoshida4")}},
      {"pefrl", {0, swing_limit("pefrl")}},
      {"yoshida6", {0, swing_limit("yoshida6")}}};
  for (const IntegratorDescription& row : integrators()) {
    if (row.implicit) continue;
    INFO(row.name << ": " << row.real_limit << ", " << row.imaginary_limit);
    REQUIRE(limits.count(row.name) == 1);
    CHECK(std::abs(row.real_limit - limits.at(row.name).real) < 1e-6);
    const bool read_off = row.name == "ab3" || row.name == "ab4";  // the source prints four digits
    CHECK(std::abs(row.imaginary_limit - limits.at(row.name).imaginary) < (read_off ? 5e-5 : 1e-6));
  }
}

TEST_CASE("runs stay bounded inside the limits told and grow outside, and what is outside is reported", "[methods]") {
  for (const IntegratorDescription& row : integrators()) {
    if (row.implicit) continue;
    const double margin = row.start_steps > 0 ? 0.02 : 0.001;  // what grows outside is a small part of the start
    for (const double fraction : {1 - margin, 1 + margin}) {
      const bool inside = fraction < 1;
      INFO(row.name << " at " << fraction << " of its limit");
      if (row.real_limit > 0) {
        World damped(scene(particle(Vector3d::Zero(), {1, 0, 0}), {effect("linear_drag", 1)}, 20000,
                           fraction * row.real_limit, row.name));
        CHECK((damped.status().code == Status::Code::ok) == inside);
        damped.step(10000);
        CHECK((velocity(damped)[0] < 1) == inside);
      }
      if (row.imaginary_limit == 0) continue;
      World oscillating(scene(particle({1, 0, 0}), {spring(1)}, 20000, fraction * row.imaginary_limit, row.name));
      CHECK((oscillating.status().code == Status::Code::ok) == inside);
      const double start = oscillating.totals().energy();
      oscillating.step(10000);
      // Rows that are not symplectic lose energy inside; at their limits symplectic ones let it swing.
      const Totals end = oscillating.totals();
      const bool grew = end.non_finite_bodies > 0 || end.energy() > (row.symplectic ? 1e4 : 1) * start;
      CHECK(grew != inside);
    }
  }
}

TEST_CASE("implicit rows have no limit, Gauss's keep an oscillation's size, and backward Euler damps what is stiff",
          "[methods]") {
  std::size_t rows = 0;
  for (const IntegratorDescription& row : integrators()) {
    if (!row.implicit) continue;
    ++rows;
    INFO(row.name);
    CHECK(std::isinf(row.real_limit));
    CHECK(std::isinf(row.imaginary_limit));
    const f64::Row& tableau = *f64::find_row(row.name);
    for (const long double z : {0.1L, 1.0L, 30.0L, 1e4L}) {
      CHECK(std::abs(stability_function(tableau, -z)) < 1);
      const long double size = std::abs(stability_function(tableau, {0, z}));
      CHECK(std::abs(size - (row.symplectic ? 1 : 1 / std::sqrt(1 + z * z))) < 1e-15L);
    }
    CHECK((std::abs(stability_function(tableau, -1e12L)) < 1e-11L) == (row.name == "backward_euler"));
  }
  CHECK(rows == 3);
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
