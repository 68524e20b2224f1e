#include "scenarios/view/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "perf/cost/draw/axis.h"
#include "perf/cost/draw/canvas.h"

namespace ballpark::view {
namespace {

using cost::draw::Canvas, cost::draw::coordinate, cost::draw::Spot;

constexpr double width = 900, left = 88, right = 876, panel_height = 92, between = 42;

/// Okabe and Ito 2008; the second set is for dark ground. Those who see no colour have the dashes.
constexpr const char* style =
    "<style>\n"
    "text { fill: #57606a } .ink { fill: #1f2328 } .paper { fill: #ffffff }\n"
    "polyline, .sample { fill: none; stroke-width: 1.6; stroke-linejoin: round }\n"
    ".grid { stroke: #e4e8ec } .base { stroke: #8c959f }\n"
    ".curve-0 { stroke: #1f2328 } .curve-1 { stroke: #0072b2; stroke-dasharray: 7 2 }\n"
    ".curve-2 { stroke: #d55e00; stroke-dasharray: 2 2 } .alone { stroke: #0072b2 }\n"
    "@media (prefers-color-scheme: dark) {\n"
    "  text { fill: #9aa4ae } .ink { fill: #e6e9ec } .paper { fill: #14171b }\n"
    "  .grid { stroke: #2a3138 } .base { stroke: #6b7682 }\n"
    "  .curve-0 { stroke: #e6e9ec } .curve-1 { stroke: #4aa8e0 } .curve-2 { stroke: #f0813a } .alone { stroke: #4aa8e0 "
    "}\n"
    "}\n"
    "</style>\n";
constexpr std::size_t most_curves = 3;  // that have a style

struct Scale {
  double low = 0, high = 1, from = 0, to = 0;  ///< values, and where they are drawn
  double operator()(double value) const { return from + (to - from) * (value - low) / (high - low); }
};

struct Panel {
  std::string title;
  std::span<const Series> curves;
  double origin = 0;  ///< what is subtracted from all values
};

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool any() const { return low <= high; }
  double range() const { return high - low; }
  double size() const { return std::max(std::abs(low), std::abs(high)); }
};

Extent extent_of(std::span<const Series> curves) {
  Extent extent;
  for (const Series& curve : curves) {
    for (const double value : curve.values) {
      if (std::isfinite(value)) extent = {std::min(extent.low, value), std::max(extent.high, value)};
    }
  }
  return extent;
}

std::string in_unit(const std::string& words, const std::string& unit) {
  return unit.empty() ? words : words + " [" + unit + "]";
}

Panel change_panel(const Series& curve) {
  const auto first =
      std::find_if(curve.values.begin(), curve.values.end(), [](double value) { return std::isfinite(value); });
  const double origin = first == curve.values.end() ? 0 : *first;
  const std::string start = cost::draw::number(origin);
  return {in_unit(fmt::format("{}: change since the start at {}", curve.name, start), curve.unit), {&curve, 1}, origin};
}

std::vector<Panel> panels_of(const std::vector<Series>& series) {
  std::vector<Panel> panels;
  for (std::size_t first = 0, last = 0; first < series.size(); first = last) {
    while (last < series.size() && last - first < most_curves && series[last].unit == series[first].unit) ++last;
    const std::span<const Series> curves = std::span(series).subspan(first, last - first);
    const Extent extent = extent_of(curves.first(1));
    const bool varies = extent.high > extent.low;
    const bool still = varies && extent.range() < 2e-3 * extent.size();
    const bool flat = varies && extent.range() < 0.05 * extent_of(curves).range();
    if (curves.size() > 1 || !still) panels.push_back({in_unit(curves[0].name, curves[0].unit), curves});
    if (still || flat) panels.push_back(change_panel(curves[0]));
  }
  return panels;
}

/// Measured times have outliers, when the machine did something else: they shall not flatten the rest.
double usual_top(const Series& curve, double highest) {
  std::vector<double> sorted;
  std::copy_if(curve.values.begin(), curve.values.end(), std::back_inserter(sorted),
               [](double value) { return std::isfinite(value); });
  std::sort(sorted.begin(), sorted.end());
  return sorted.empty() ? highest : std::min(highest, 2 * sorted[sorted.size() * 19 / 20]);
}

/// Values with some room above and below; from zero on where that is near.
Scale scale_of(Panel& panel, double top, double bottom) {
  Extent extent = extent_of(panel.curves);
  if (!extent.any()) return {0, 1, bottom, top};
  extent = {extent.low - panel.origin, extent.high - panel.origin};
  if (panel.curves[0].unit == "ns") {
    const double usual = usual_top(panel.curves[0], extent.high);
    if (usual < extent.high) panel.title += fmt::format(", once {:.0f}", extent.high);
    extent.high = usual;
  }
  const double room = 0.06 * (extent.high - extent.low);
  const bool from_zero = extent.low >= 0 && extent.low < 0.5 * extent.high;
  if (!(room > 0)) {
    const double half = extent.high != 0 ? 0.5 * std::abs(extent.high) : 1;
    return {extent.low - half, extent.high + half, bottom, top};
  }
  return {from_zero ? 0 : extent.low - room, extent.high + room, bottom, top};
}

/// As few digits as tell multiples of the step apart.
std::string level_text(double value, double step) {
  if (value == 0) return "0";
  const int place = static_cast<int>(std::floor(std::log10(step) + 1e-9));
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
  if (exponent >= -3 && exponent < 5) return fmt::format("{:.{}f}", value, std::max(0, -place));
  return fmt::format("{:.{}g}e{}", value / std::pow(10.0, exponent), std::max(1, exponent - place + 1), exponent);
}

std::vector<std::pair<double, std::string>> levels(double low, double high, int most) {
  std::vector<std::pair<double, std::string>> found;
  const std::vector<double> values = cost::draw::round_values(low, high, most);
  const double step = values.size() > 1 ? values[1] - values[0] : values.empty() ? 1 : std::abs(values[0]);
  for (const double value : values) found.push_back({value, level_text(value, step > 0 ? step : 1)});
  return found;
}

void draw_curve(Canvas& canvas, const Figure& figure, const Series& curve, double origin, const Scale& x,
                const Scale& y, const std::string& attributes) {
  std::vector<Spot> spots;
  const auto end = [&] {
    if (spots.size() == 1) spots.push_back({spots[0].x + 1, spots[0].y});
    if (!spots.empty()) canvas.polyline(spots, attributes);
    spots.clear();
  };
  for (std::size_t i = 0; i < std::min(figure.times.size(), curve.values.size()); ++i) {
    const double value = curve.values[i] - origin;
    if (!std::isfinite(value)) {
      end();
    } else {
      spots.push_back({x(figure.times[i]), y(std::min(value, y.high))});
    }
  }
  end();
}

std::string style_of(std::size_t curve, std::size_t of) {
  return of == 1 ? "alone" : fmt::format("curve-{}", curve);
}

/// Names with a piece of their line, from the right.
void draw_key(Canvas& canvas, const Panel& panel, double y) {
  constexpr double size = 12.5, sample = 26, gap = 18;
  double x = right;
  for (std::size_t i = panel.curves.size(); i-- > 0;) {
    x -= cost::draw::text_width(panel.curves[i].name, size);
    canvas.text({x, y}, panel.curves[i].name, size, "");
    canvas.line({x - 6 - sample, y - 4}, {x - 6, y - 4},
                fmt::format("class=\"sample {}\"", style_of(i, panel.curves.size())));
    x -= 6 + sample + gap;
  }
}

void draw_panel(Canvas& canvas, const Figure& figure, Panel panel, const Scale& x, double top) {
  const double bottom = top + panel_height;
  const Scale y = scale_of(panel, top, bottom);
  for (const auto& [value, label] : levels(y.low, y.high, 4)) {
    canvas.line({left, y(value)}, {right, y(value)}, value == 0 ? "class=\"base\"" : "class=\"grid\"");
    canvas.text({left - 8, y(value) + 4}, label, 12, "text-anchor=\"end\"");
  }
  for (const auto& [value, label] : levels(x.low, x.high, 10)) {
    canvas.line({x(value), top}, {x(value), bottom}, "class=\"grid\"");
  }
  canvas.line({left, bottom}, {right, bottom}, "class=\"base\"");
  for (std::size_t i = panel.curves.size(); i-- > 0;) {  // the first above the others
    draw_curve(canvas, figure, panel.curves[i], panel.origin, x, y,
               fmt::format("class=\"{}\"", style_of(i, panel.curves.size())));
  }
  canvas.text({left, top - 10}, panel.title, 13.5, "class=\"ink\" font-weight=\"600\"");
  if (panel.curves.size() > 1) draw_key(canvas, panel, top - 10);
}

/// Returns where the panels begin.
double draw_head(Canvas& canvas, const Figure& figure) {
  double y = 34;
  canvas.text({24, y}, figure.title, 20, "class=\"ink\" font-weight=\"600\"");
  for (const std::string& paragraph : figure.paragraphs) {
    for (const std::string& line : cost::draw::lines_of(paragraph, 13, width - 48)) {
      y += 19;
      canvas.text({24, y}, line, 13, "");
    }
  }
  return y + between;
}

}  // namespace

std::string svg(const Figure& figure) {
  Canvas body;
  double top = draw_head(body, figure);
  const bool some = figure.times.size() > 1;
  const Scale x{some ? figure.times.front() : 0, some ? figure.times.back() : 1, left, right};
  for (const Panel& panel : panels_of(figure.series)) {
    draw_panel(body, figure, panel, x, top);
    top += panel_height + between;
  }
  const double axis = top - between + 18;
  for (const auto& [value, label] : levels(x.low, x.high, 10)) {
    body.text({x(value), axis}, label, 12, "text-anchor=\"middle\"");
  }
  body.text({(left + right) / 2, axis + 22}, "t [s]", 13, "class=\"ink\" text-anchor=\"middle\"");
  const double height = axis + 38;
  Canvas whole;
  whole.raw(
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
                  "role=\"img\" font-family=\"system-ui, -apple-system, 'Segoe UI', 'Helvetica Neue', Arial, "
                  "sans-serif\">\n<title>{2}</title>\n{3}",
                  coordinate(width), coordinate(height), cost::draw::escaped(figure.title), style));
  whole.box({0, 0, width, height}, "class=\"paper\"");
  whole.raw(body.text() + "</svg>\n");
  return whole.text();
}

}  // namespace ballpark::view
