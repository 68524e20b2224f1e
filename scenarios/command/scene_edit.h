// Changes of a scene file's [run] and [contact] tables that leave the rest of its text as it is.
#pragma once

#include <string>

#include "ballpark/scenes.h"
#include "perf/cost/result.h"

namespace ballpark::command {

/// The text of the file with the setting in place of its own. Throws UsageError if the text can't be edited line by
/// line, or would not load as meant.
std::string with_setting(const std::string& text, const scenes::SceneFile& file, const cost::Setting& setting);

}  // namespace ballpark::command
