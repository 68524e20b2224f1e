// What each local effect adds to a fused step, beside what it adds to a loop written by hand for it alone.
#pragma once

#include "perf/throughput/benchmarks.h"

namespace ballpark::perf {

/// Prints a table. False if a price is above its bar, 1.5 times the hand-written one or 2 ns, or if the two disagree.
bool bars(const Settings& settings);

}  // namespace ballpark::perf
