// Numbers as bytes, in either precision.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace ballpark::command {

template <class T>
std::string_view bytes_of(std::span<const T> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

template <class T>
std::string_view bytes_of(const std::vector<T>& numbers) {
  return bytes_of(std::span<const T>(numbers));
}

/// Calls write(bytes) for one piece after the other: what is narrowed is still in the cache when it is written.
template <class Write>
void write_numbers(std::span<const double> values, bool single, const Write& write) {
  if (!single) return write(bytes_of(values));
  constexpr std::size_t most = 1 << 13;
  std::array<float, most> piece;
  while (!values.empty()) {
    const std::size_t n = std::min(most, values.size());
    for (std::size_t i = 0; i < n; ++i) piece[i] = static_cast<float>(values[i]);
    write(bytes_of(std::span<const float>(piece.data(), n)));
    values = values.subspan(n);
  }
}

}  // namespace ballpark::command
