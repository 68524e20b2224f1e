// The marks that show how a ball is turned, as a camera sees them.
#pragma once

#include <vector>

#include "perf/cost/draw/canvas.h"
#include "scenarios/view/drawing.h"

namespace ballpark::view {

/// Outline of a visible piece of a mark, in pixels.
struct Stripe {
  Colour colour;
  std::vector<cost::draw::Spot> outline;
};

/// A white band about the body's z axis, and above it half a dark one across, as pictures of pixels have them. None for
/// a body that does not turn.
std::vector<Stripe> stripes(const Ball& ball, const Camera& camera);

}  // namespace ballpark::view
