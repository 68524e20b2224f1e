// The work-precision figure as a picture that needs nothing else: for a README, a report, a page of print.
#pragma once

#include <string>

#include "perf/cost/result.h"

namespace ballpark::cost {

/// Error against wall time, both logarithmic, one line a curve, and below it the paths if there are any. Every point
/// that can be drawn is: an error of zero lies on the edge of the axis.
std::string svg(const Result& result);

}  // namespace ballpark::cost
