#include "perf/cost/draw/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ballpark::cost::draw {

namespace {

constexpr double near = 12;  // [px] from its anchor a label needs no line that leads to it

/// Length of the part of a line that lies in a box (Liang and Barsky 1984).
double length_inside(Spot from, Spot to, const Box& box) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  double enter = 0, leave = 1;
  const std::array<double, 4> run{-dx, dx, -dy, dy};
  const std::array<double, 4> room{from.x - box.left, box.right - from.x, from.y - box.top, box.bottom - from.y};
  for (std::size_t side = 0; side < 4; ++side) {
    if (run[side] == 0) {
      if (room[side] < 0) return 0;
    } else if (run[side] < 0) {
      enter = std::max(enter, room[side] / run[side]);
    } else {
      leave = std::min(leave, room[side] / run[side]);
    }
  }
  return enter < leave ? (leave - enter) * std::hypot(dx, dy) : 0;
}

Spot nearest(const Box& box, Spot spot) {
  return {std::clamp(spot.x, box.left, box.right), std::clamp(spot.y, box.top, box.bottom)};
}

/// A box whose edge is `gap` away from the spot, in a direction.
Box beside(Spot spot, double width, double height, double angle, double gap) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const double x = spot.x + gap * cosine + (cosine > 0.3 ? 0 : cosine < -0.3 ? -width : -width / 2);
  const double y = spot.y + gap * sine + (sine > 0.3 ? 0 : sine < -0.3 ? -height : -height / 2);
  return {x, y, x + width, y + height};
}

}  // namespace

bool Placer::free(const Box& box) const {
  if (box.left < bounds_.left || box.right > bounds_.right || box.top < bounds_.top || box.bottom > bounds_.bottom) {
    return false;
  }
  constexpr double apart = 5;
  return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
    return box.left < other.right + apart && other.left < box.right + apart && box.top < other.bottom &&
           other.top < box.bottom;
  });
}

double Placer::hidden(const Box& box, double least) const {
  double cost = 0;
  for (const Line& line : lines_) {
    if (cost > least) return cost;
    cost += line.weight * length_inside(line.from, line.to, box);
  }
  return cost;
}

bool Placer::leads_freely(Spot from, Spot to) const {
  return std::all_of(taken_.begin(), taken_.end(),
                     [&](const Box& other) { return length_inside(from, to, other) == 0; });
}

std::optional<Placed> Placer::place(double width, double height, const std::vector<Anchor>& anchors) {
  std::optional<Placed> best = search(width, height, anchors, true);
  if (!best) best = search(width, height, anchors, false);
  if (!best) return best;
  taken_.push_back(best->box);
  if (best->far) avoid(best->anchor, best->leader_end, 1);
  return best;
}

std::optional<Placed> Placer::search(double width, double height, const std::vector<Anchor>& anchors,
                                     bool leaders_free) const {
  constexpr std::array<double, 13> gaps{5, 8, 12, 18, 26, 36, 50, 70, 95, 130, 180, 250, 340};
  constexpr int directions = 24;
  std::optional<Placed> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double gap : gaps) {
    for (const Anchor& anchor : anchors) {
      const double distance_cost = anchor.penalty + gap + (gap > near ? 12 : 0);
      if (distance_cost >= least) continue;
      for (int turn = 0; turn < directions; ++turn) {
        const Box box = beside(anchor.spot, width, height, 2 * M_PI * turn / directions, gap);
        if (!free(box)) continue;
        const double cost = distance_cost + hidden(box, least - distance_cost);
        if (cost >= least) continue;
        const Spot end = nearest(box, anchor.spot);
        if (leaders_free && gap > near && !leads_freely(anchor.spot, end)) continue;
        best = Placed{box, anchor.spot, gap > near, end};
        least = cost;
      }
    }
  }
  return best;
}

}  // namespace ballpark::cost::draw
