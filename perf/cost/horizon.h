// How long a trajectory means something.
#pragma once

#include "perf/cost/subject.h"

namespace ballpark::cost {

/// Growth of a distance that takes half of double's digits.
inline constexpr double lost = 1e8;
/// nullopt if the distance of runs that start almost alike does not grow so far.
std::optional<Horizon> find_horizon(const Scene& scene, const Options& options, const GoOn& go_on,
                                    double growth = lost);

}  // namespace ballpark::cost
