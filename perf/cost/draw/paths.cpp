// The paths to scale: what an error looks like.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "perf/cost/draw/chart.h"

namespace ballpark::cost::draw {

namespace {

constexpr std::array<const char*, 4> axis_names{"t [s]", "x [m]", "y [m]", "z [m]"};
constexpr double row_height = 18;
constexpr const char* black = "#000000";

struct Extent {
  double low = 0, high = 0;
  double length() const { return high - low; }
};

bool is_reference(const Path& path) {
  return path.label.rfind("reference", 0) == 0;
}

/// Of the reference if there is one: what runs away from it may leave the panel.
std::array<Extent, 4> extents(const Result& result) {
  const bool reference = std::any_of(result.paths.begin(), result.paths.end(), is_reference);
  std::array<Extent, 4> found;
  bool first = true;
  for (const Path& path : result.paths) {
    if (reference && !is_reference(path)) continue;
    for (const auto& point : path.points) {
      if (!std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); })) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        found[i] = first ? Extent{point[i], point[i]}
                         : Extent{std::min(found[i].low, point[i]), std::max(found[i].high, point[i])};
      }
      first = false;
    }
  }
  return found;
}

/// Which two components are drawn, and where.
struct View {
  std::size_t across = 1, up = 2;
  Box panel;
  double scale_across = 1, scale_up = 1;
  Extent along_across, along_up;
  Spot operator()(const std::array<double, 4>& point) const {
    return {(panel.left + panel.right) / 2 + (point[across] - middle(along_across)) * scale_across,
            (panel.top + panel.bottom) / 2 - (point[up] - middle(along_up)) * scale_up};
  }
  static double middle(const Extent& e) { return e.low / 2 + e.high / 2; }
};

double scale_for(double room, double length) {
  return length > 0 ? room / length : 1;
}

/// The two axes along which most happens, in equal scale; a motion along one line, against time.
View view_of(const Result& result, Spot corner, double width) {
  constexpr double greatest_height = 360, least_height = 120, margin = 1.12;
  const std::array<Extent, 4> all = extents(result);
  std::array<std::size_t, 3> axes{1, 2, 3};
  std::stable_sort(axes.begin(), axes.end(), [&](auto a, auto b) { return all[a].length() > all[b].length(); });
  const bool line = all[axes[1]].length() < 1e-6 * all[axes[0]].length() || all[axes[0]].length() == 0;
  View view;
  view.across = line ? 0 : std::min(axes[0], axes[1]);
  view.up = line ? axes[0] : std::max(axes[0], axes[1]);
  view.along_across = all[view.across];
  view.along_up = all[view.up];
  const double across = view.along_across.length() * margin, up = view.along_up.length() * margin;
  double height = line ? 220 : greatest_height;
  if (!line && across > 0) height = std::clamp(up * width / across, least_height, greatest_height);
  view.scale_across = scale_for(width, across);
  view.scale_up = scale_for(height, up);
  if (!line) view.scale_across = view.scale_up = std::min(view.scale_across, view.scale_up);
  view.panel = {corner.x, corner.y, corner.x + width, corner.y + height};
  return view;
}

/// Runs of points that can be drawn, without those that move less than a third of a pixel.
std::vector<std::vector<Spot>> runs_of(const Path& path, const View& view) {
  std::vector<std::vector<Spot>> runs(1);
  for (const auto& point : path.points) {
    const Spot at = view(point);
    if (!(std::abs(at.x) < 1e5 && std::abs(at.y) < 1e5)) {
      if (!runs.back().empty()) runs.emplace_back();
      continue;
    }
    const auto& run = runs.back();
    const bool last = &point == &path.points.back();
    if (run.empty() || last || std::hypot(at.x - run.back().x, at.y - run.back().y) > 0.33) runs.back().push_back(at);
  }
  return runs;
}

/// The colour of the integrator that a label begins with, so that both panels agree; else one that is not in the chart.
std::map<std::string, Colour> colours(const Result& result) {
  const std::vector<Look> found = looks(result);
  std::map<std::string, Colour> by_label;
  std::size_t others = 0;
  for (const Path& path : result.paths) {
    if (is_reference(path) || by_label.count(path.label) > 0) continue;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::string& name = result.curves[i].integrator;
      if (!found[i].strong || name.size() < longest || path.label.rfind(name, 0) != 0) continue;
      longest = name.size();
      by_label[path.label] = found[i].colour;
    }
    if (longest == 0) by_label[path.label] = spare_colour(found, others++);
  }
  return by_label;
}

