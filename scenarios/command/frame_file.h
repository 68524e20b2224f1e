// The state of a world at several times, in a file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "ballpark/scenes.h"
#include "scenarios/command/frames.h"

namespace ballpark::command {

/// Opened when it is built: what cannot be written throws DestinationError. All else throws WriteError.
class FrameFile {
 public:
  virtual ~FrameFile() = default;              ///< what is not finished is gone
  virtual void begin(const FrameLayout&) = 0;  ///< once, before all else
  virtual void add(const Frames& frames) = 0;
  virtual void finish() = 0;  ///< puts the file in place
  virtual std::uint64_t bytes() const = 0;
};

/// By the ending of the request's file.
std::unique_ptr<FrameFile> open_frame_file(const scenes::OutputRequest& request, const Scene& scene);
/// The file that the request's frames are found by: the .pvd of a .vtp.
std::string frame_file_name(const std::string& path);

}  // namespace ballpark::command
