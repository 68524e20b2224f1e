#include "scenarios/command/scenario_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "ballpark/catalogue.h"
#include "scenarios/command/errors.h"

namespace ballpark::command {
namespace {

namespace fs = std::filesystem;

/// The environment's choice; else beside the installed program; else the source tree.
fs::path scenario_folder() {
  if (const char* chosen = std::getenv("BALLPARK_SCENARIOS"); chosen && *chosen) return chosen;
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  const fs::path installed = program.parent_path().parent_path() / "share/ballpark/scenarios";
  return fs::is_directory(installed, unknown) ? installed : fs::path(BALLPARK_SCENARIOS_FOLDER);
}

bool is_path(const std::string& scene) {
  return scene.find('/') != std::string::npos || scene.ends_with(".toml");
}

}  // namespace

std::vector<Scenario> scenarios() {
  std::vector<Scenario> found;
  std::error_code error;
  const fs::path folder = scenario_folder();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const fs::path& file = entry.path();
    std::error_code unknown;
    if (file.extension() == ".toml" && entry.is_regular_file(unknown))
      found.push_back({file.stem().string(), file.string()});
  }
  if (error) throw UsageError(fmt::format("no scenarios in '{}': {}", folder.string(), error.message()));
  std::sort(found.begin(), found.end(), [](const Scenario& a, const Scenario& b) { return a.name < b.name; });
  return found;
}

std::string scene_path(const std::string& scene) {
  std::error_code unknown;
  if (is_path(scene) || fs::is_regular_file(scene, unknown)) return scene;
  std::vector<std::string> names;
  for (const Scenario& scenario : scenarios()) {
    if (scenario.name == scene) return scenario.file;
    names.push_back(scenario.name);
  }
  const std::string near = nearest(scene, names);
  throw UsageError(fmt::format("no scenario and no file is named '{}'{}; `ballpark list scenarios` shows all", scene,
                               near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

std::string leading_comment(const std::string& file) {
  std::ifstream stream(file);
  std::string comment;
  for (std::string line; std::getline(stream, line) && line.starts_with("#");) {
    const std::size_t start = line.find_first_not_of("# ");
    comment += (start == std::string::npos ? "" : line.substr(line.starts_with("# ") ? 2 : 1)) + "\n";
  }
  return comment;
}

}  // namespace ballpark::command
