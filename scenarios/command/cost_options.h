// What the options of `ballpark cost` and `ballpark order` ask for.
#pragma once

#include "perf/cost/cost.h"
#include "scenarios/command/arguments.h"

namespace ballpark::command {

inline constexpr const char* no_reference =
    "no reference was found: runs ended badly, or the two finest that --seconds leaves time for do not agree; try more "
    "time, or a shorter run.duration";

/// Throws UsageError that names the option and what it takes, or why the scene has no error to measure.
cost::Request cost_request(const Arguments& arguments, const Scene& scene);

}  // namespace ballpark::command
