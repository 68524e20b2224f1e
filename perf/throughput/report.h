// The suite's results, as tables for a reader and as JSON.
#pragma once

#include <string>
#include <vector>

#include "perf/machine.h"
#include "perf/throughput/benchmarks.h"
#include "perf/throughput/comparison.h"

namespace ballpark::perf {

std::string heading(const Machine& machine, const Settings& settings);
std::string to_text(const Result& result);
std::string to_json(const Machine& machine, const Settings& settings, const std::vector<Result>& results);

}  // namespace ballpark::perf
