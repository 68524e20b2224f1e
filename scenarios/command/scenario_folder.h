// Where scenarios stand, and how a SCENE on the command line is found.
#pragma once

#include <string>
#include <vector>

namespace ballpark::command {

struct Scenario {
  std::string name, file;
};

/// All scenarios, by name.
std::vector<Scenario> scenarios();
/// The hard cases, which stand in a folder of their own among them; none if it is not there.
std::vector<Scenario> stress_cases();
/// Both.
std::vector<Scenario> all_scenes();
/// The file of a hard case, by its name or as a path. Throws UsageError with the nearest name.
std::string stress_path(const std::string& name);
/// The file that a SCENE means. Throws UsageError with the nearest name if there is none.
std::string scene_path(const std::string& scene);
/// The comment that a scene file starts with, without the '#'.
std::string leading_comment(const std::string& file);

}  // namespace ballpark::command
