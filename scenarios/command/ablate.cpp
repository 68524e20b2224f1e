// ballpark ablate: what each effect of a scene is worth.
#include "perf/effects/ablation.h"

#include "scenarios/command/ablate_text.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/cost_options.h"
#include "scenarios/command/cost_text.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"

namespace ballpark::command {

Exit ablate_effects(const Arguments& arguments) {
  scenes::SceneFile file = load_scene(arguments);
  if (arguments.precision) file.scene.run.precision = *run_options(arguments).precision;
  Arguments rest = arguments;
  rest.precision.reset();
  cost::Request request = cost_request(rest, file.scene);
  if (!arguments.seconds) request.seconds = 30;
  Delivery delivery(arguments);
  watch_for_interrupt();
  std::optional<cost::Ablation> ablation;
  {
    Progress progress("measuring", !arguments.quiet);
    ablation = cost::ablate(file, request, [&](const std::string& what, double fraction) {
      progress.show(overall(what, fraction));
      return !interrupted();
    });
  }
  if (interrupted()) return interrupted_exit;
  if (!ablation) {
    complain(no_reference);
    return check_failed;
  }
  if (!ablation->trouble.empty()) {
    complain("the scene itself, with all effects: " + ablation->trouble);
    return contract_left;
  }
  delivery.text(ablation_text(*ablation));
  delivery.json(ablation_json(*ablation).dump(2));
  return done;
}

}  // namespace ballpark::command
