// Shaded balls and thin lines with a depth buffer, drawn twice as large as wanted and averaged.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scenarios/view/drawing.h"

namespace ballpark::view {
namespace {

constexpr int fine = 2;  // pixels drawn along the side of one that is shown

using Shade = std::array<float, 3>;  // red, green, blue in 0..255

class Raster {
 public:
  Raster(const Vector3d& direction, const Box& box, int width, int height)
      : width_(fine * width),
        height_(fine * height),
        camera_(camera_on(box, direction, width_, height_)),
        nearest_(1e-3 * box.diagonal()),
        light_((-0.45 * camera_.right + 0.65 * camera_.up - 0.8 * camera_.forward).normalized()),
        pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), paper),
        depths_(pixels_.size(), std::numeric_limits<float>::infinity()) {}

  /// What rays through the pixels meet first.
  void ball(const Ball& ball) {
    const Vector3d centre = camera_.in_view(ball.centre);
    const double r2 = ball.radius * ball.radius, near2 = centre.z() * centre.z() - r2;
    if (centre.z() <= ball.radius || !centre.allFinite()) return;
    // Silhouettes are ellipses, stretched away from the middle of the picture: this holds them.
    const double reach = camera_.focal * ball.radius / std::sqrt(near2) * centre.norm() / centre.z() + 1;
    const Seen middle = camera_.see(ball.centre);
    const auto [left, right] = span(middle.x - reach, middle.x + reach, width_);
    const auto [top, bottom] = span(middle.y - reach, middle.y + reach, height_);
    const double far2 = centre.squaredNorm() - r2;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const Vector3d ray((x + 0.5 - camera_.centre_x) / camera_.focal, (camera_.centre_y - y - 0.5) / camera_.focal,
                           1);
        const double along = ray.dot(centre), length2 = ray.squaredNorm(), inside = along * along - length2 * far2;
        if (inside < 0) continue;
        const double depth = (along - std::sqrt(inside)) / length2;
        const std::size_t place = index(x, y);
        if (depth >= depths_[place]) continue;
        depths_[place] = static_cast<float>(depth);
        const Vector3d normal = (depth * ray - centre) / ball.radius;
        pixels_[place] =
            shaded(ball, normal.x() * camera_.right + normal.y() * camera_.up + normal.z() * camera_.forward);
      }
    }
  }

  /// Drawn last: faint, and hidden by balls before it.
  void line(Line line) {
    if (!before_eye(line.from, line.to)) return;
    const Seen a = camera_.see(line.from), b = camera_.see(line.to);
    const double steps = std::ceil(std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), 1.0}));
    // 1 / depth is linear along a line of the picture.
    for (double k = 0; k <= steps; ++k) {
      const double t = k / steps, depth = 1 / ((1 - t) / a.depth + t / b.depth);
      const double x = a.x + t * (b.x - a.x), y = a.y + t * (b.y - a.y);
      if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
      const std::size_t place = index(static_cast<int>(x), static_cast<int>(y));
      if (depth > depths_[place]) continue;
      pixels_[place] = ink;
    }
  }

  Image image() const {
    Image image{width_ / fine, height_ / fine, {}};
    for (int y = 0; y < height_; y += fine) {
      for (int x = 0; x < width_; x += fine) {
        for (std::size_t c = 0; c < 3; ++c) {
          float sum = 0;
          for (int k = 0; k < fine * fine; ++k) sum += pixels_[index(x + k % fine, y + k / fine)][c];
          image.pixels.push_back(static_cast<std::uint8_t>(std::lround(sum / (fine * fine))));
        }
      }
    }
    return image;
  }

 private:
  static constexpr Shade paper{255, 255, 255}, ink{150, 158, 167};

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  static std::pair<int, int> span(double low, double high, int size) {
    return {static_cast<int>(std::clamp(std::floor(low), 0.0, static_cast<double>(size))),
            static_cast<int>(std::clamp(std::ceil(high), 0.0, static_cast<double>(size)))};
  }

  /// Stripes show how it is turned: a white band about its z axis, and half a dark one across.
  Shade surface(const Ball& ball, const Vector3d& normal) const {
    const Colour& c = ball.colour;
    if (ball.turns) {
      const Quaternion& q = ball.orientation;
      const Vector3d axis(q.x, q.y, q.z), turn = 2 * axis.cross(normal);
      const Vector3d p = normal - q.w * turn + axis.cross(turn);  // in the body's axes
      if (std::abs(p.x()) < mark_half_width && p.y() > 0) return {34, 34, 34};
      if (std::abs(p.z()) < band_half_width) return {245, 245, 245};
    }
    return {static_cast<float>(c.red), static_cast<float>(c.green), static_cast<float>(c.blue)};
  }

  Shade shaded(const Ball& ball, const Vector3d& normal) const {
    Shade shade = surface(ball, normal);
    const double lit = normal.dot(light_);
    const auto bright = static_cast<float>(0.5 + 0.5 * std::max(0.0, lit)),
               gleam = static_cast<float>(70 * std::pow(std::max(0.0, lit), 30));
    for (float& value : shade) value = std::min(255.0F, value * bright + gleam);
    return shade;
  }

  /// Cuts off what is behind the eye; false if nothing is left.
  bool before_eye(Vector3d& from, Vector3d& to) const {
    const double a = camera_.in_view(from).z() - nearest_, b = camera_.in_view(to).z() - nearest_;
    if (a < 0 && b < 0) return false;
    if (a < 0) from += (to - from) * (a / (a - b));
    if (b < 0) to += (from - to) * (b / (b - a));
    return true;
  }

  int width_, height_;
  Camera camera_;
  double nearest_;  ///< that lines are drawn [m]
  Vector3d light_;
  std::vector<Shade> pixels_;
  std::vector<float> depths_;
};

}  // namespace

Image picture(const Drawing& drawing, const Vector3d& direction, int width, int height) {
  Raster raster(direction, drawing.box, width, height);
  for (const Ball& ball : drawing.balls) raster.ball(ball);
  for (const Line& line : drawing.lines) raster.line(line);
  return raster.image();
}

}  // namespace ballpark::view
