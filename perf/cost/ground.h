// What a study of a scene stands on: when and whom to look at, the horizon, the reference, and what an error is.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "perf/cost/reference.h"
#include "perf/cost/result.h"

namespace ballpark::cost {

/// What an error is: a quantity, and of its distances from the reference "end", "maximum" or "rms".
struct Measure {
  Quantity quantity = Quantity::position;
  std::string which = "maximum";
};

struct GroundRequest {
  std::optional<Measure> measure = {};  ///< none: what moves, positions or orientations, of which `which`
  std::string reference = "best";       ///< "numerical": no closed form; "runs": the finest of two runs
  double seconds = 15;                  ///< for the reference, about
  std::vector<double> steps = {};       ///< that are to be compared [s]; none: the scene's
  Options options = {};
  std::vector<scenes::BodyEvent> events = {};
  const char* which = "maximum";  ///< see Measure
};

struct Ground {
  Scene scene;       ///< as it is compared: up to the horizon
  double whole = 0;  ///< duration that was asked for [s]
  Options options;
  Samples samples;
  ReferenceTrack reference;
  Measure measure;
  Result about;  ///< what of a result is known before anything is measured

  bool goes_beyond_horizon() const { return whole > scene.run.duration * (1 + 1e-9); }
  /// The error of a run that the measure means.
  double error_of(const Errors& errors) const { return value_of(errors, measure.quantity, measure.which); }
};

/// nullopt if it was stopped, or every way to run the scene ended badly. Throws SceneError.
std::optional<Ground> ground_for(const Scene& scene, const GroundRequest& request, const GoOn& go_on);

}  // namespace ballpark::cost
