// A result as JSON ("ballpark-cost-1"), and its points as CSV.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "perf/cost/result.h"

namespace ballpark::cost {

const char* word(Precision precision);
nlohmann::ordered_json to_json(const Result& result);
std::string to_csv(const Result& result);

}  // namespace ballpark::cost
