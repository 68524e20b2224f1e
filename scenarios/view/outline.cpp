#include "scenarios/view/outline.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <utility>

namespace ballpark::view {
namespace {

std::vector<Line> edges(const Vector3d& centre, const Vector3d& size) {
  std::vector<Line> lines;
  const auto corner = [&](int k) {
    return Vector3d(centre + 0.5 * size.cwiseProduct(Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  };
  for (int k = 0; k < 8; ++k) {
    for (const int axis : {1, 2, 4}) {
      if (!(k & axis)) lines.push_back({corner(k), corner(k | axis)});
    }
  }
  return lines;
}

/// Two directions across `normal`, along the axes where they can be.
std::pair<Vector3d, Vector3d> across(const Vector3d& normal) {
  const Vector3d first = (std::abs(normal.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY()).eval();
  const Vector3d u = (first - normal * normal.dot(first)).normalized();
  return {u, normal.cross(u)};
}

std::vector<Line> grid(const Vector3d& point, const Vector3d& normal, const Box& box) {
  constexpr int cells = 10;
  const Vector3d middle = box.centre() - normal * normal.dot(box.centre() - point);
  const auto [u, v] = across(normal);
  const double half = 0.6 * box.diagonal();
  std::vector<Line> lines;
  for (int k = 0; k <= cells; ++k) {
    const double at = half * (2.0 * k / cells - 1);
    lines.push_back({middle + at * u - half * v, middle + at * u + half * v});
    lines.push_back({middle + at * v - half * u, middle + at * v + half * u});
  }
  return lines;
}

std::vector<Line> circles(const Vector3d& point, const Vector3d& axis, double radius, const Box& box) {
  constexpr int corners = 48, rings = 3, every = 6;  // lines along the tube
  const auto [u, v] = across(axis);
  const Vector3d middle = point + axis * axis.dot(box.centre() - point);
  const double half = 0.5 * (box.high - box.low).cwiseAbs().dot(axis.cwiseAbs());
  const auto rim = [&, u = u, v = v](int k, double at) {
    const double angle = 2 * std::numbers::pi * k / corners;
    return Vector3d(middle + at * axis + radius * (std::cos(angle) * u + std::sin(angle) * v));
  };
  std::vector<Line> lines;
  for (int k = 0; k < corners; ++k) {
    for (int ring = 0; ring < rings; ++ring) {
      const double at = half * (2.0 * ring / (rings - 1) - 1);
      lines.push_back({rim(k, at), rim(k + 1, at)});
    }
    if (k % every == 0) lines.push_back({rim(k, -half), rim(k, half)});
  }
  return lines;
}

}  // namespace

Vector3d displacement(const Boundary& boundary, double time) {
  if (!boundary.motion) return Vector3d::Zero();
  const Motion& motion = *boundary.motion;
  const double wave = std::sin(2 * std::numbers::pi * motion.frequency * time + motion.phase) - std::sin(motion.phase);
  return motion.velocity * time + motion.amplitude * wave;
}

std::vector<Line> outline(const Boundary& boundary, double time, const Box& box) {
  const Vector3d point = boundary.point + displacement(boundary, time);
  const Vector3d normal = boundary.normal.stableNormalized();
  if (boundary.shape == "plane") return grid(point, normal, box);
  if (boundary.shape == "tube") return circles(point, normal, boundary.radius, box);
  if (boundary.shape == "box") return edges(point, boundary.size);
  Vector3d size = boundary.size, centre = point;  // periodic: as long as the box where nothing repeats
  for (int c = 0; c < 3; ++c) {
    if (size[c] > 0) continue;
    size[c] = box.high[c] - box.low[c];
    centre[c] = box.centre()[c];
  }
  return edges(centre, size);
}

}  // namespace ballpark::view
