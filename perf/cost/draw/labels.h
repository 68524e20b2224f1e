// Where labels go: near what they name, never on each other, off the lines if they can be.
#pragma once

#include <optional>
#include <vector>

#include "perf/cost/draw/canvas.h"

namespace ballpark::cost::draw {

/// Where a label may be tied to; of two that are as near, the one with less `penalty` [px] is taken.
struct Anchor {
  Spot spot;
  double penalty = 0;
};

struct Placed {
  Box box;
  Spot anchor;
  bool far = false;  ///< a line should lead to it
  Spot leader_end;
};

/// Labels are placed one after the other, each where it costs least.
class Placer {
 public:
  explicit Placer(const Box& bounds) : bounds_(bounds) {}
  /// What must stay free.
  void forbid(const Box& box) { taken_.push_back(box); }
  /// What had better stay free: `weight` is the cost of a pixel of it under a label.
  void avoid(Spot from, Spot to, double weight) { lines_.push_back({from, to, weight}); }
  /// None only if no place in the bounds is free.
  std::optional<Placed> place(double width, double height, const std::vector<Anchor>& anchors);

 private:
  struct Line {
    Spot from, to;
    double weight;
  };
  std::optional<Placed> search(double width, double height, const std::vector<Anchor>& anchors,
                               bool leaders_free) const;
  bool free(const Box& box) const;
  double hidden(const Box& box, double least) const;
  bool leads_freely(Spot from, Spot to) const;

  Box bounds_;
  std::vector<Box> taken_;
  std::vector<Line> lines_;
};

}  // namespace ballpark::cost::draw
