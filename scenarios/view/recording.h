// What a run looked like: the shown bodies at each frame, as plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ballpark/scene.h"

namespace ballpark::view {

struct Box {
  Vector3d low = Vector3d::Zero(), high = Vector3d::Zero();
  Vector3d centre() const { return 0.5 * (low + high); }
  double diagonal() const { return (high - low).norm(); }
};

/// Shown bodies [first, first + count).
struct ShownGroup {
  std::string name;
  std::size_t first = 0, count = 0;
  std::vector<double> radius;  ///< none: points; one, or one for each [m]
  bool turns = false;          ///< has orientations
  double radius_of(std::size_t row) const { return radius.empty() ? 0 : radius[radius.size() == 1 ? 0 : row]; }
};

/// One number a frame.
struct Series {
  std::string name, unit;
  std::vector<double> values;
};

/// Columns are empty, or go by frame, then body, then component.
struct Recording {
  std::string scenario, label, doc;
  std::size_t bodies = 0, shown = 0, stride = 1;
  std::vector<double> times;  ///< [s]
  std::vector<ShownGroup> groups;
  std::vector<Boundary> boundaries;
  Vector3d origin = Vector3d::Zero();      ///< what positions are relative to, so that single precision does
  std::vector<float> position;             ///< x, y, z [m]; NaN: the body is not there
  std::vector<std::uint16_t> orientation;  ///< x, y, z of the quaternion with w >= 0; 0: -1, 65535: 1
  std::vector<float> speed;                ///< [m/s]
  std::vector<double> energy;              ///< kinetic [J]
  std::vector<std::uint8_t> contacts;      ///< of the body, at most 255
  std::vector<Series> series;
  std::vector<std::string> notes;
};

/// Of all positions, relative to `origin`.
Box box_of(const Recording& recording);
/// A point has none: this one is drawn [m].
double point_radius(const Recording& recording, const Box& box);
Quaternion orientation_of(const Recording& recording, std::size_t frame, std::size_t body);

/// Every factor-th body of each group, its first at least.
Recording thinned(const Recording& recording, std::size_t factor);

}  // namespace ballpark::view
