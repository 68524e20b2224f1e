// ballpark check: everything that would stop a run, without running.
#include <fmt/format.h>

#include "ballpark/scenes.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/run_files.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

Json problems_json(const scenes::SceneFileError& error) {
  Json problems = Json::array();
  for (const scenes::LocatedProblem& problem : error.problems()) {
    problems.push_back({{"file", problem.location.file},
                        {"line", problem.location.line},
                        {"column", problem.location.column},
                        {"key", problem.key},
                        {"message", problem.message}});
  }
  return {{"ok", false}, {"problems", problems}};
}

/// All that a run does before its first step: what it would refuse is thrown, what it would warn of is returned.
std::vector<std::string> try_to_start(scenes::SceneFile file, const Arguments& arguments, const Options& options) {
  check_memory(file.scene, options);
  const RunFiles files(file, arguments);
  file.scene.run.duration = 0;
  return scenes::run(file, options).warnings;
}

}  // namespace

Exit check_scene(const Arguments& arguments) {
  Delivery delivery(arguments);
  try {
    const Options options = run_options(arguments);
    const scenes::SceneFile file = load_scene(arguments);
    const std::vector<std::string> warnings = try_to_start(file, arguments, options);
    const std::string bodies = counted(body_count(file.scene), "body", "bodies");
    delivery.text(fmt::format("ok: {} ({}, {})\n", file.scene.name, bodies, pace_text(file.scene.run)));
    const Json json{{"ok", true},
                    {"scenario", file.scene.name},
                    {"file", file.path},
                    {"warnings", warnings},
                    {"problems", Json::array()}};
    delivery.json(json.dump(2));
    if (!arguments.quiet) warn(warnings);
    return done;
  } catch (const scenes::SceneFileError& error) {
    delivery.json(problems_json(error).dump(2));
    throw;
  }
}

}  // namespace ballpark::command
