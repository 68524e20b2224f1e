#include "engine/integrators/rows.h"

namespace ballpark::BALLPARK_PRECISION {

const std::vector<Row>& rows() {
  static const std::vector<Row> all = [] {
    std::vector<Row> list = runge_kutta_rows();
    for (const Row& row : splitting_rows()) list.push_back(row);
    return list;
  }();
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
  m.lead = h * static_cast<Real>(row.lead);
  long double drifted = row.lead;
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
