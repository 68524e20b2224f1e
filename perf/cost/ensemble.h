// Beyond the horizon: means over runs that start a little apart, setting by setting.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "perf/cost/ground.h"

namespace ballpark::cost {

inline constexpr int fewest_copies = 10;
/// Of the whole time, where a scene goes on beyond its horizon: unasked, and asked for.
inline constexpr double unasked_share = 0.2, asked_share = 0.4;

struct EnsembleRequest {
  int copies = fewest_copies;
  double perturb = 0;  ///< relative change of each start; 0: as large as the path at the horizon
  double seconds = 0;  ///< for all of it, about
  bool asked = false;  ///< or done unasked
};

/// What is seen of every scene. The energy change is relative: kept or not, it shows a method's drift.
inline constexpr const char* energy_change = "energy change";
const std::vector<Observable>& observables();

/// Copies of a scene, each at its end.
struct Copies {
  std::vector<std::vector<double>> values;  ///< observable by observable, copy by copy
  std::string trouble;                      ///< why they do not count; "" if they do
};
/// Copy k is that of `ballpark run --copies`, run by itself. nullopt if it was stopped.
std::optional<Copies> run_copies(const Scene& scene, const Setting& setting, const EnsembleRequest& request,
                                 const Options& options, const GoOn& go_on);

/// Fills result.ensemble if the scene goes on beyond its horizon; else, or for what there is no time, result.left_out
/// says why. The front must be marked. False if it was stopped.
bool add_ensemble(const Ground& ground, const EnsembleRequest& request, Result& result,
                  const std::function<bool(double fraction)>& go_on);

}  // namespace ballpark::cost
