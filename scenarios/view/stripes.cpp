#include "scenarios/view/stripes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ballpark::view {
namespace {

using cost::draw::Spot;

/// A band of the unit sphere about `axis`: from `first` towards `second`, as far as `angle`.
struct Band {
  Colour colour;
  Vector3d axis, first, second;
  double half_width, angle;
};

Vector3d turned(const Quaternion& q, const Vector3d& v) {
  const Vector3d axis(q.x, q.y, q.z), once = 2 * axis.cross(v);
  return v + q.w * once + axis.cross(once);
}

class Outliner {
 public:
  Outliner(const Ball& ball, const Camera& camera) : ball_(ball), camera_(camera), eye_(camera.eye - ball.centre) {}

  void add(const Band& band, std::vector<Stripe>& all) {
    const double pixels = camera_.focal * ball_.radius / eye_.norm();
    const int most = static_cast<int>(std::clamp(pixels, 12.0, 48.0));
    const int parts = std::max(2, static_cast<int>(most * band.angle / std::numbers::pi));
    const auto at = [&](int part) { return band.angle * part / parts; };
    int start = 0;  // of a whole band, where it is hidden: so that no piece is cut in two
    const bool whole = band.angle > 6;
    while (whole && start < parts && is_seen(band, at(start))) ++start;
    for (int k = 0; k <= parts; ++k) {
      const double angle = at(whole ? (start + k) % parts : k);
      if (is_seen(band, angle)) {
        cross(band, angle);
      } else {
        end(band.colour, all);
      }
    }
    end(band.colour, all);
  }

 private:
  Vector3d on_band(const Band& band, double angle, double height) const {
    const double around = std::sqrt(1 - height * height);
    return around * (std::cos(angle) * band.first + std::sin(angle) * band.second) + height * band.axis;
  }

  /// Above 0: the eye sees this point of the unit sphere.
  double faces(const Vector3d& normal) const { return normal.dot(eye_) - ball_.radius; }

  Spot seen(const Vector3d& normal) const {
    const Seen place = camera_.see(ball_.centre + ball_.radius * normal);
    return {place.x, place.y};
  }

  /// Is anything of a cut through the band?
  bool is_seen(const Band& band, double angle) const {
    return faces(on_band(band, angle, -band.half_width)) > 0 || faces(on_band(band, angle, band.half_width)) > 0;
  }

  /// Adds what is seen of the cut to both rims of the piece.
  void cross(const Band& band, double angle) {
    double low = -band.half_width, high = band.half_width;
    const double below = faces(on_band(band, angle, low)), above = faces(on_band(band, angle, high));
    const double width = high - low;
    if (below < 0) low += width * below / (below - above);
    if (above < 0) high -= width * above / (above - below);
    lower_.push_back(seen(on_band(band, angle, low)));
    upper_.push_back(seen(on_band(band, angle, high)));
  }

  void end(Colour colour, std::vector<Stripe>& all) {
    if (upper_.size() > 1) {
      all.push_back({colour, upper_});
      all.back().outline.insert(all.back().outline.end(), lower_.rbegin(), lower_.rend());
    }
    upper_.clear();
    lower_.clear();
  }

  const Ball& ball_;
  const Camera& camera_;
  Vector3d eye_;  ///< from the centre
  std::vector<Spot> upper_, lower_;
};

}  // namespace

std::vector<Stripe> stripes(const Ball& ball, const Camera& camera) {
  std::vector<Stripe> all;
  if (!ball.turns) return all;
  const Vector3d x = turned(ball.orientation, Vector3d::UnitX()), y = turned(ball.orientation, Vector3d::UnitY()),
                 z = turned(ball.orientation, Vector3d::UnitZ());
  Outliner outliner(ball, camera);
  outliner.add({{245, 245, 245}, z, x, y, band_half_width, 2 * std::numbers::pi}, all);
  outliner.add({{34, 34, 34}, x, -z, y, mark_half_width, std::numbers::pi}, all);
  return all;
}

}  // namespace ballpark::view
