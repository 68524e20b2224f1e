// The panels of the figure.
#pragma once

#include <vector>

#include "perf/cost/draw/axis.h"
#include "perf/cost/draw/canvas.h"
#include "perf/cost/draw/labels.h"
#include "perf/cost/draw/look.h"
#include "perf/cost/result.h"

namespace ballpark::cost::draw {

/// Error against wall time.
class Chart {
 public:
  /// `plot`: within the axes; `around`: how far labels may go.
  Chart(const Result& result, const Box& plot, const Box& around);
  void draw(Canvas& canvas);

 private:
  struct Label {
    std::vector<std::string> lines;
    double size;
    const char* ink;
    bool bold;
    std::vector<Anchor> anchors;
    const char* leader;  ///< colour of the line that leads to it
  };
  Spot spot(const Point& point) const { return {error_(point.error), time_(cost_of(point))}; }
  void draw_grid(Canvas& canvas) const;
  void draw_error_axis(Canvas& canvas) const;
  void draw_time_axis(Canvas& canvas) const;
  void draw_floor(Canvas& canvas);
  std::vector<Spot> front_stairs() const;
  void draw_front(Canvas& canvas) const;
  void draw_curve(Canvas& canvas, std::size_t curve) const;
  void draw_markers(Canvas& canvas, std::size_t curve) const;
  void keep_labels_off();
  bool is_recommended(std::size_t point) const;
  bool is_own(std::size_t point) const;  ///< as the scene has it
  void draw_special_points(Canvas& canvas);
  void name_point(Canvas& canvas, std::size_t point);
  void name_curves(Canvas& canvas);
  std::vector<Anchor> anchors_of(const Curve& curve) const;
  bool put(Canvas& canvas, const Label& label);
  std::vector<std::size_t> drawable_points(const Curve& curve) const;

  const Result& result_;
  Box plot_;
  std::vector<Look> looks_;
  LogAxis error_, time_;
  Placer placer_;
  std::vector<std::string> unplaced_;
};

/// What the shapes and strokes mean; one line of text high.
void draw_key(Canvas& canvas, const Result& result, Spot at);

/// The paths, to scale, in a panel as wide as `width` whose height is returned.
double draw_paths(Canvas& canvas, const Result& result, Spot corner, double width);

}  // namespace ballpark::cost::draw
