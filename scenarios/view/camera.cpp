#include "scenarios/view/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ballpark::view {

Vector3d Camera::in_view(const Vector3d& point) const {
  const Vector3d from_eye = point - eye;
  return {from_eye.dot(right), from_eye.dot(up), from_eye.dot(forward)};
}

Seen Camera::see(const Vector3d& point) const {
  const Vector3d p = in_view(point);
  return {centre_x + focal * p.x() / p.z(), centre_y - focal * p.y() / p.z(), p.z()};
}

Vector3d usual_direction(const Box& box) {
  constexpr double flat = 0.06, degree = std::numbers::pi / 180;
  const Vector3d size = box.high - box.low;
  const double least = flat * size.maxCoeff();
  const auto from = [](double azimuth, double elevation) {
    const double level = std::cos(elevation * degree);
    return Vector3d(level * std::cos(azimuth * degree), level * std::sin(azimuth * degree),
                    std::sin(elevation * degree));
  };
  if (size.y() < least && size.z() >= least) return from(-80, 10);
  if (size.x() < least && size.z() >= least) return from(10, 10);
  return size.z() < least ? from(-90, 52) : from(-62, 22);
}

Camera camera_on(const Box& box, const Vector3d& direction, int width, int height) {
  constexpr double half_angle = 16 * std::numbers::pi / 180, filled = 0.92;
  Camera camera;
  camera.forward = -direction.stableNormalized();
  const bool steep = camera.forward.head<2>().norm() < 1e-6;  // from straight above: y is up
  camera.right = camera.forward.cross(steep ? Vector3d::UnitY() : Vector3d::UnitZ()).normalized();
  camera.up = camera.right.cross(camera.forward);
  camera.centre_x = width / 2.0;
  camera.centre_y = height / 2.0;
  camera.focal = camera.centre_y / std::tan(half_angle);
  const Vector3d half = box.diagonal() > 0 ? (0.5 * (box.high - box.low)).eval() : Vector3d::Constant(0.5).eval();
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d p = half.cwiseProduct(Vector3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
    const double beside = std::abs(p.dot(camera.right)) / camera.centre_x,
                 above = std::abs(p.dot(camera.up)) / camera.centre_y;
    distance = std::max(distance, std::max(beside, above) * camera.focal / filled - p.dot(camera.forward));
  }
  camera.eye = box.centre() - distance * camera.forward;
  return camera;
}

}  // namespace ballpark::view
