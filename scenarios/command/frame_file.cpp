#include "scenarios/command/frame_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "scenarios/command/csv.h"
#include "scenarios/command/errors.h"
#include "scenarios/command/npz.h"
#include "scenarios/command/vtp.h"
#include "scenarios/command/xyz.h"
#include "scenarios/files/output_formats.h"

namespace ballpark::command {

std::unique_ptr<FrameFile> open_frame_file(const scenes::OutputRequest& request, const Scene& scene) {
  const std::string path = frame_file_name(request.file);
  const std::string ending = std::filesystem::path(path).extension().string();
  const scenes::OutputFormat* format = scenes::output_format(path);
  if (!format || format->ending != ending) {
    throw DestinationError(fmt::format("cannot write '{}': its name must end in {}", path, scenes::output_endings()));
  }
  const bool single = request.precision.empty() ? format->single : request.precision == "single";
  if (ending == ".npz") return std::make_unique<NpzFrames>(path, single);
  if (ending == ".csv") return std::make_unique<CsvFrames>(path, single);
  if (ending == ".xyz") return std::make_unique<XyzFrames>(path, single, xyz_cell(scene));
  return std::make_unique<VtpFrames>(path, single);
}

std::string frame_file_name(const std::string& path) {
  const std::filesystem::path name(path);
  return name.extension() == ".vtp" ? std::filesystem::path(name).replace_extension(".pvd").string() : path;
}

}  // namespace ballpark::command
