// What the options of `ballpark view` mean.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ballpark/scenes.h"
#include "scenarios/command/arguments.h"
#include "scenarios/view/drawing.h"
#include "scenarios/view/recorder.h"

namespace ballpark::command {

struct ViewSubject {
  scenes::SceneFile file;   ///< empty for a recorded file without --scene
  std::string label;        ///< in the page; "": by integrator and step
  std::string frames = {};  ///< a recorded file; "": the scene is run
  bool runs() const { return frames.empty(); }
  const Scene* scene() const { return file.path.empty() ? nullptr : &file.scene; }
};

struct Still {
  int width = 1280, height = 800;
  view::ColourBy colour = view::ColourBy::speed;
  std::optional<Vector3d> from;  ///< direction; none: the usual one
  double time = 0;               ///< [s]
};

struct ViewRequest {
  std::vector<ViewSubject> subjects;
  std::string out;
  std::vector<double> times;  ///< of frames, where scenes are run [s]
  view::Columns columns;
  bool columns_asked = false;
  std::size_t max_size = 30'000'000;
  std::optional<Still> still;  ///< of the last frame, to which the subject's duration is cut
};

/// Throws UsageError or SceneFileError.
ViewRequest view_request(const Arguments& arguments, const Options& options);

}  // namespace ballpark::command
