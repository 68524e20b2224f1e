// The methods, as data. To add one: a row here; tests loop over all rows (order, stability, exact discrete behaviour).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/integrators/method.h"

namespace ballpark::BALLPARK_PRECISION {

struct Row {
  const char* name;
  const char* doc;
  const char* source;
  Family family;
  int order;
  int phases;
  bool symplectic = false;
  long double a[max_phases][max_phases] = {};  ///< Runge-Kutta: Butcher's a_ij
  long double b[max_phases] = {};              ///< Runge-Kutta: weights
  long double kick[max_phases] = {};           ///< splitting
  long double drift[max_phases] = {};
};

const std::vector<Row>& rows();
/// nullptr if there is none of that name.
const Row* find_row(std::string_view name);
const char* name(Family family);

/// The row's coefficients times the step h [s].
Method method_for(const Row& row, double h);

}  // namespace ballpark::BALLPARK_PRECISION
