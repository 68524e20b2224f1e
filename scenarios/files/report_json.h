// A run's report as a JSON value: what `to_json` prints, and where expectations look their numbers up.
#pragma once

#include <nlohmann/json.hpp>

#include "ballpark/scenes.h"

namespace ballpark::scenes {

using Json = nlohmann::ordered_json;

Json json_of(const RunReport& report);
Json json_of(const Verdict& verdict);

}  // namespace ballpark::scenes
