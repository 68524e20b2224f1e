// How many contacts each body has, by geometry.
#pragma once

#include <cstdint>
#include <vector>

#include "ballpark/world.h"

namespace ballpark::view {

/// By id: bodies and faces of boundaries that the body touches, at most 255. To touch is to be nearer, surface to
/// surface, than a hundredth of the radius (of both radii together). Zero where the scene has no contacts.
std::vector<std::uint8_t> touching(const Scene& scene, const World& world, int copies);

}  // namespace ballpark::view
