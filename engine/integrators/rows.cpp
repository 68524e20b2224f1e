#include "engine/integrators/rows.h"

namespace ballpark::BALLPARK_PRECISION {

const std::vector<Row>& rows() {
  static const std::vector<Row> all = [] {
    std::vector<Row> list = runge_kutta_rows();
    for (const auto& more : {pair_rows(), extrapolation_rows(), splitting_rows(), multistep_rows(), implicit_rows()}) {
      list.insert(list.end(), more.begin(), more.end());
    }
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
    case Family::multistep:
      return "multistep";
    case Family::implicit_runge_kutta:
      return "implicit Runge-Kutta";
  }
  return "";
}

const char* name(RotationRule rule) {
  switch (rule) {
    case RotationRule::renormalise:
      return "renormalise";
    case RotationRule::exponential:
      return "exponential";
    case RotationRule::splitting:
      return "splitting";
    case RotationRule::body:
      return "body";
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

/// Rotation by splitting is of order 2: compositions of its steps are of the order that the row needs. (Suzuki 1990;
/// Kahan & Li 1997; Hairer, Lubich & Wanner, Geometric Numerical Integration, eqs. II.4.5 and V.3.11.)
std::vector<long double> turn_shares(int order) {
  if (order <= 2) return {1};
  if (order <= 4) {
    constexpr long double s = 0.41449077179437573714235406286104L;  // 1 / (4 - 4^(1/3))
    return {s, s, 1 - 4 * s, s, s};
  }
  constexpr long double a = 0.39216144400731413928L, b = 0.33259913678935943860L, c = -0.70624617255763935981L,
                        d = 0.082213596293550800230L;
  return {a, b, c, d, 1 - 2 * (a + b + c + d), d, c, b, a};
}

}  // namespace

Method method_for(const Row& row, double step, RotationRule rotation) {
  const Real h = static_cast<Real>(step);
  Method m;
  const bool chained = row.family == Family::explicit_runge_kutta && is_chained(row);
  m.family = chained ? Family::chained_runge_kutta : row.family;
  m.phases = row.phases;
  m.step = h;
  m.half_square = h * h / 2;
  m.lead = h * static_cast<Real>(row.lead);
  m.turns_velocity = row.turns_velocity;
  m.rotation = rotation;
  if (rotation == RotationRule::splitting) {
    m.turns = 0;
    for (const long double share : turn_shares(row.order)) m.turn_share[m.turns++] = static_cast<Real>(share);
  }
  long double drifted = row.lead;
  for (int i = 0; i < row.phases; ++i) {
    long double c = drifted;
    for (int j = 0; j < (row.family == Family::implicit_runge_kutta ? row.phases : i); ++j) {
      m.a[i][j] = h * static_cast<Real>(row.a[i][j]);
      c += row.a[i][j];
    }
    drifted += row.drift[i];
    m.offset[i] = step * static_cast<double>(c);
    m.b[i] = h * static_cast<Real>(row.b[i]);
    m.kick[i] = h * static_cast<Real>(row.kick[i]);
    m.drift[i] = h * static_cast<Real>(row.drift[i]);
  }
  if (row.family != Family::multistep) return m;
  for (int p = 1; p < row.phases; ++p) m.offset[p] = step;
  m.history = row.history;
  m.history_begin = row.phases;
  for (int j = 0; j <= row.history; ++j) m.past[j] = h * static_cast<Real>(row.past[j]);
  for (int j = 0; j <= row.history + 1; ++j) m.corrector[j] = h * static_cast<Real>(row.corrector[j]);
  return m;
}

Method pair_for(const Row& row, double absolute, double relative) {
  Method m = method_for(row, 1);
  m.family = Family::explicit_runge_kutta;  // which estimates errors
  const int last = m.phases++;
  for (int j = 0; j < last; ++j) m.a[last][j] = m.b[j];
  m.offset[last] = 1;
  m.last_set = last;
  m.absolute = static_cast<Real>(absolute);
  m.relative = static_cast<Real>(relative);
  for (int e = 0; e < max_errors; ++e) {
    for (int p = 0; p < m.phases; ++p) {
      m.error[e][p] = static_cast<Real>(row.error[e][p]);
      if (m.error[e][p] != 0) m.errors = e + 1;
    }
  }
  return m;
}

void scale(const Method& unit, double step, Method& out) {
  const Real h = static_cast<Real>(step);
  out.step = h * unit.step;
  for (int i = 0; i < unit.phases; ++i) {
    out.offset[i] = step * unit.offset[i];
    out.b[i] = h * unit.b[i];
    for (int j = 0; j < i; ++j) out.a[i][j] = h * unit.a[i][j];
    for (int e = 0; e < unit.errors; ++e) out.error[e][i] = h * unit.error[e][i];
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
