// What writing the series of a run took, for its summary and its JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenarios/command/series.h"

namespace ballpark::command {

/// "41 frames, 1.2 MB: 3 ms on another thread; the run stood still 50 us meanwhile"
std::string series_text(const std::vector<SeriesCost>& costs);
nlohmann::ordered_json series_json(const std::vector<SeriesCost>& costs);

}  // namespace ballpark::command
