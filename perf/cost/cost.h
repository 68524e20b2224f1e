// What accuracy costs in time, for one scene: references, errors, times, the front, and the setting to take.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "perf/cost/result.h"
#include "perf/cost/sweep.h"

namespace ballpark::cost {

struct Request {
  Axes axes;
  std::optional<Measure> measure;
  double seconds = 60;              ///< for all of it, about
  std::string reference = "best";   ///< see GroundRequest
  std::optional<double> tolerance;  ///< name the cheapest setting of at most this error
  std::optional<double> budget;     ///< or the most accurate of at most so many seconds a simulated second
  double margin = 2;                ///< the error is to be so many times smaller
  std::optional<int> copies;        ///< of ensembles beyond the horizon; none: a few, if there is time
  std::optional<double> perturb;    ///< relative change of their starts; none: as large as the path at the horizon
  Options options;
  std::vector<scenes::BodyEvent> events = {};  ///< whose times are compared as well
};

/// Told what is being done; false: stop.
using Progress = std::function<bool(const std::string& what, double fraction)>;

/// nullopt if it was stopped, or every way to run the scene ended badly. Throws SceneError.
std::optional<Result> cost(const Scene& scene, const Request& request, const Progress& progress);

/// Times whole runs of these points in turns, so that a drifting machine favours none; each run starts from the scene's
/// start and must end in the state that was looked at. False if it was stopped.
bool time_points(const Ground& ground, const std::vector<std::size_t>& which, const SweepTime& time, Result& result,
                 const std::function<bool(double fraction)>& go_on);

/// Adds settings between those of the sweep, where a curve may just meet the error `target` and be the fastest to do
/// so. False if it was stopped.
bool refine(const Ground& ground, double target, Result& result, const GoOn& go_on);

/// Paths of Euler's method and of rk4 with the same step, and the most accurate one.
void add_paths(const Ground& ground, Result& result, const GoOn& go_on);

}  // namespace ballpark::cost
