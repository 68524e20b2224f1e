// Frames that a run has written, read back one after the other.
#pragma once

#include <memory>
#include <string>

#include "scenarios/command/frames.h"

namespace ballpark::command {

/// All that is wrong with a file throws UsageError, with its name.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// Columns as they are in the file; among them position.
  const FrameLayout& layout() const { return layout_; }
  /// About so many frames will come.
  virtual std::size_t frames() const = 0;
  /// The next frame, alone; false after the last.
  virtual bool next(Frames& frame) = 0;

 protected:
  FrameLayout layout_;
};

/// Is this a file of frames by its ending, whether it can be read or not?
bool is_frame_file(const std::string& path);
/// .npz, and .csv.
std::unique_ptr<FrameSource> open_frame_source(const std::string& path);
std::unique_ptr<FrameSource> open_npz(const std::string& path);
std::unique_ptr<FrameSource> open_csv(const std::string& path);

/// "'a.npz' cannot be shown: it has no array 'position'"
[[noreturn]] void refuse_frames(const std::string& path, const std::string& why);

}  // namespace ballpark::command
