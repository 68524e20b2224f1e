// Effects beyond the horizon: what means over runs say of each.
#pragma once

#include "perf/effects/ablation.h"

namespace ballpark::cost {

/// Runs ensembles of the scene and of it without each effect, to the end of the whole duration, if there is time: one
/// run to the horizon takes `seconds`. Fills copies, perturb, and the means of each loss, or about.left_out. False if
/// it was stopped.
bool add_means(const Ground& ground, const scenes::SceneFile& file, const Request& request, double seconds,
               Ablation& ablation, const GoOn& go_on);

}  // namespace ballpark::cost
