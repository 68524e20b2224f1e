// The broad phase beside a peer.
#pragma once

#include "perf/throughput/benchmarks.h"

namespace ballpark::perf {

Comparison neighbours(const Settings& settings);

}  // namespace ballpark::perf
