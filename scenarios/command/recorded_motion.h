// Recorded files as what a page or a picture shows.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ballpark/scene.h"
#include "scenarios/view/film.h"

namespace ballpark::command {

/// What of a file shall be shown, and how.
struct MotionRequest {
  std::string path;
  const Scene* scene = nullptr;  ///< that was run; has radii, groups and boundaries
  view::Columns columns;
  bool columns_asked = false;   ///< by name: refused where the file does not give them
  std::optional<double> until;  ///< the frame nearest to this time is the last [s]
  view::Limits limits;
};

/// Throws UsageError. `go_on` is asked at each frame; what was read until it is false is shown.
view::Recording recorded_motion(const MotionRequest& request, const std::function<bool()>& go_on);

}  // namespace ballpark::command
