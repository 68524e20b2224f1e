// The names in the chart: of the points that matter, then of the curves in colour, then of the others.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "perf/cost/draw/chart.h"

namespace ballpark::cost::draw {

namespace {

constexpr double line_height = 1.22;

std::string halo(double width) {
  return fmt::format("paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
                     coordinate(width));
}

}  // namespace

bool Chart::put(Canvas& canvas, const Label& label) {
  double width = 0;
  for (const std::string& line : label.lines) {
    width = std::max(width, text_width(line, label.size) * (label.bold ? 1.08 : 1));
  }
  const double line = label.size * line_height, height = line * static_cast<double>(label.lines.size());
  const auto placed = placer_.place(width, height, label.anchors);
  if (!placed) return false;
  if (placed->far) {
    canvas.line(placed->anchor, placed->leader_end, fmt::format("stroke=\"{}\" stroke-width=\"0.7\"", label.leader));
  }
  // Towards what it names, so that an estimate of its width that is too large leaves no gap.
  const double middle = (placed->box.left + placed->box.right) / 2;
  const bool left = placed->anchor.x <= placed->box.left, right = placed->anchor.x >= placed->box.right;
  const double x = left ? placed->box.left : right ? placed->box.right : middle;
  const std::string attributes =
      fmt::format("fill=\"{}\"{} text-anchor=\"{}\" {}", label.ink, label.bold ? " font-weight=\"600\"" : "",
                  left    ? "start"
                  : right ? "end"
                          : "middle",
                  halo(label.size / 4));
  for (std::size_t i = 0; i < label.lines.size(); ++i) {
    const double y = placed->box.top + line * (static_cast<double>(i) + 0.8);
    canvas.text({x, y}, label.lines[i], label.size, attributes);
  }
  return true;
}

void Chart::keep_labels_off() {
  for (std::size_t i = 0; i < looks_.size(); ++i) {
    const double weight = looks_[i].strong ? 1.5 : 0.7;
    const std::vector<std::size_t> points = drawable_points(result_.curves[i]);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Spot at = spot(result_.points[points[k]]);
      if (k > 0) placer_.avoid(spot(result_.points[points[k - 1]]), at, weight);
      placer_.avoid({at.x - 4, at.y}, {at.x + 4, at.y}, 3 * weight);
    }
  }
  const std::vector<Spot> stairs = front_stairs();
  for (std::size_t i = 1; i < stairs.size(); ++i) placer_.avoid(stairs[i - 1], stairs[i], 1);
}

bool Chart::is_recommended(std::size_t point) const {
  return result_.recommended && result_.recommended->point == point;
}

bool Chart::is_own(std::size_t point) const {
  return result_.scene_setting && equal(*result_.scene_setting, result_.points[point].setting);
}

void Chart::draw_special_points(Canvas& canvas) {
  std::vector<std::size_t> special;
  for (std::size_t i = 0; i < result_.points.size(); ++i) {
    if (drawable(result_.points[i]) && (is_recommended(i) || is_own(i))) special.push_back(i);
  }
  std::stable_partition(special.begin(), special.end(), [&](std::size_t i) { return is_recommended(i); });
  for (const std::size_t i : special) {
    const Spot at = spot(result_.points[i]);
    const std::string ring = fmt::format("class=\"{}\" fill=\"none\"", is_recommended(i) ? "recommended" : "own");
    canvas.circle(at, 9, ring + " stroke=\"#ffffff\" stroke-width=\"5\"");
    canvas.circle(at, 9,
                  ring + fmt::format(" stroke=\"{}\" stroke-width=\"2\"{}", dark,
                                     is_recommended(i) ? "" : " stroke-dasharray=\"3 2.5\""));
    placer_.forbid({at.x - 9, at.y - 9, at.x + 9, at.y + 9});
  }
  for (const std::size_t i : special) name_point(canvas, i);
}

void Chart::name_point(Canvas& canvas, std::size_t index) {
  const Point& point = result_.points[index];
  const Spot at = spot(point);
  std::string heading = is_recommended(index) ? "recommended" : "as the scene has it";
  if (is_recommended(index) && is_own(index)) heading += ", and as the scene has it";
  const std::string unit = result_.measure_unit.empty() ? "" : " " + result_.measure_unit;
  std::vector<Anchor> around;
  for (const Spot d : {Spot{10, 0}, {-10, 0}, {0, 10}, {0, -10}}) around.push_back({{at.x + d.x, at.y + d.y}, 0});
  put(canvas,
      {{heading + ": " + setting_text(point.setting), number(point.error) + unit + " in " + seconds(cost_of(point))},
       12.5,
       dark,
       true,
       around,
       dark});
}

std::vector<Anchor> Chart::anchors_of(const Curve& curve) const {
  const std::vector<std::size_t> points = drawable_points(curve);
  std::vector<Anchor> anchors;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool last = k + 1 == points.size(), first = k == 0;
    anchors.push_back({spot(result_.points[points[k]]), last ? 0.0 : first ? 10.0 : 20.0});
  }
  return anchors;
}

void Chart::name_curves(Canvas& canvas) {
  std::vector<std::size_t> order(looks_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return looks_[i].strong; });
  for (const std::size_t i : order) {
    const Curve& curve = result_.curves[i];
    const std::vector<Anchor> anchors = anchors_of(curve);
    if (anchors.empty()) continue;
    const bool strong = looks_[i].strong;
    const Label label{{curve.label}, strong ? 12.5 : 10.5, looks_[i].colour.ink, strong,
                      anchors,       looks_[i].colour.line};
    if (!put(canvas, label)) unplaced_.push_back(curve.label);
  }
  if (unplaced_.empty()) return;
  canvas.text({plot_.left, plot_.bottom + 62},
              fmt::format("without a name for want of room: {}", fmt::join(unplaced_, "; ")), 10.5,
              fmt::format("fill=\"{}\"", medium));
}

}  // namespace ballpark::cost::draw
