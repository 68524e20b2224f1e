// DROP: balls fall into an open box, beside other engines.
#pragma once

#include <cstddef>

namespace ballpark::perf {

struct DropSettings {
  std::size_t balls = 10000;
  int steps = 600;     ///< of 1/60 s
  int threads = 2;     ///< of a second Ballpark, beside the one on one thread
  bool alone = false;  ///< without the other engines
};

/// Runs all engines in turns and prints speed and overlap side by side.
void drop(const DropSettings& settings);

}  // namespace ballpark::perf
