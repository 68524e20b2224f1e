#include "perf/cost/draw/look.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "perf/cost/draw/axis.h"
#include "perf/cost/subject.h"

namespace ballpark::cost::draw {

namespace {

constexpr std::array<Colour, 8> palette{{{"#0072b2", "#00619a"},
                                         {"#d55e00", "#b54f00"},
                                         {"#009e73", "#007a59"},
                                         {"#aa4499", "#963a87"},
                                         {"#e69f00", "#946600"},
                                         {"#56b4e9", "#1f78ad"},
                                         {"#332288", "#332288"},
                                         {"#999933", "#6f6f1c"}}};

/// How a curve ranks for a colour: the less the better.
double rank(const Result& result, const Curve& curve) {
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t on_front = 0;
  for (const std::size_t index : curve.points) {
    const Point& point = result.points[index];
    if (!drawable(point) || !point.claimed) continue;
    if (point.front) ++on_front;
    const bool own = result.scene_setting && equal(*result.scene_setting, point.setting);
    const bool recommended = result.recommended && result.recommended->point == index;
    if (own || recommended) nearest = -1;
    double cheapest = cost_of(point);
    for (const Point& other : result.points) {
      if (other.front && drawable(other) && other.error <= point.error) cheapest = std::min(cheapest, cost_of(other));
    }
    nearest = std::min(nearest, std::log10(cost_of(point) / cheapest));
  }
  return on_front > 0 ? -1.0 - static_cast<double>(on_front) : nearest;
}

/// What curves that differ by their precision alone have in common.
std::string name_without_precision(const Curve& curve) {
  for (const char* ending : {", single", ", double", ", extended"}) {
    const std::size_t at = curve.label.rfind(ending);
    if (at != std::string::npos) return std::string(curve.label).erase(at, std::string(ending).size());
  }
  return curve.label;
}

}  // namespace

bool drawable(const Point& point) {
  return point.trouble.empty() && std::isfinite(point.error) && point.error >= 0 && std::isfinite(cost_of(point)) &&
         cost_of(point) > 0;
}

double cost_of(const Point& point) {
  return point.seconds.minimum;
}

bool equal(const Setting& a, const Setting& b) {
  const auto close = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::max(std::abs(x), std::abs(y)); };
  return same_curve(a, b) && close(a.step, b.step) && close(a.tolerance, b.tolerance);
}

std::vector<Look> looks(const Result& result) {
  std::vector<Look> found(result.curves.size());
  std::vector<std::pair<double, std::size_t>> ranked;
  for (std::size_t i = 0; i < result.curves.size(); ++i) {
    const double r = rank(result, result.curves[i]);
    if (std::isfinite(r) || result.curves.size() <= palette.size()) ranked.push_back({r, i});
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::map<std::string, Colour> given;
  for (const auto& [r, curve] : ranked) {
    const std::string name = name_without_precision(result.curves[curve]);
    if (given.size() == palette.size() && given.count(name) == 0) continue;
    if (std::count_if(found.begin(), found.end(), [](const Look& l) { return l.strong; }) == palette.size()) break;
    found[curve] = {true, given.emplace(name, palette[given.size()]).first->second};
  }
  return found;
}

Colour spare_colour(const std::vector<Look>& looks, std::size_t index) {
  std::vector<Colour> spare;
  for (const Colour& colour : palette) {
    const auto has = [&](const Look& look) { return look.strong && look.colour.line == colour.line; };
    if (std::none_of(looks.begin(), looks.end(), has)) spare.push_back(colour);
  }
  for (const Colour colour :
       {Colour{"#8c5a3c", "#8c5a3c"}, Colour{"#e58ab0", "#b04a78"}, Colour{"#7a828b", "#57606a"}}) {
    spare.push_back(colour);
  }
  return spare[index % spare.size()];
}

std::string marker(Spot at, int order, double size) {
  const int corners = order <= 1 ? 24 : order == 2 ? 4 : order == 3 ? 3 : order == 4 ? 4 : order == 5 ? 5 : 6;
  const bool star = order > 6;
  const double turned = order == 2 ? M_PI / 4 : 0;
  const double radius = size * (corners > 6 ? 1 : order == 2 ? 1.2 : 1.3);
  std::string points;
  const int count = star ? 10 : corners;
  for (int i = 0; i < count; ++i) {
    const double angle = turned - M_PI / 2 + 2 * M_PI * i / count;
    const double r = star && i % 2 == 1 ? radius * 0.5 : star ? radius * 1.2 : radius;
    points +=
        (i > 0 ? " " : "") + coordinate(at.x + r * std::cos(angle)) + "," + coordinate(at.y + r * std::sin(angle));
  }
  if (corners == 24) {
    return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", coordinate(at.x), coordinate(at.y),
                       coordinate(radius));
  }
  return "<polygon points=\"" + points + "\"/>\n";
}

std::string setting_text(const Setting& s) {
  std::string text = s.integrator;
  if (s.step > 0) text += ", step " + number(s.step) + " s";
  if (s.tolerance > 0) text += ", tolerance " + number(s.tolerance);
  if (s.precision != Precision::double_) text += s.precision == Precision::single_ ? ", single" : ", extended";
  if (!s.rotation.empty() && s.rotation != usual_rotation) text += ", " + s.rotation;
  if (s.opening_angle >= 0) text += ", " + opening_text(s.opening_angle);
  if (s.contact.kind == "penalty") text += ", penalty " + number(s.contact.stiffness) + " N/m";
  if (s.contact.iterations > 0) text += fmt::format(", {} iterations", s.contact.iterations);
  if (s.contact.substeps > 1) text += fmt::format(", {} substeps", s.contact.substeps);
  return text;
}

}  // namespace ballpark::cost::draw
