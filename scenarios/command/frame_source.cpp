#include "scenarios/command/frame_source.h"

#include <fmt/format.h>

#include <filesystem>

#include "scenarios/command/errors.h"
#include "scenarios/files/output_formats.h"

namespace ballpark::command {

void refuse_frames(const std::string& path, const std::string& why) {
  throw UsageError(fmt::format("'{}' cannot be shown: {}", path, why));
}

bool is_frame_file(const std::string& path) {
  return scenes::output_format(path) != nullptr;
}

std::unique_ptr<FrameSource> open_frame_source(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) refuse_frames(path, "there is no such file");
  if (path.ends_with(".npz")) return open_npz(path);
  if (path.ends_with(".csv")) return open_csv(path);
  const std::string reader = scenes::output_format(path)->read_by;
  refuse_frames(path, fmt::format("of recorded files .npz and .csv are read here, this one is for {}", reader));
}

}  // namespace ballpark::command