void draw_axes(Canvas& canvas, const View& view) {
  const Box& panel = view.panel;
  const double half_across = panel.width() / 2 / view.scale_across, half_up = panel.height() / 2 / view.scale_up;
  const double across = View::middle(view.along_across), up = View::middle(view.along_up);
  const std::string mark = fmt::format("stroke=\"{}\"", faint), small = fmt::format("fill=\"{}\"", medium);
  std::array<double, 4> at{};
  at[view.up] = up;
  for (const double value : round_values(across - half_across, across + half_across, 8)) {
    at[view.across] = value;
    const double x = view(at).x;
    canvas.line({x, panel.bottom}, {x, panel.bottom + 5}, mark);
    canvas.text({x, panel.bottom + 18}, number(value), 12, small + " text-anchor=\"middle\"");
  }
  for (const double value : round_values(up - half_up, up + half_up, panel.height() > 200 ? 6 : 3)) {
    at[view.up] = value;
    const double y = view(at).y;
    canvas.line({panel.left - 5, y}, {panel.left, y}, mark);
    canvas.text({panel.left - 9, y + 4}, number(value), 12, small + " text-anchor=\"end\"");
  }
  canvas.text({(panel.left + panel.right) / 2, panel.bottom + 38}, axis_names[view.across], 13,
              fmt::format("fill=\"{}\" text-anchor=\"middle\"", dark));
  const Spot side{panel.left - 66, (panel.top + panel.bottom) / 2};
  canvas.text(side, axis_names[view.up], 13,
              fmt::format("fill=\"{}\" text-anchor=\"middle\" transform=\"rotate(-90 {} {})\"", dark,
                          coordinate(side.x), coordinate(side.y)));
}

void draw_one(Canvas& canvas, const Path& path, const View& view, const char* colour) {
  canvas.open(
      fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" "
                  "clip-path=\"url(#panel)\"",
                  colour, is_reference(path) ? "1" : "2.6"));
  for (const std::vector<Spot>& run : runs_of(path, view)) {
    if (run.size() > 1) canvas.polyline(run, "");
    if (run.size() == 1) canvas.circle(run.front(), 2, "");
  }
  canvas.close();
}

/// Returns where it ends.
double draw_names(Canvas& canvas, const Result& result, const std::map<std::string, Colour>& colour_of, Spot at,
                  double width) {
  std::vector<std::string> named;
  for (const Path& path : result.paths) {
    if (std::count(named.begin(), named.end(), path.label) > 0) continue;
    named.push_back(path.label);
    const bool reference = is_reference(path);
    canvas.line({at.x, at.y - 4}, {at.x + 20, at.y - 4},
                fmt::format("stroke=\"{}\" stroke-width=\"{}\"", reference ? black : colour_of.at(path.label).line,
                            reference ? "1" : "2.6"));
    for (const std::string& line : lines_of(path.label, 12.5, width - 28)) {
      canvas.text({at.x + 28, at.y}, line, 12.5, fmt::format("fill=\"{}\"", dark));
      at.y += row_height;
    }
  }
  return at.y;
}

}  // namespace

double draw_paths(Canvas& canvas, const Result& result, Spot corner, double width) {
  constexpr double names = 230;
  const View view = view_of(result, corner, width - names);
  const Box& panel = view.panel;
  const std::map<std::string, Colour> colour_of = colours(result);
  canvas.raw("<clipPath id=\"panel\">");
  canvas.box(panel, "");
  canvas.raw("</clipPath>\n");
  canvas.box(panel, fmt::format("fill=\"#ffffff\" stroke=\"{}\"", faint));
  for (const bool reference : {false, true}) {  // the reference above the others
    for (const Path& path : result.paths) {
      if (is_reference(path) == reference) {
        draw_one(canvas, path, view, reference ? black : colour_of.at(path.label).line);
      }
    }
  }
  draw_axes(canvas, view);
  const double end = draw_names(canvas, result, colour_of, {panel.right + 16, corner.y + 12}, names - 16);
  return std::max(panel.height() + 44, end - corner.y);
}

}  // namespace ballpark::cost::draw
