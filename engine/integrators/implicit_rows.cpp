// Implicit Runge-Kutta tableaus, whose stages depend on each other. HNW: Hairer, Norsett & Wanner, Solving ODEs I; HW:
// Hairer & Wanner, Solving ODEs II; HLW: Hairer, Lubich & Wanner, Geometric Numerical Integration.
#include "engine/integrators/rows.h"

namespace ballpark::BALLPARK_PRECISION {

std::vector<Row> implicit_rows() {
  constexpr auto implicit = Family::implicit_runge_kutta;
  constexpr long double root3_6 = 0.288675134594812882254574390250978727823801L;  // sqrt(3) / 6
  return {{.name = "backward_euler",
           .doc = "implicit Euler: damps all that is stiff, and every oscillation (L-stable)",
           .source = "Euler 1768; HW IV.3, eq. 3.7",
           .family = implicit,
           .order = 1,
           .phases = 1,
           .a = {{1}},
           .b = {1}},
          {.name = "implicit_midpoint",
           .doc = "implicit midpoint rule, Gauss's method with one stage: stable at any step, damps nothing",
           .source = "HNW table II.7.1; HLW II.1, eq. 1.7",
           .family = implicit,
           .order = 2,
           .phases = 1,
           .symplectic = true,
           .a = {{0.5}},
           .b = {1}},
          {.name = "gauss4",
           .doc = "Gauss's method with two stages: stable at any step, damps nothing",
           .source = "Hammer & Hollingsworth 1955; HNW table II.7.3; HLW II.1, table 1.1",
           .family = implicit,
           .order = 4,
           .phases = 2,
           .symplectic = true,
           .a = {{0.25, 0.25 - root3_6}, {0.25 + root3_6, 0.25}},
           .b = {0.5, 0.5}}};
}

}  // namespace ballpark::BALLPARK_PRECISION
