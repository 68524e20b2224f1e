// How long a trajectory means something.
#pragma once

#include "perf/cost/subject.h"

namespace ballpark::cost {

/// nullopt if runs that start almost alike stay together.
std::optional<Horizon> find_horizon(const Scene& scene, const Options& options, const GoOn& go_on);

}  // namespace ballpark::cost
