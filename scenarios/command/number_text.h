// Numbers as files hold them: read back, they are the same to the last bit of their precision.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

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

/// The bytes of the values in either precision. Valid while `values` and `narrowed` stay.
inline std::string_view raw_bytes(std::span<const double> values, bool single, std::vector<float>& narrowed) {
  if (!single) return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
  narrowed.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) narrowed[i] = static_cast<float>(values[i]);
  return {reinterpret_cast<const char*>(narrowed.data()), narrowed.size() * sizeof(float)};
}

}  // namespace ballpark::command
