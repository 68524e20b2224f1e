// One function a command: prints, and returns the exit code. What went wrong is thrown (errors.h).
#pragma once

#include <string>
#include <vector>

#include "scenarios/command/arguments.h"
#include "scenarios/command/errors.h"

namespace ballpark::command {

Exit list(const Arguments& arguments);
Exit describe(const Arguments& arguments);
Exit run(const Arguments& arguments);
Exit explain(const Arguments& arguments);
Exit check_scene(const Arguments& arguments);
Exit view_motion(const Arguments& arguments);
Exit profile(const Arguments& arguments);
Exit cost_of_accuracy(const Arguments& arguments);
Exit order_of_accuracy(const Arguments& arguments);
Exit ablate_effects(const Arguments& arguments);
Exit prices_of_effects(const Arguments& arguments);
Exit stress(const Arguments& arguments);

/// What `list` can show, in order.
const std::vector<std::string>& list_sections();

}  // namespace ballpark::command
