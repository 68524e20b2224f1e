// When frames are due.
#pragma once

#include <optional>
#include <vector>

#include "ballpark/scene.h"

namespace ballpark::view {

/// From 0 to `end` [s], the same distance apart: `frames` of them, or one every `every` seconds. A run takes each at
/// its nearest step, so that there is at most one in a step; with a tolerance, exactly there.
std::vector<double> frame_times(double end, std::size_t frames, std::optional<double> every = {});

/// Frames that a run makes of these times: those that share a step are one, and none is beyond its end.
std::size_t frames_of(const RunSettings& run, const std::vector<double>& times);

}  // namespace ballpark::view
