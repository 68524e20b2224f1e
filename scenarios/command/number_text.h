// Numbers as files hold them: read back, they are the same to the last bit of their precision.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace ballpark::command {

/// Not a number has no sign: "-nan" means nothing to a reader.
inline double unsigned_nan(double value) {
  return std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value;
}

/// As few digits as do.
inline void append_shortest(fmt::memory_buffer& text, double value, bool single) {
  value = unsigned_nan(value);
  if (single) {
    fmt::format_to(fmt::appender(text), "{}", static_cast<float>(value));
  } else {
    fmt::format_to(fmt::appender(text), "{}", value);
  }
}

/// 9 or 17 digits.
inline void append_digits(fmt::memory_buffer& text, double value, bool single) {
  value = unsigned_nan(value);
  if (single) {
    fmt::format_to(fmt::appender(text), "{:.9g}", static_cast<float>(value));
  } else {
    fmt::format_to(fmt::appender(text), "{:.17g}", value);
  }
}

}  // namespace ballpark::command
