// A moment as SVG: lines first, then circles, the farthest first, and what the colours mean.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/draw/axis.h"
#include "perf/cost/draw/canvas.h"
#include "scenarios/view/drawing.h"
#include "scenarios/view/stripes.h"

namespace ballpark::view {
namespace {

using cost::draw::Canvas, cost::draw::coordinate, cost::draw::number, cost::draw::text_width;

constexpr std::size_t most_entries = 12, many_balls = 3000;  // of so many balls stripes are noise
constexpr double text_size = 13, row = 19, margin = 14;

Colour darker(Colour colour) {
  const auto less = [](std::uint8_t value) { return static_cast<std::uint8_t>(value * 3 / 5); };
  return {less(colour.red), less(colour.green), less(colour.blue)};
}

void draw_ball(Canvas& canvas, const Ball& ball, const Seen& seen, const Camera& camera, bool striped) {
  const double radius = camera.focal * ball.radius / std::sqrt(seen.depth * seen.depth - ball.radius * ball.radius);
  const std::string edge = hex(darker(ball.colour));
  canvas.circle({seen.x, seen.y}, radius, fmt::format("fill=\"{}\" stroke=\"{}\"", hex(ball.colour), edge));
  if (!striped) return;
  for (const Stripe& stripe : stripes(ball, camera)) {
    canvas.polygon(stripe.outline, fmt::format("fill=\"{}\"", hex(stripe.colour)));
  }
}

void draw_balls(Canvas& canvas, const Drawing& drawing, const Camera& camera) {
  std::vector<std::pair<Seen, const Ball*>> balls;
  for (const Ball& ball : drawing.balls) {
    const Seen seen = camera.see(ball.centre);
    if (seen.depth > ball.radius) balls.push_back({seen, &ball});
  }
  std::stable_sort(balls.begin(), balls.end(),
                   [](const auto& a, const auto& b) { return a.first.depth > b.first.depth; });
  canvas.open("stroke-width=\"0.75\"");
  for (const auto& [seen, ball] : balls) draw_ball(canvas, *ball, seen, camera, balls.size() <= many_balls);
  canvas.close();
}

/// A strip from 0 to the highest value, in the lower left corner.
void draw_scale(Canvas& canvas, const Key& key, double bottom) {
  constexpr double width = 190, height = 10;
  constexpr int parts = 16;
  const double top = bottom - row - height;
  canvas.text({margin, top - 7}, key.scale, text_size, "");
  canvas.raw("<linearGradient id=\"scale\">\n");
  for (int k = 0; k <= parts; ++k) {
    const double share = static_cast<double>(k) / parts;
    canvas.raw(fmt::format("<stop offset=\"{}\" stop-color=\"{}\"/>\n", coordinate(share), hex(viridis(share))));
  }
  canvas.raw("</linearGradient>\n");
  canvas.box({margin, top, margin + width, top + height}, "fill=\"url(#scale)\"");
  canvas.text({margin, bottom}, "0", text_size, "");
  canvas.text({margin + width / 2, bottom}, number(key.highest / 2), text_size, "text-anchor=\"middle\"");
  canvas.text({margin + width, bottom}, number(key.highest), text_size, "text-anchor=\"end\"");
}

void draw_entries(Canvas& canvas, const Key& key, double bottom) {
  const std::size_t shown = std::min(key.entries.size(), most_entries);
  for (std::size_t i = 0; i < shown; ++i) {
    const double y = bottom - row * static_cast<double>(shown - 1 - i);
    const auto& [colour, name] = key.entries[i];
    canvas.circle({margin + 5, y - 4.5}, 5, fmt::format("fill=\"{}\"", hex(colour)));
    canvas.text({margin + 17, y}, name, text_size, "");
  }
}

/// What the colours mean, and when it was.
void draw_key(Canvas& canvas, const Drawing& drawing, int width, int height) {
  const double bottom = height - margin;
  canvas.open("fill=\"#1f2328\" stroke=\"none\" font-family=\"system-ui, sans-serif\"");
  if (!drawing.key.scale.empty() && drawing.key.highest > 0) draw_scale(canvas, drawing.key, bottom);
  if (drawing.key.entries.size() > 1) draw_entries(canvas, drawing.key, bottom);
  canvas.text({width - margin, bottom}, number(drawing.time) + " s", text_size, "text-anchor=\"end\"");
  canvas.close();
}

}  // namespace

std::string svg(const Drawing& drawing, const Vector3d& direction, int width, int height) {
  const Camera camera = camera_on(drawing.box, direction, width, height);
  Canvas canvas;
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
  draw_balls(canvas, drawing, camera);
  draw_key(canvas, drawing, width, height);
  canvas.raw("</svg>\n");
  return canvas.text();
}

}  // namespace ballpark::view
