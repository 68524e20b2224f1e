// The files that a run writes: the scene's [[output]] series, --every/--out, --state and --figure.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "ballpark/scenes.h"
#include "scenarios/command/arguments.h"
#include "scenarios/command/figure_file.h"
#include "scenarios/command/output_file.h"
#include "scenarios/command/series.h"

namespace ballpark::command {

class RunFiles {
 public:
  /// Adds what the options ask for to the scene file's outputs, and opens everything, so that nothing runs that cannot
  /// be written. Throws UsageError or DestinationError. The scene file must outlive this.
  RunFiles(scenes::SceneFile& scene_file, const Arguments& arguments);
  /// One for each of the scene file's outputs. The first failure of a file ends its writing, not the run.
  std::vector<scenes::FrameWriter> writers();
  /// Puts the files in place. True if all are.
  bool finish();
  /// What finish() found to have failed, a sentence each. What failed before was told when it did.
  const std::vector<std::string>& failures() const { return failures_; }
  const std::vector<std::string>& written() const { return written_; }
  /// What the series took.
  std::vector<SeriesCost> costs() const;

 private:
  void finish_state();
  void finish_figure();

  const Scene& scene_;
  std::deque<Series> series_;
  std::optional<OutputFile> state_;
  std::string state_failure_;
  bool state_reached_ = false;
  std::optional<FigureFile> figure_;
  std::vector<std::string> failures_, written_;
};

}  // namespace ballpark::command
