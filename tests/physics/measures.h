// Quantities of a world's first body, read in the world's own precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ballpark/ballpark.h"

namespace ballpark::tests {

using Numbers = std::vector<long double>;

template <class Real>
Numbers first_row(const World& world, const std::string& column) {
  const View<Real> view = world.view<Real>(column);
  Numbers values;
  for (const auto& component : view.components) values.push_back(component[world.row_of(0) - view.first_row]);
  return values;
}

inline Numbers column(const World& world, const std::string& name) {
  switch (world.precision()) {
    case Precision::single_:
      return first_row<float>(world, name);
    case Precision::extended:
      return first_row<long double>(world, name);
    case Precision::double_:
      break;
  }
  return first_row<double>(world, name);
}

inline Numbers position(const World& world) {
  return column(world, "position");
}
inline Numbers velocity(const World& world) {
  return column(world, "velocity");
}

/// q and -q are one rotation: the sign that makes the largest component positive.
inline Numbers one_sign(Numbers q) {
  const auto largest =
      *std::max_element(q.begin(), q.end(), [](long double a, long double b) { return std::abs(a) < std::abs(b); });
  if (largest < 0) {
    for (long double& component : q) component = -component;
  }
  return q;
}
inline Numbers orientation(const World& world) {
  return one_sign(column(world, "orientation"));
}

/// World-frame vector in the frame of a body with orientation q.
inline Numbers in_body_frame(const Numbers& q, const Numbers& a) {
  const long double w = q[0], x = q[1], y = q[2], z = q[3];
  return {(1 - 2 * (y * y + z * z)) * a[0] + 2 * (x * y + w * z) * a[1] + 2 * (x * z - w * y) * a[2],
          2 * (x * y - w * z) * a[0] + (1 - 2 * (x * x + z * z)) * a[1] + 2 * (y * z + w * x) * a[2],
          2 * (x * z + w * y) * a[0] + 2 * (y * z - w * x) * a[1] + (1 - 2 * (x * x + y * y)) * a[2]};
}

/// Angular velocity in the body frame, from the angular momentum.
inline Numbers body_spin(const World& world, const Vector3d& inertia) {
  Numbers spin = in_body_frame(column(world, "orientation"), column(world, "angular_momentum"));
  for (std::size_t c = 0; c < 3; ++c) spin[c] /= inertia[static_cast<Eigen::Index>(c)];
  return spin;
}

/// Of a pendulum of 1 m in the plane y = 0, from straight down [rad]; and its rate.
inline long double pendulum_angle(const World& world) {
  const Numbers x = position(world);
  return std::atan2(x[0], -x[2]);
}
inline long double pendulum_rate(const World& world) {
  const Numbers x = position(world), v = velocity(world);
  return (x[0] * v[2] - x[2] * v[0]) / (x[0] * x[0] + x[2] * x[2]);
}

inline long double largest(const Numbers& values) {
  long double most = 0;
  for (const long double value : values) {
    if (!(std::abs(value) <= most)) most = std::abs(value);  // a NaN stays
  }
  return most;
}
inline long double largest_difference(const Numbers& a, const Numbers& b) {
  long double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const long double difference = std::abs(a[i] - b[i]);
    if (!(difference <= most)) most = difference;  // likewise
  }
  return most;
}

}  // namespace ballpark::tests
