// ballpark cost: error against wall time over the ways to run a scene.
#include <fmt/format.h>

#include "ballpark/scenes.h"
#include "perf/cost/cost.h"
#include "perf/cost/result_json.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/cost_options.h"
#include "scenarios/command/cost_text.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

/// The command as it can be typed again.
std::string command_of(const Arguments& arguments) {
  std::string command = "ballpark cost " + arguments.name;
  for (const std::string& text : arguments.overrides) command += " --set " + text;
  const std::pair<const char*, const std::optional<std::string>&> options[] = {
      {"--integrators", arguments.integrators}, {"--steps", arguments.axis_steps},
      {"--tolerances", arguments.tolerances},   {"--precisions", arguments.precisions},
      {"--rotations", arguments.rotations},     {"--contacts", arguments.axis_contacts},
      {"--openings", arguments.openings},       {"--error", arguments.error},
      {"--reference", arguments.reference},     {"--seconds", arguments.seconds},
      {"--tolerance", arguments.tolerance},     {"--budget", arguments.budget},
      {"--copies", arguments.copies},           {"--perturb", arguments.perturb},
      {"--threads", arguments.threads},         {"--target", arguments.target}};
  for (const auto& [name, value] : options) {
    if (value) command += fmt::format(" {} {}", name, *value);
  }
  return command;
}

Exit verdict(const cost::Request& request, const cost::Result& result) {
  if (!request.tolerance && !request.budget) return done;
  if (!result.recommended) {
    complain(request.tolerance ? fmt::format("no setting that was tried is within {} {} with a margin of {:g}",
                                             *request.tolerance, result.measure_unit, request.margin)
                               : "no setting that was tried is within the budget");
    return check_failed;
  }
  if (!request.tolerance || result.recommended->confirmed_error <= *request.tolerance) return done;
  complain("the fresh run of the named setting missed the tolerance");
  return check_failed;
}

}  // namespace

Exit cost_of_accuracy(const Arguments& arguments) {
  const scenes::SceneFile file = load_scene(arguments);
  cost::Request request = cost_request(arguments, file.scene);
  if (!file.events.empty()) request.events = scenes::events_of(file, World(file.scene, request.options));
  Delivery delivery(arguments);
  CostFiles files(arguments, file);
  watch_for_interrupt();
  std::optional<cost::Result> result;
  {
    Progress progress("measuring", !arguments.quiet);
    result = cost::cost(file.scene, request, [&](const std::string& what, double fraction) {
      progress.show(overall(what, fraction));
      return !interrupted();
    });
  }
  if (interrupted()) return interrupted_exit;
  if (!result) {
    complain(no_reference);
    return check_failed;
  }
  result->command = command_of(arguments);
  delivery.text(cost_text(*result));
  const Json json = cost::to_json(*result);
  delivery.json(json.dump(2));
  const std::string written = files.write(*result, json);
  if (!written.empty()) delivery.text(written);
  return verdict(request, *result);
}

}  // namespace ballpark::command
