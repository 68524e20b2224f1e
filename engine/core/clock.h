// Wall time, for profiles only: nothing that shapes a result reads it.
#pragma once

#include <chrono>

namespace ballpark {

inline double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace ballpark
