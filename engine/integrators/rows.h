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
  long double a[max_phases][max_phases] = {};  ///< Runge-Kutta: Butcher's a_ij; implicit: j >= i too
  long double b[max_phases] = {};              ///< Runge-Kutta: weights
  /// Embedded pair: weights of the error of b, the last one of a further phase at y'. A second estimate, if any, is of
  /// lower order.
  long double error[max_errors][max_phases] = {};
  int error_order = 0;                ///< of the formula that b is held against; 0: no pair
  long double lead = 0;               ///< splitting: drift before the first kick
  long double kick[max_phases] = {};  ///< splitting
  long double drift[max_phases] = {};
  bool turns_velocity = false;             ///< splitting: see Method
  int history = 0;                         ///< multistep: earlier rates
  long double past[max_history + 1] = {};  ///< and weights, latest first
  long double corrector[max_history + 2] = {};

  bool embeds() const { return error_order > 0; }
};

/// Starts multistep methods, and takes over where they cannot go on.
inline constexpr const char* starter_name = "rk4";

const std::vector<Row>& rows();
/// nullptr if there is none of that name.
const Row* find_row(std::string_view name);
const char* name(Family family);
const char* name(RotationRule rule);

// Each family's, in the order of the catalogue.
std::vector<Row> runge_kutta_rows();
std::vector<Row> pair_rows();
std::vector<Row> extrapolation_rows();
std::vector<Row> multistep_rows();
std::vector<Row> splitting_rows();
std::vector<Row> implicit_rows();

/// The row's coefficients times the step h [s].
Method method_for(const Row& row, double h, RotationRule rotation = RotationRule::renormalise);
/// An embedded pair for a step of 1 s; to be scaled. `absolute` and `relative`: its tolerance.
Method pair_for(const Row& row, double absolute, double relative);
/// `unit`, for a step of 1 s, as it is for a step h.
void scale(const Method& unit, double h, Method& out);

}  // namespace ballpark::BALLPARK_PRECISION
