#include "scenarios/view/touching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "scenarios/view/outline.h"
#include "scenarios/view/shown.h"

namespace ballpark::view {
namespace {

constexpr double nearness = 0.01;  // of the radii: how far apart surfaces may be
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Ball {
  Vector3d position;
  double radius;
  std::size_t id;
};

using Cell = std::array<int, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::size_t hash = 0;
    for (const int c : cell) hash = (hash ^ static_cast<std::size_t>(c)) * 0x9E3779B97F4A7C15u;
    return hash ^ hash >> 29;
  }
};

/// Balls of one copy by the cell that they are in; where space repeats, so do the cells.
class Cells {
 public:
  Cells(std::vector<Ball> balls, const Vector3d& period) : balls_(std::move(balls)), period_(period) {
    double largest = 0;
    for (const Ball& ball : balls_) largest = std::max(largest, ball.radius);
    size_.setConstant(2 * largest * (1 + nearness));
    for (int c = 0; c < 3; ++c) {
      if (period_[c] == 0) continue;
      count_[c] = std::max(1, static_cast<int>(period_[c] / size_[c]));
      size_[c] = period_[c] / count_[c];
    }
    for (std::size_t i = 0; i < balls_.size(); ++i) cells_[cell_of(balls_[i].position, {0, 0, 0})].push_back(i);
  }

  void count_pairs(std::vector<int>& touches) const {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      for (const Cell& cell : around(balls_[i].position)) {
        const auto found = cells_.find(cell);
        if (found == cells_.end()) continue;
        for (const std::size_t j : found->second) {
          if (j != i && touch(balls_[i], balls_[j])) ++touches[balls_[i].id];
        }
      }
    }
  }

 private:
  Cell cell_of(const Vector3d& position, const Cell& step) const {
    Cell cell;
    for (int c = 0; c < 3; ++c) {
      const double place = std::floor(position[c] / size_[c]) + step[c];
      const double wrapped = period_[c] == 0 ? place : place - count_[c] * std::floor(place / count_[c]);
      cell[c] = static_cast<int>(std::clamp(wrapped, -2e9, 2e9));
    }
    return cell;
  }

  std::vector<Cell> around(const Vector3d& position) const {
    std::vector<Cell> cells;
    for (int k = 0; k < 27; ++k) cells.push_back(cell_of(position, {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1}));
    std::sort(cells.begin(), cells.end());  // few cells repeat themselves
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
  }

  bool touch(const Ball& a, const Ball& b) const {
    Vector3d apart = a.position - b.position;
    for (int c = 0; c < 3; ++c) {
      if (period_[c] > 0) apart[c] -= period_[c] * std::round(apart[c] / period_[c]);
    }
    return apart.norm() < (a.radius + b.radius) * (1 + nearness);
  }

  std::vector<Ball> balls_;
  Vector3d period_, size_;
  Cell count_{1, 1, 1};
  std::unordered_map<Cell, std::vector<std::size_t>, CellHash> cells_;
};

/// Distances of a point from the faces of a boundary, on the side of the bodies.
std::vector<double> gaps(const Boundary& boundary, const Vector3d& from) {
  const Vector3d half = boundary.size / 2;
  if (boundary.shape == "plane") return {from.dot(boundary.normal.stableNormalized())};
  if (boundary.shape == "tube") {
    const Vector3d axis = boundary.normal.stableNormalized();
    return {boundary.radius - (from - axis * axis.dot(from)).norm()};
  }
  if (boundary.shape != "box") return {};
  if (boundary.side != "inside") return {(from.cwiseAbs() - half).cwiseMax(0.0).norm()};
  const auto open = [&](const char* face) {
    return std::find(boundary.open.begin(), boundary.open.end(), face) != boundary.open.end();
  };
  constexpr const char* low[] = {"-x", "-y", "-z"};
  constexpr const char* high[] = {"+x", "+y", "+z"};
  std::vector<double> all;
  for (int c = 0; c < 3; ++c) {
    all.push_back(open(low[c]) ? infinite : half[c] + from[c]);
    all.push_back(open(high[c]) ? infinite : half[c] - from[c]);
  }
  return all;
}

/// Those of one copy that have a shape and are finite.
std::vector<Ball> balls_of(const Scene& scene, const World& world, const std::vector<std::size_t>& counts,
                           std::size_t first_id) {
  std::vector<Ball> balls;
  for (std::size_t g = 0; g < counts.size(); ++g) {
    const BodyGroup& group = scene.bodies[g];
    for (std::size_t row = 0; row < counts[g] && !group.shape.empty(); ++row) {
      const Ball ball{world.body(first_id + row).position, group.radius[group.radius.size() == 1 ? 0 : row],
                      first_id + row};
      if (ball.position.allFinite()) balls.push_back(ball);
    }
    first_id += counts[g];
  }
  return balls;
}

}  // namespace

std::vector<std::uint8_t> touching(const Scene& scene, const World& world, int copies) {
  std::vector<int> touches(world.body_count());
  const std::vector<std::size_t> counts = group_counts(scene, world, copies);
  const std::size_t per_copy = world.body_count() / static_cast<std::size_t>(copies);
  Vector3d period = Vector3d::Zero();
  for (const Boundary& boundary : scene.boundaries) {
    if (boundary.shape == "periodic") period = boundary.size;
  }
  for (std::size_t first = 0; first < world.body_count() && !scene.contact.kind.empty(); first += per_copy) {
    const std::vector<Ball> balls = balls_of(scene, world, counts, first);
    Cells(balls, period).count_pairs(touches);
    for (const Boundary& boundary : scene.boundaries) {
      const Vector3d place = boundary.point + displacement(boundary, world.time());
      for (const Ball& ball : balls) {
        for (const double gap : gaps(boundary, ball.position - place)) {
          touches[ball.id] += gap < ball.radius * (1 + nearness);
        }
      }
    }
  }
  std::vector<std::uint8_t> bytes;
  for (const int count : touches) bytes.push_back(static_cast<std::uint8_t>(std::min(count, 255)));
  return bytes;
}

}  // namespace ballpark::view
