// The machine and the compiler behind a figure.
#pragma once

#include <cstddef>
#include <string>

namespace ballpark::perf {

struct Machine {
  std::string processor;
  int threads;                             ///< that can run at once
  std::size_t level2_bytes, level3_bytes;  ///< of one such cache; 0: unknown
  std::size_t memory_bytes;
  std::string compiler;  ///< that built this library
  double load;           ///< of the last minute: above 0, others used the machine too
};

Machine machine();

}  // namespace ballpark::perf
