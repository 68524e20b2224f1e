// The state of a world at several times, in a file.
#pragma once

#include <memory>
#include <string>

#include "ballpark/world.h"

namespace ballpark::command {

class FrameFile {
 public:
  virtual ~FrameFile() = default;
  virtual void add(const World& world) = 0;  ///< throws WriteError
  virtual void finish() = 0;                 ///< the file is there only after this; throws WriteError
};

/// By the ending of `path`: .npz or .csv. Throws DestinationError.
std::unique_ptr<FrameFile> open_frame_file(const std::string& path);

}  // namespace ballpark::command
