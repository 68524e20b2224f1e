// A moment as SVG: lines first, then circles, the farthest first.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/draw/canvas.h"
#include "scenarios/view/drawing.h"

namespace ballpark::view {
namespace {

Colour darker(Colour colour) {
  const auto less = [](std::uint8_t value) { return static_cast<std::uint8_t>(value * 3 / 5); };
  return {less(colour.red), less(colour.green), less(colour.blue)};
}

}  // namespace

std::string svg(const Drawing& drawing, const Vector3d& direction, int width, int height) {
  const Camera camera = camera_on(drawing.box, direction, width, height);
  cost::draw::Canvas canvas;
  canvas.raw(
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
                  "height=\"{1}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
                  width, height));
  canvas.open("stroke=\"#969ea7\" stroke-width=\"0.75\"");
  for (const Line& line : drawing.lines) {
    const Seen from = camera.see(line.from), to = camera.see(line.to);
    if (from.depth > 0 && to.depth > 0) canvas.line({from.x, from.y}, {to.x, to.y}, "");
  }
  canvas.close();
  std::vector<std::pair<Seen, const Ball*>> balls;
  for (const Ball& ball : drawing.balls) {
    const Seen seen = camera.see(ball.centre);
    if (seen.depth > ball.radius) balls.push_back({seen, &ball});
  }
  std::stable_sort(balls.begin(), balls.end(),
                   [](const auto& a, const auto& b) { return a.first.depth > b.first.depth; });
  canvas.open("stroke-width=\"0.75\"");
  for (const auto& [seen, ball] : balls) {
    const double radius =
        camera.focal * ball->radius / std::sqrt(seen.depth * seen.depth - ball->radius * ball->radius);
    canvas.circle({seen.x, seen.y}, radius,
                  fmt::format("fill=\"{}\" stroke=\"{}\"", hex(ball->colour), hex(darker(ball->colour))));
  }
  canvas.close();
  canvas.raw("</svg>\n");
  return canvas.text();
}

}  // namespace ballpark::view
