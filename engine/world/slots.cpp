#include "engine/world/slots.h"

#include <algorithm>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {
constexpr std::size_t longest = 2048;
}

std::vector<SlotRange> slot_ranges(const std::vector<Group>& groups, std::vector<std::size_t> chosen,
                                   std::size_t copies, std::size_t stride) {
  std::sort(chosen.begin(), chosen.end(),
            [&](std::size_t a, std::size_t b) { return groups[a].scene_index < groups[b].scene_index; });
  if (stride == 0) {
    for (const std::size_t g : chosen) stride += groups[g].copies.per_copy;
  }
  std::vector<SlotRange> ranges;
  for (std::size_t copy = 0; copy < copies; ++copy) {
    std::size_t slot = copy * stride;
    for (const std::size_t g : chosen) {
      const std::size_t bodies = groups[g].copies.per_copy;
      for (std::size_t first = 0; first < bodies; first += longest) {
        ranges.push_back({g, copy * bodies + first, slot + first, std::min(longest, bodies - first)});
      }
      slot += bodies;
    }
  }
  return ranges;
}

}  // namespace ballpark::BALLPARK_PRECISION
