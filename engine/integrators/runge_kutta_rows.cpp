// Explicit Runge-Kutta tableaus, and Taylor's series. HNW: Hairer, Norsett & Wanner, Solving ODEs I.
#include "engine/integrators/rows.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

constexpr auto runge_kutta = Family::explicit_runge_kutta;

Row dormand_prince5() {
  return {.name = "dormand_prince5",
          .doc = "Dormand and Prince's fifth-order Runge-Kutta of six evaluations",
          .source = "Dormand & Prince 1980, J. Comput. Appl. Math. 6, 19; HNW table II.5.2",
          .family = runge_kutta,
          .order = 5,
          .phases = 6,
          .a = {{},
                {1.0L / 5},
                {3.0L / 40, 9.0L / 40},
                {44.0L / 45, -56.0L / 15, 32.0L / 9},
                {19372.0L / 6561, -25360.0L / 2187, 64448.0L / 6561, -212.0L / 729},
                {9017.0L / 3168, -355.0L / 33, 46732.0L / 5247, 49.0L / 176, -5103.0L / 18656}},
          .b = {35.0L / 384, 0, 500.0L / 1113, 125.0L / 192, -2187.0L / 6784, 11.0L / 84}};
}

}  // namespace

std::vector<Row> runge_kutta_rows() {
  return {{.name = "euler",
           .doc = "explicit Euler: one evaluation; gains energy on every oscillation",
           .source = "Euler 1768",
           .family = runge_kutta,
           .order = 1,
           .phases = 1,
           .b = {1}},
          {.name = "midpoint",
           .doc = "explicit midpoint rule, second-order Runge-Kutta",
           .source = "Runge 1895",
           .family = runge_kutta,
           .order = 2,
           .phases = 2,
           .a = {{}, {0.5}},
           .b = {0, 1}},
          {.name = "heun",
           .doc = "Heun's method, the explicit trapezoidal rule",
           .source = "Heun 1900",
           .family = runge_kutta,
           .order = 2,
           .phases = 2,
           .a = {{}, {1}},
           .b = {0.5, 0.5}},
          {.name = "ralston",
           .doc = "second-order Runge-Kutta with the smallest bound on the error of a step",
           .source = "Ralston 1962, Math. Comput. 16, 431",
           .family = runge_kutta,
           .order = 2,
           .phases = 2,
           .a = {{}, {2.0L / 3}},
           .b = {0.25, 0.75}},
          {.name = "rk3",
           .doc = "Kutta's third-order Runge-Kutta",
           .source = "Kutta 1901",
           .family = runge_kutta,
           .order = 3,
           .phases = 3,
           .a = {{}, {0.5}, {-1, 2}},
           .b = {1.0L / 6, 2.0L / 3, 1.0L / 6}},
          {.name = "rk4",
           .doc = "classic fourth-order Runge-Kutta",
           .source = "Kutta 1901",
           .family = runge_kutta,
           .order = 4,
           .phases = 4,
           .a = {{}, {0.5}, {0, 0.5}, {0, 0, 1}},
           .b = {1.0L / 6, 1.0L / 3, 1.0L / 3, 1.0L / 6}},
          {.name = "rk4_38",
           .doc = "fourth-order Runge-Kutta by the 3/8 rule: smaller error terms than rk4's",
           .source = "Kutta 1901; HNW table II.1.2",
           .family = runge_kutta,
           .order = 4,
           .phases = 4,
           .a = {{}, {1.0L / 3}, {-1.0L / 3, 1}, {1, -1, 1}},
           .b = {0.125, 0.375, 0.375, 0.125}},
          dormand_prince5(),
          {.name = "taylor2",
           .doc = "second-order Taylor series; needs the time derivative of every force",
           .source = "HNW I.8",
           .family = Family::taylor,
           .order = 2,
           .phases = 1}};
}

}  // namespace ballpark::BALLPARK_PRECISION
