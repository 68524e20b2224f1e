#include "engine/contact/contact_bodies.h"

#include <numeric>

namespace ballpark::BALLPARK_PRECISION {

void ContactBodies::resize(std::size_t n, bool solved) {
  count = n;
  for (auto* values : {&radius, &inverse_mass, &mobility}) values->resize(n);
  material.resize(n);
  for (auto* column : {&position, &velocity, &surface}) column->resize(n);
  if (!solved) return;
  for (auto* column : {&end_position, &end_velocity, &end_surface}) column->resize(n);
}

void ContactBodies::sort(const std::vector<std::uint32_t>& order) {
  const auto permute = [&](auto& values, auto& spare) {  // no memory is asked for: what is spare is read anew later
    for (std::size_t slot = 0; slot < count; ++slot) spare[slot] = values[order[slot]];
    values.swap(spare);
  };
  if (ranks.empty()) {
    ranks.resize(count);
    std::iota(ranks.begin(), ranks.end(), 0u);
    slots.resize(count);
    spare_material.resize(count);
  }
  for (auto* values : {&radius, &inverse_mass, &mobility}) permute(*values, end_position.x);
  permute(material, spare_material);
  permute(ranks, slots);
  for (std::uint32_t slot = 0; slot < count; ++slot) slots[ranks[slot]] = slot;
}

std::size_t ContactBodies::bytes() const {
  const auto bytes_of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  std::size_t sum = bytes_of(ranks) + bytes_of(slots) + bytes_of(spare_material) + bytes_of(radius) +
                    bytes_of(inverse_mass) + bytes_of(mobility) + bytes_of(material);
  for (const auto* column : {&position, &velocity, &surface, &end_position, &end_velocity, &end_surface, &turned}) {
    sum += column->bytes();
  }
  return sum;
}

}  // namespace ballpark::BALLPARK_PRECISION
