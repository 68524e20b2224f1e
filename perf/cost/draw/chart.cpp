#include "perf/cost/draw/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ballpark::cost::draw {

namespace {

constexpr double floor_shown = 3;  // decades below the least error within which the floor is shown

LogAxis error_axis(const Result& result, const Box& plot) {
  std::vector<double> errors;
  for (const Point& point : result.points) {
    if (drawable(point) && point.error > 0) errors.push_back(point.error);
  }
  // What is wrong by far more than the path is long is put on the edge.
  const double scale = result.reference.scale[static_cast<std::size_t>(result.quantity)];
  if (scale > 0 && std::isfinite(scale)) {
    for (double& error : errors) error = std::min(error, 100 * scale);
  }
  Range range = range_of(errors, 0.35);
  if (result.floor > 0 && std::isfinite(result.floor)) {
    const double floor = std::log10(result.floor);
    if (errors.empty()) range = {floor - 1, floor + 3};
    if (floor > range.low - floor_shown) {
      range.low = std::max(std::min(range.low, floor - 0.8), floor - 2.5);
      range.high = std::max(range.high, floor + 1);
    }
  }
  return {range.low, range.high, plot.left, plot.right};
}

LogAxis time_axis(const Result& result, const Box& plot) {
  std::vector<double> times;
  for (const Point& point : result.points) {
    if (drawable(point)) times.push_back(cost_of(point));
  }
  if (times.empty()) times = {1e-5, 1e-2};
  const Range range = range_of(times, 0.25);
  return {range.low, range.high + 0.15, plot.bottom, plot.top};
}

}  // namespace

Chart::Chart(const Result& result, const Box& plot, const Box& around)
    : result_(result),
      plot_(plot),
      looks_(looks(result)),
      error_(error_axis(result, plot)),
      time_(time_axis(result, plot)),
      placer_(around) {}

void Chart::draw(Canvas& canvas) {
  canvas.box(plot_, "fill=\"#ffffff\"");
  draw_floor(canvas);
  draw_grid(canvas);
  draw_front(canvas);
  for (const bool strong : {false, true}) {
    for (std::size_t i = 0; i < looks_.size(); ++i) {
      if (looks_[i].strong != strong) continue;
      draw_curve(canvas, i);
      draw_markers(canvas, i);
    }
  }
  canvas.box(plot_, fmt::format("fill=\"none\" stroke=\"{}\"", faint));
  draw_error_axis(canvas);
  draw_time_axis(canvas);
  if (std::none_of(result_.points.begin(), result_.points.end(), drawable)) {
    canvas.text({(plot_.left + plot_.right) / 2, (plot_.top + plot_.bottom) / 2}, "no setting gave a result to draw",
                15, fmt::format("fill=\"{}\" text-anchor=\"middle\"", medium));
  }
  keep_labels_off();
  draw_special_points(canvas);
  name_curves(canvas);
}

void Chart::draw_grid(Canvas& canvas) const {
  canvas.open(fmt::format("stroke=\"{}\" stroke-width=\"1\"", grid));
  for (const Tick& tick : error_.powers(46)) {
    if (!tick.label.empty()) canvas.line({error_(tick.value), plot_.top}, {error_(tick.value), plot_.bottom}, "");
  }
  for (const Tick& tick : time_.times(24)) {
    if (!tick.label.empty()) canvas.line({plot_.left, time_(tick.value)}, {plot_.right, time_(tick.value)}, "");
  }
  canvas.close();
}

void Chart::draw_error_axis(Canvas& canvas) const {
  const double y = plot_.bottom, middle = (plot_.left + plot_.right) / 2;
  canvas.open(fmt::format("fill=\"{}\" text-anchor=\"middle\"", medium));
  for (const Tick& tick : error_.powers(46)) {
    const double x = error_(tick.value);
    canvas.line({x, y}, {x, y + (tick.label.empty() ? 3 : 6)}, fmt::format("stroke=\"{}\"", faint));
    if (!tick.label.empty()) canvas.power({x, y + 22}, tick.label, tick.exponent, 13, "");
  }
  const std::string unit = result_.measure_unit.empty() ? "" : " [" + result_.measure_unit + "]";
  canvas.text({middle, y + 44}, result_.measure + unit, 13.5, fmt::format("fill=\"{}\"", dark));
  canvas.close();
  canvas.text({plot_.left, y + 44}, "\u2190 more accurate", 12.5,
              fmt::format("fill=\"{}\" font-weight=\"600\"", medium));
}

