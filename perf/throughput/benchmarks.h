// The comparisons of the suite, as data. Each is built when its turn comes, so that only one holds memory.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "perf/throughput/comparison.h"

namespace ballpark::perf {

struct Settings {
  std::size_t bodies = 1'000'000;  ///< of the main comparison; no table has more
  int threads = 2;                 ///< whose gain is compared with the triad's
  double seconds = 3;              ///< for each comparison, at least
};

struct Benchmark {
  std::string name;  ///< to choose it by
  std::function<Comparison(const Settings&)> build;
};

const std::vector<Benchmark>& benchmarks();

}  // namespace ballpark::perf
