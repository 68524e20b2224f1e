// Slots: bodies in the order of their ids, copy after copy. What works between bodies sees slots, never rows.
#pragma once

#include <cstddef>
#include <vector>

namespace ballpark::BALLPARK_PRECISION {

struct Group;

/// Rows [first_row, first_row + count) of a group are the slots from first_slot on: some of one copy's bodies.
struct SlotRange {
  std::size_t group = 0, first_row = 0, first_slot = 0, count = 0;
};

/// Ranges of the bodies of `chosen` groups (their indices), in the order of slots, none longer than a task.
/// Slots of copy c begin at c stride; stride 0: right behind those of the copy before.
std::vector<SlotRange> slot_ranges(const std::vector<Group>& groups, std::vector<std::size_t> chosen,
                                   std::size_t copies, std::size_t stride = 0);

}  // namespace ballpark::BALLPARK_PRECISION
