// One inverse-square centre: ellipses, parabolas and hyperbolas by universal variables.
#include <numbers>

#include "perf/cost/closed_forms/acting.h"
#include "perf/cost/closed_forms/root.h"
#include "perf/cost/closed_forms/series.h"

namespace ballpark::cost {

namespace {

/// Danby, Fundamentals of Celestial Mechanics, ch. 6: G_k = s^k c_k(a s^2), a = 2/r0 - v0^2/mu, q = r0.v0/sqrt mu,
///   sqrt(mu) t = r0 G1 + q G2 + G3,   r = r0 G0 + q G1 + G2,   x = f x0 + g v0 with
///   f = 1 - G2/r0,  g = (r0 G1 + q G2)/sqrt mu,  f' = -sqrt(mu) G1/(r r0),  g' = 1 - G2/r.
template <class R>
class Orbit {
 public:
  explicit Orbit(const LoneBody& body) : spin_(body) {
    const Effect& sun = *of_kind(body, "central_gravity").front();
    const R strength = R(number(sun, "strength"));
    centre_ = vector(sun, "centre").cast<R>();
    offset_ = body.start.position.cast<R>() - centre_;
    velocity_ = body.start.velocity.cast<R>();
    root_ = std::sqrt(strength);
    distance_ = offset_.norm();
    along_ = offset_.dot(velocity_) / root_;
    inverse_axis_ = 2 / distance_ - velocity_.squaredNorm() / strength;
    // A fall into the centre ends in a collision.
    const R moment = offset_.cross(velocity_).norm();
    fits_ = strength > 0 && number(sun, "softening") == 0 && distance_ > 0 &&
            moment > R(geometry_tolerance) * distance_ * velocity_.norm();
  }
  bool fits() const { return fits_; }

  ExactState<R> at(R t) const {
    if (inverse_axis_ > 0) {
      t = std::remainder(t, 2 * std::numbers::pi_v<R> / (root_ * inverse_axis_ * std::sqrt(inverse_axis_)));
    }
    const R direction = t < 0 ? R(-1) : R(1), q = direction * along_;  // back in time: forth from the velocity reversed
    const R s = universal_anomaly(std::abs(t), q);
    const G at_s(s, inverse_axis_);
    const R r = distance_ * at_s.g0 + q * at_s.g1 + at_s.g2;
    const R f = 1 - at_s.g2 / distance_, g = direction * (distance_ * at_s.g1 + q * at_s.g2) / root_;
    const R df = -direction * root_ * at_s.g1 / (r * distance_), dg = 1 - at_s.g2 / r;
    return state_of<R>(centre_ + f * offset_ + g * velocity_, df * offset_ + dg * velocity_, spin_.orientation(t),
                       spin_.spin());
  }

 private:
  struct G {
    R g0, g1, g2, g3;
    G(R s, R a) {
      const Stumpff<R> c(a * s * s);
      g0 = c.c0;
      g1 = s * c.c1;
      g2 = s * s * c.c2;
      g3 = s * s * s * c.c3;
    }
  };

  R universal_anomaly(R t, R q) const {
    if (t == 0) return 0;
    const auto equation = [&](R s) {
      const G g(s, inverse_axis_);
      const R r = distance_ * g.g0 + q * g.g1 + g.g2;
      return std::pair<R, R>(distance_ * g.g1 + q * g.g2 + g.g3 - root_ * t, r);
    };
    R low = 0, high = std::min(std::sqrt(distance_), root_ * t / distance_);
    if (inverse_axis_ < 0) high = std::min(high, 1 / std::sqrt(-inverse_axis_));  // so that no sinh overflows
    while (equation(high).first < 0) {
      low = high;
      high *= 2;
    }
    return rising_root(equation, low, high);
  }

  Vector<R> centre_, offset_, velocity_;
  R root_ = 0, distance_ = 0, along_ = 0, inverse_axis_ = 0;
  UniformSpin<R> spin_;
  bool fits_ = false;
};

}  // namespace

std::optional<ExactMotion> kepler(const LoneBody& body) {
  const bool lone = body.effects.size() == 1 && body.effects.front()->kind == "central_gravity";
  if (!lone || !spins_uniformly(body)) return std::nullopt;
  return motion_of<Orbit>(
      "Kepler's equation in universal variables (Danby, Fundamentals of Celestial Mechanics, ch. 6)", body);
}

}  // namespace ballpark::cost
