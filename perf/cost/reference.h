// What errors are held against: a closed form; else extrapolation in extended precision; else the two finest runs.
#pragma once

#include <string>

#include "perf/cost/subject.h"

namespace ballpark::cost {

/// A reference track with the error that it may have itself.
struct ReferenceTrack {
  Reference about;
  Track track;
};

/// nullopt unless every body has one, and nothing happens to it on the way.
std::optional<ReferenceTrack> closed_form(const Scene& scene, const Samples& samples, const Options& options);

/// By extrapolation in extended precision at two tolerances; where that is refused, fails or takes longer than
/// `seconds`, the finest of two runs. nullopt if it was stopped, or every run ended badly.
std::optional<ReferenceTrack> numerical_reference(const Scene& scene, const Samples& samples, const Options& options,
                                                  double seconds, const GoOn& go_on);
/// The finest of two runs at once.
std::optional<ReferenceTrack> finest_runs(const Scene& scene, const Samples& samples, const Options& options,
                                          double seconds, const GoOn& go_on);

}  // namespace ballpark::cost
