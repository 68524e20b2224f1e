// Every pair tested: the oracle of the grid.
#pragma once

#include "engine/collide/near.h"

namespace ballpark::BALLPARK_PRECISION {

/// Calls act(a, b), a < b, for each near pair of rows. A ball whose position is not finite is near nothing.
template <class Act>
void for_each_near_pair(const Balls& balls, const Period& period, Act act) {
  for (std::size_t b = 0; b < balls.count; ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      Real d[3];
      for (int c = 0; c < 3; ++c) d[c] = nearest_image(balls.position[c][a] - balls.position[c][b], period.length[c]);
      const Real reach = balls.radius.at<Real>(a) + balls.radius.at<Real>(b) + balls.margin;
      if (within(d[0], d[1], d[2], reach)) act(a, b);
    }
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
