// What `ballpark ablate` prints, and its JSON.
#pragma once

#include <string>

#include "perf/effects/ablation.h"
#include "scenarios/command/deliver.h"

namespace ballpark::command {

std::string ablation_text(const cost::Ablation& ablation);
Json ablation_json(const cost::Ablation& ablation);

}  // namespace ballpark::command
