#include "engine/integrators/rows.h"

namespace ballpark::BALLPARK_PRECISION {

const std::vector<Row>& rows() {
  constexpr auto runge_kutta = Family::explicit_runge_kutta;
  static const std::vector<Row> all = {
      {.name = "euler",
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
      {.name = "rk4",
       .doc = "classic fourth-order Runge-Kutta",
       .source = "Kutta 1901",
       .family = runge_kutta,
       .order = 4,
       .phases = 4,
       .a = {{}, {0.5}, {0, 0.5}, {0, 0, 1}},
       .b = {1.0L / 6, 1.0L / 3, 1.0L / 3, 1.0L / 6}},
      {.name = "taylor2",
       .doc = "second-order Taylor series; needs the time derivative of every force",
       .source = "Hairer, Norsett & Wanner, Solving ODEs I, I.8",
       .family = Family::taylor,
       .order = 2,
       .phases = 1},
      {.name = "semi_implicit_euler",
       .doc = "symplectic Euler: velocity first, then position with the new velocity",
       .source = "de Vogelaere 1956",
       .family = Family::splitting,
       .order = 1,
       .phases = 1,
       .symplectic = true,
       .kick = {1},
       .drift = {1}},
      {.name = "velocity_verlet",
       .doc = "half kick, drift, half kick: time-reversible, energy error bounded",
       .source = "Swope, Andersen, Berens & Wilson 1982, J. Chem. Phys. 76, 637",
       .family = Family::splitting,
       .order = 2,
       .phases = 2,
       .symplectic = true,
       .kick = {0.5, 0.5},
       .drift = {1, 0}},
  };
  return all;
}

const Row* find_row(std::string_view name) {
  for (const Row& row : rows()) {
    if (name == row.name) return &row;
  }
  return nullptr;
}

const char* name(Family family) {
  switch (family) {
    case Family::chained_runge_kutta:
    case Family::explicit_runge_kutta:
      return "explicit Runge-Kutta";
    case Family::taylor:
      return "Taylor";
    case Family::splitting:
      return "splitting";
  }
  return "";
}

namespace {

/// Is a its subdiagonal, without zeros?
bool is_chained(const Row& row) {
  for (int i = 0; i < row.phases; ++i) {
    for (int j = 0; j < i; ++j) {
      if ((row.a[i][j] != 0) != (j == i - 1)) return false;
    }
  }
  return true;
}

}  // namespace

Method method_for(const Row& row, double step) {
  const Real h = static_cast<Real>(step);
  Method m;
  const bool chained = row.family == Family::explicit_runge_kutta && is_chained(row);
  m.family = chained ? Family::chained_runge_kutta : row.family;
  m.phases = row.phases;
  m.step = h;
  m.half_square = h * h / 2;
  long double drifted = 0;
  for (int i = 0; i < row.phases; ++i) {
    long double c = drifted;
    for (int j = 0; j < i; ++j) {
      m.a[i][j] = h * static_cast<Real>(row.a[i][j]);
      c += row.a[i][j];
    }
    drifted += row.drift[i];
    m.offset[i] = step * static_cast<double>(c);
    m.b[i] = h * static_cast<Real>(row.b[i]);
    m.kick[i] = h * static_cast<Real>(row.kick[i]);
    m.drift[i] = h * static_cast<Real>(row.drift[i]);
  }
  return m;
}

}  // namespace ballpark::BALLPARK_PRECISION
