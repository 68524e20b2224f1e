// How a picture looks at bodies: the same as the page's first view.
#pragma once

#include "scenarios/view/recording.h"

namespace ballpark::view {

/// A place in the picture, in pixels from its upper left corner; `depth`: distance along the line of sight [m].
struct Seen {
  double x = 0, y = 0, depth = 0;
};

struct Camera {
  Vector3d eye, right, up, forward;
  double focal = 1;  ///< pixels that a length has which is as far away as it is long
  double centre_x = 0, centre_y = 0;

  Vector3d in_view(const Vector3d& point) const;  ///< along right, up and forward, from the eye [m]
  Seen see(const Vector3d& point) const;          ///< of points before the eye
};

/// Obliquely from above; flat motions are seen from before their plane.
Vector3d usual_direction(const Box& box);

/// Looks at the centre of the box from `direction`, z upwards, from where all of it is in a picture of this size.
Camera camera_on(const Box& box, const Vector3d& direction, int width, int height);

}  // namespace ballpark::view
