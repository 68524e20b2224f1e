// Gragg, Bulirsch and Stoer's extrapolation of the midpoint rule, of a fixed order: written out, it is a Runge-Kutta
// tableau. HNW: Hairer, Norsett & Wanner, Solving ODEs I.
#include <array>

#include "engine/integrators/rows.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// Steps that each midpoint rule divides h into. (HNW II.9, the harmonic sequence of even numbers.)
constexpr std::array<int, 5> divisions{2, 4, 6, 8, 10};
using Weights = std::array<long double, max_phases>;

/// c_j such that sum_j c_j T_j has no error term in 1 / n^2, ..., for the rules from `first` on. (HNW eq. II.9.11)
long double share(std::size_t j, std::size_t first) {
  long double c = 1;
  for (std::size_t i = first; i < divisions.size(); ++i) {
    const long double mine = divisions[j] * divisions[j], other = divisions[i] * divisions[i];
    if (i != j) c *= mine / (mine - other);
  }
  return c;
}

/// The phases of Gragg's rule with n steps, which follow `row.phases` others; the weights of its result.
/// z_1 = y + h/n k(y), z_m+1 = z_m-1 + 2 h/n k(z_m) (HNW eq. II.9.13a and b)
Weights add_midpoint_rule(Row& row, int n) {
  Weights before{}, now{};
  now[0] = 1.0L / n;
  for (int m = 1; m < n; ++m) {
    for (int j = 0; j < row.phases; ++j) row.a[row.phases][j] = now[static_cast<std::size_t>(j)];
    before[static_cast<std::size_t>(row.phases)] += 2.0L / n;
    ++row.phases;
    std::swap(before, now);
  }
  return now;
}

Row gragg_bulirsch_stoer10() {
  Row row{.name = "gragg_bulirsch_stoer10",
          .doc = "extrapolation of five midpoint rules to order 10, with an estimate from four of them: for references",
          .source = "Gragg 1965, SIAM J. Numer. Anal. B 2, 384; Bulirsch & Stoer 1966, Numer. Math. 8, 1; HNW II.9",
          .family = Family::explicit_runge_kutta,
          .order = 2 * static_cast<int>(divisions.size()),
          .phases = 1,
          .error_order = 2 * static_cast<int>(divisions.size()) - 2};
  for (std::size_t j = 0; j < divisions.size(); ++j) {
    const Weights weights = add_midpoint_rule(row, divisions[j]);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      row.b[i] += share(j, 0) * weights[i];
      row.error[0][i] += (share(j, 0) - (j > 0 ? share(j, 1) : 0)) * weights[i];
    }
  }
  return row;
}

}  // namespace

std::vector<Row> extrapolation_rows() {
  return {gragg_bulirsch_stoer10()};
}

}  // namespace ballpark::BALLPARK_PRECISION
