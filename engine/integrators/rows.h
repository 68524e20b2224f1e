// The methods, as data. To add one: a row in the file of its family; tests loop over all rows (order conditions, slope,
// stability, exact discrete behaviour).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/integrators/method.h"

namespace ballpark::BALLPARK_PRECISION {

struct Row {
  const char* name = nullptr;
  const char* doc = nullptr;
  const char* source = nullptr;
  Family family = Family::explicit_runge_kutta;
  int order = 1;
  int phases = 1;
  bool symplectic = false;
  long double a[max_phases][max_phases] = {};  ///< Runge-Kutta: Butcher's a_ij
  long double b[max_phases] = {};              ///< Runge-Kutta: weights
  long double lead = 0;                        ///< splitting: drift before the first kick
  long double kick[max_phases] = {};           ///< splitting
  long double drift[max_phases] = {};
};

const std::vector<Row>& rows();
/// nullptr if there is none of that name.
const Row* find_row(std::string_view name);
const char* name(Family family);

// Each family's, in the order of the catalogue.
std::vector<Row> runge_kutta_rows();
std::vector<Row> splitting_rows();

/// The row's coefficients times the step h [s].
Method method_for(const Row& row, double h);

}  // namespace ballpark::BALLPARK_PRECISION
