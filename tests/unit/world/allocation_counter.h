// How often this program, with all that it links, has asked for heap memory.
#pragma once

#include <cstdint>

namespace allocation_counter {

std::uint64_t allocations();

/// Keeps the compiler from removing an allocation that nobody reads.
void use(const void* memory);

}  // namespace allocation_counter
