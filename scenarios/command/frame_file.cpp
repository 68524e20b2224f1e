#include "scenarios/command/frame_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "scenarios/command/csv.h"
#include "scenarios/command/errors.h"
#include "scenarios/command/npz.h"

namespace ballpark::command {

std::unique_ptr<FrameFile> open_frame_file(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".npz") return std::make_unique<NpzFrames>(path);
  if (ending == ".csv") return std::make_unique<CsvFrames>(path);
  throw DestinationError(fmt::format("cannot write '{}': its name must end in .npz (NumPy) or .csv", path));
}

}  // namespace ballpark::command
