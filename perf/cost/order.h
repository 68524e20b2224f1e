// The order that each integrator shows on a scene: how its error falls as the step is halved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "perf/cost/cost.h"

namespace ballpark::cost {

struct ObservedOrder {
  std::string integrator;
  int order = 0;                      ///< its own
  std::vector<double> steps, errors;  ///< the step halved and halved again
  std::vector<double> slopes;         ///< log2 of the ratio of an error to the next one
  std::optional<double> observed;     ///< of the finest two slopes in a row that agree; none: there were not two
  std::string trouble;                ///< why there are no errors
};

struct OrderStudy {
  Result about;  ///< scene, reference, measure and floor; no points
  std::vector<ObservedOrder> rows;
};

/// Of all fixed-step integrators that the scene takes, or of those of the axes. See `cost`.
std::optional<OrderStudy> observed_orders(const Scene& scene, const Request& request, const Progress& progress);

}  // namespace ballpark::cost
