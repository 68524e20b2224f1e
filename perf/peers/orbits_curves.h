// Error against wall time, as a curve for each way to solve a problem, and what two curves cost at an equal error.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "perf/timing.h"

namespace ballpark::perf {

/// One setting of one solver, before and after it is timed.
struct Point {
  double setting = 0;  ///< number of steps, or tolerance
  Task solve;          ///< from the start to the end
  double error = 0;
  std::size_t steps = 0, evaluations = 0;
  double minimum = 0, median = 0;  ///< wall time of a solve [s]
};

struct Curve {
  std::string name;
  std::vector<Point> points;

  using Time = double Point::*;
  /// Time of the cheapest setting whose error is at most this, interpolated between settings (both logarithmic).
  std::optional<double> time_at(double error, Time time) const;
};

/// Times `ours` and `peer` in turns, one setting after the other.
void time_curves(std::vector<Curve>& curves, const Effort& effort);

/// Time of one curve over that of another, at an error that both reach.
struct EqualError {
  double error, of_minima, of_medians;
};
std::vector<EqualError> compare(const Curve& over, const Curve& under, const std::vector<double>& errors);
/// Geometric mean over the errors.
EqualError mean(const std::vector<EqualError>& all);

}  // namespace ballpark::perf
