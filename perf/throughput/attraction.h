// Stars that attract each other: every pair beside a hand-written loop, and what the tree gets wrong and takes.
#pragma once

#include "perf/throughput/benchmarks.h"

namespace ballpark::perf {

Comparison attraction(const Settings& settings);

struct TreeSettings {
  std::size_t bodies = 1'000'000;
  int threads = 2;
};

/// Forces on 1,000 stars of a Plummer sphere by the tree beside the sum over all, for opening angles from 0.2 to 1, and
/// the time of an evaluation. Prints a table. False if the error at 0.5 is 1 % or more.
bool tree(const TreeSettings& settings);

}  // namespace ballpark::perf
