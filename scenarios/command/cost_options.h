// What the options of `ballpark cost` and `ballpark order` ask for.
#pragma once

#include "perf/cost/cost.h"
#include "scenarios/command/arguments.h"

namespace ballpark::command {

/// Throws UsageError that names the option and what it takes.
cost::Request cost_request(const Arguments& arguments, const Scene& scene);

}  // namespace ballpark::command
