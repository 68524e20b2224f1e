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

/// Is it, or is it meant to be?
bool is_file(const std::string& scene) {
  std::error_code unknown;
  return scene.find('/') != std::string::npos || scene.ends_with(".toml") || fs::is_regular_file(scene, unknown);
}

std::vector<Scenario> scenes_in(const fs::path& folder, std::error_code& error) {
  std::vector<Scenario> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const fs::path& file = entry.path();
    std::error_code unknown;
    if (file.extension() == ".toml" && entry.is_regular_file(unknown))
      found.push_back({file.stem().string(), file.string()});
  }
  std::sort(found.begin(), found.end(), [](const Scenario& a, const Scenario& b) { return a.name < b.name; });
  return found;
}

/// A file as it is named, else the scene of that name.
std::string path_among(const std::vector<Scenario>& scenes, const std::string& name, const std::string& what,
                       const std::string& section) {
  if (is_file(name)) return name;
  std::vector<std::string> names;
  for (const Scenario& scene : scenes) {
    if (scene.name == name) return scene.file;
    names.push_back(scene.name);
  }
  const std::string near = nearest(name, names);
  throw UsageError(fmt::format("no {} and no file is named '{}'{}; `ballpark list {}` shows all", what, name,
                               near.empty() ? "" : fmt::format("; did you mean '{}'?", near), section));
}

}  // namespace

std::vector<Scenario> scenarios() {
  std::error_code error;
  const fs::path folder = scenario_folder();
  std::vector<Scenario> found = scenes_in(folder, error);
  if (error) throw UsageError(fmt::format("no scenarios in '{}': {}", folder.string(), error.message()));
  return found;
}

std::vector<Scenario> stress_cases() {
  std::error_code not_there;
  return scenes_in(scenario_folder() / "stress", not_there);
}

std::vector<Scenario> all_scenes() {
  std::vector<Scenario> all = scenarios();
  for (Scenario& hard : stress_cases()) all.push_back(std::move(hard));
  return all;
}

std::string stress_path(const std::string& name) {
  return path_among(stress_cases(), name, "hard case", "stress");
}

std::string scene_path(const std::string& scene) {
  if (is_file(scene)) return scene;
  return path_among(all_scenes(), scene, "scenario", "scenarios");
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
