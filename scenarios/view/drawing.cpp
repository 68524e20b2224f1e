#include "scenarios/view/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace ballpark::view {
namespace {

/// Viridis at eighths.
constexpr std::array<Colour, 9> eighths{{{68, 1, 84},
                                         {71, 44, 122},
                                         {59, 81, 139},
                                         {44, 113, 142},
                                         {33, 144, 141},
                                         {39, 173, 129},
                                         {92, 200, 99},
                                         {170, 220, 50},
                                         {253, 231, 37}}};
/// Okabe and Ito 2008.
constexpr std::array<Colour, 7> palette{{{0x00, 0x72, 0xb2},
                                         {0xe6, 0x9f, 0x00},
                                         {0x00, 0x9e, 0x73},
                                         {0xd5, 0x5e, 0x00},
                                         {0x56, 0xb4, 0xe9},
                                         {0xcc, 0x79, 0xa7},
                                         {0xf0, 0xe4, 0x42}}};

/// Of the bodies of one frame.
double fastest_of(const Recording& recording, std::size_t frame) {
  if (recording.speed.empty()) return 0;
  const float* first = recording.speed.data() + frame * recording.shown;
  return *std::max_element(first, first + recording.shown);
}

Key key_of(const Recording& recording, ColourBy colour, double fastest) {
  Key key;
  if (colour == ColourBy::speed) key = {"speed [m/s]", fastest, {}};
  for (std::size_t g = 0; g < recording.groups.size() && colour == ColourBy::group; ++g) {
    key.entries.push_back({palette[g % palette.size()], recording.groups[g].name});
  }
  return key;
}

}  // namespace

Colour viridis(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (eighths.size() - 1);
  const auto below = std::min<std::size_t>(static_cast<std::size_t>(place), eighths.size() - 2);
  const double part = place - static_cast<double>(below);
  const auto mixed = [&](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + part * (b - a)));
  };
  const Colour &a = eighths[below], &b = eighths[below + 1];
  return {mixed(a.red, b.red), mixed(a.green, b.green), mixed(a.blue, b.blue)};
}

std::string hex(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

Drawing drawing_of(const Recording& recording, std::size_t frame, ColourBy colour) {
  Drawing drawing;
  drawing.time = recording.times[frame];
  const Box box = box_of(recording);
  const double point = point_radius(recording, box);
  const double fastest = colour == ColourBy::speed ? fastest_of(recording, frame) : 0;
  drawing.key = key_of(recording, colour, fastest);
  double widest = 0;
  for (std::size_t g = 0; g < recording.groups.size(); ++g) {
    const ShownGroup& group = recording.groups[g];
    for (std::size_t row = 0; row < group.count; ++row) {
      const std::size_t body = group.first + row, place = frame * recording.shown + body;
      const float* p = &recording.position[3 * place];
      if (std::isnan(p[0])) continue;  // nobody there
      Ball ball{recording.origin + Vector3d(p[0], p[1], p[2]), group.radius_of(row), palette[0], group.turns,
                orientation_of(recording, frame, body)};
      if (ball.radius == 0) ball.radius = point;
      if (colour == ColourBy::group) ball.colour = palette[g % palette.size()];
      if (colour == ColourBy::speed) ball.colour = viridis(fastest > 0 ? recording.speed[place] / fastest : 0);
      widest = std::max(widest, ball.radius);
      drawing.balls.push_back(ball);
    }
  }
  const Vector3d margin = Vector3d::Constant(widest);
  drawing.box = {recording.origin + box.low - margin, recording.origin + box.high + margin};
  for (const Boundary& boundary : recording.boundaries) {
    const std::vector<Line> edges = outline(boundary, recording.times[frame], drawing.box);
    drawing.lines.insert(drawing.lines.end(), edges.begin(), edges.end());
  }
  return drawing;
}

}  // namespace ballpark::view
