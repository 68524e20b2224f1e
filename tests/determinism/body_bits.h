// The bits of one body's state as they lie in the columns.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "ballpark/world.h"

namespace body_bits {

using Bits = std::vector<std::uint64_t>;

template <class Real>
void append(const ballpark::World& world, const std::string& column, std::size_t id, Bits& bits) {
  const ballpark::View<Real> view = world.view<Real>(column);
  for (const auto& component : view.components) {
    std::uint64_t word = 0;
    std::memcpy(&word, &component[world.row_of(id) - view.first_row], sizeof(Real));
    bits.push_back(word);
  }
}

/// All state columns that the body's group carries.
inline Bits of(const ballpark::World& world, std::size_t id) {
  const ballpark::BodyState state = world.body(id);
  std::vector<std::string> columns{"position", "velocity"};
  if (state.has_orientation) columns.push_back("orientation");
  if (state.has_angular_velocity) columns.push_back("angular_momentum");
  Bits bits;
  for (const std::string& column : columns) {
    if (world.precision() == ballpark::Precision::single_) {
      append<float>(world, column, id, bits);
    } else {
      append<double>(world, column, id, bits);
    }
  }
  return bits;
}

/// Of `count` bodies from id `first` on.
inline std::vector<Bits> of(const ballpark::World& world, std::size_t first, std::size_t count) {
  std::vector<Bits> all;
  for (std::size_t id = first; id < first + count; ++id) all.push_back(of(world, id));
  return all;
}

}  // namespace body_bits
