// The files that a run writes: the scene's [[output]] series, --every/--out, and --state.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ballpark/scenes.h"
#include "scenarios/command/arguments.h"
#include "scenarios/command/frame_file.h"
#include "scenarios/command/output_file.h"

namespace ballpark::command {

class RunFiles {
 public:
  /// Adds what the options ask for to the scene file's outputs, and opens everything, so that nothing runs that cannot
  /// be written. Throws UsageError or DestinationError.
  RunFiles(scenes::SceneFile& scene_file, const Arguments& arguments);
  /// One for each of the scene file's outputs. The first failure of a file ends its writing, not the run.
  std::vector<scenes::FrameWriter> writers();
  /// Puts the files in place. What failed, a sentence each.
  std::vector<std::string> finish();
  std::vector<std::string> written() const { return written_; }

 private:
  struct Series {
    std::string path, failure;
    std::unique_ptr<FrameFile> file;
  };
  void add_to(Series& series, const World& world);

  std::vector<Series> series_;
  std::optional<OutputFile> state_;
  std::string state_failure_;
  bool state_reached_ = false;
  std::vector<std::string> written_;
};

}  // namespace ballpark::command
