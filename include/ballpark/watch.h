// When something happens: an apex, a landing, a passage. Between two steps of a run, which takes them as if nobody
// watched.
//
//   double height = ...;
//   std::vector<ballpark::Watch> watches{{[&] { return world.body(0).position.z() - height; },
//                                         [&](double t, bool rising) { ... }}};
//   ballpark::advance_watching(world, 10, watches);
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>

#include "ballpark/world.h"

namespace ballpark {

struct Watch {
  std::function<double()> value;                       ///< of the world as it is: its zeros are looked for
  std::function<void(double time, bool rising)> seen;  ///< called at a zero [s], with the world as it is then
};

/// Takes the steps of World::advance_to(end), no more than `most_steps`. Where a value has another sign after a step
/// than before (or is 0 after it), the time of its zero is found to rounding by a bracket of looks (World::look_ahead),
/// about ten; zeros of one step are seen in the order of their times. Two zeros of one value within a step are not
/// seen. Costs a copy of the state each step, and a step each look.
void advance_watching(World& world, double end, std::span<const Watch> watches,
                      std::uint64_t most_steps = std::numeric_limits<std::uint64_t>::max());

}  // namespace ballpark