void Chart::draw_time_axis(Canvas& canvas) const {
  canvas.open(fmt::format("fill=\"{}\" text-anchor=\"end\"", medium));
  for (const Tick& tick : time_.times(24)) {
    const double y = time_(tick.value);
    canvas.line({plot_.left - (tick.label.empty() ? 3 : 6), y}, {plot_.left, y}, fmt::format("stroke=\"{}\"", faint));
    if (!tick.label.empty()) canvas.text({plot_.left - 10, y + 4.5}, tick.label, 13, "");
  }
  canvas.close();
  const double x = plot_.left - 66, middle = (plot_.top + plot_.bottom) / 2;
  canvas.text({x, middle}, "wall time of a whole run", 13.5,
              fmt::format("fill=\"{}\" text-anchor=\"middle\" transform=\"rotate(-90 {} {})\"", dark, coordinate(x),
                          coordinate(middle)));
  canvas.text({x, plot_.bottom}, "\u2190 faster", 12.5,
              fmt::format("fill=\"{}\" font-weight=\"600\" transform=\"rotate(-90 {} {})\"", medium, coordinate(x),
                          coordinate(plot_.bottom)));
}

void Chart::draw_floor(Canvas& canvas) {
  if (!(result_.floor > 0) || !std::isfinite(result_.floor) || std::log10(result_.floor) <= error_.low()) return;
  const double x = error_(result_.floor);
  canvas.box({plot_.left, plot_.top, x, plot_.bottom}, "class=\"floor\" fill=\"#f3efe6\"");
  canvas.line({x, plot_.top}, {x, plot_.bottom}, "stroke=\"#b8a77f\" stroke-dasharray=\"2 3\"");
  const double size = 11, baseline = plot_.left + size + 4;
  const std::string words = "no error below " + number(result_.floor) +
                            (result_.measure_unit.empty() ? "" : " " + result_.measure_unit) + " is claimed";
  canvas.text({baseline, plot_.bottom - 8}, words, size,
              fmt::format("fill=\"#7d6b3d\" transform=\"rotate(-90 {} {})\"", coordinate(baseline),
                          coordinate(plot_.bottom - 8)));
  placer_.forbid({plot_.left, plot_.bottom - 10 - text_width(words, size), baseline + 4, plot_.bottom});
}

std::vector<Spot> Chart::front_stairs() const {
  std::vector<Spot> corners;
  for (const Point& point : result_.points) {
    if (point.front && drawable(point)) corners.push_back(spot(point));
  }
  std::sort(corners.begin(), corners.end(), [](Spot a, Spot b) { return a.x != b.x ? a.x < b.x : a.y > b.y; });
  std::vector<Spot> stairs;
  for (const Spot& corner : corners) {
    stairs.push_back({corner.x, stairs.empty() ? plot_.top : stairs.back().y});
    stairs.push_back(corner);
  }
  if (!stairs.empty()) stairs.push_back({plot_.right, stairs.back().y});
  return stairs;
}

void Chart::draw_front(Canvas& canvas) const {
  const std::vector<Spot> stairs = front_stairs();
  if (stairs.empty()) return;
  canvas.polyline(stairs,
                  "class=\"front\" fill=\"none\" stroke=\"#c9d1d9\" stroke-width=\"7\" stroke-linejoin=\"round\"");
}

std::vector<std::size_t> Chart::drawable_points(const Curve& curve) const {
  std::vector<std::size_t> found;
  for (const std::size_t index : curve.points) {
    if (index < result_.points.size() && drawable(result_.points[index])) found.push_back(index);
  }
  return found;
}

void Chart::draw_curve(Canvas& canvas, std::size_t curve) const {
  const Look& look = looks_[curve];
  const char* dashes = result_.curves[curve].precision == Precision::single_ ? " stroke-dasharray=\"5 3\"" : "";
  canvas.open(fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{}",
                          look.colour.line, look.strong ? "2" : "1", dashes));
  const auto end = [&](const std::vector<Spot>& run, bool claimed) {
    if (run.size() > 1) canvas.polyline(run, claimed ? "" : "opacity=\"0.35\"");
  };
  std::vector<Spot> run;
  bool run_claimed = true, last_claimed = true;
  for (const std::size_t index : drawable_points(result_.curves[curve])) {
    const Point& point = result_.points[index];
    const bool claimed = point.claimed && last_claimed;  // of the line from the point before
    if (run.size() > 1 && claimed != run_claimed) {
      end(run, run_claimed);
      run = {run.back()};
    }
    run.push_back(spot(point));
    run_claimed = run.size() > 1 ? claimed : point.claimed;
    last_claimed = point.claimed;
  }
  end(run, run_claimed);
  canvas.close();
}

void Chart::draw_markers(Canvas& canvas, std::size_t index) const {
  const Curve& curve = result_.curves[index];
  const Look& look = looks_[index];
  for (const bool claimed : {true, false}) {
    canvas.open(fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}", claimed ? look.colour.line : "#ffffff",
                            claimed ? "#ffffff" : look.colour.line, look.strong ? "0.8" : "0.5",
                            claimed ? "" : " opacity=\"0.6\""));
    for (const std::size_t point : drawable_points(curve)) {
      if (result_.points[point].claimed != claimed) continue;
      canvas.raw(marker(spot(result_.points[point]), curve.order, look.strong ? 4.2 : 2.4));
    }
    canvas.close();
  }
}

}  // namespace ballpark::cost::draw
