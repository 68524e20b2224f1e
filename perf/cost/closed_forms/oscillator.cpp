// Springs of no rest length, dampers, linear drag and gravity: a linear oscillator about a shifted centre.
#include "perf/cost/closed_forms/acting.h"

namespace ballpark::cost {

namespace {

/// y'' + 2 b y' + W y = 0 (Landau & Lifshitz, Mechanics 25): with C = cos w t, S = sin w t / w, w^2 = W - b^2,
///   y = e^-bt (y0 C + (v0 + b y0) S),   v = e^-bt (v0 C - (W y0 + b v0) S).
template <class R>
class Oscillator {
 public:
  explicit Oscillator(const LoneBody& body) : spin_(body) {
    const R mass = R(body.mass);
    R stiffness = 0, damping = sum<R>(body, "linear_drag", "coefficient") + sum<R>(body, "spring", "damping");
    Vector<R> pull = mass * gravity<R>(body);
    for (const Effect* spring : of_kind(body, "spring")) {
      const R k = R(number(*spring, "stiffness"));
      pull += k * vector(*spring, "anchor", body.index).cast<R>();
      stiffness += k;
      fits_ = fits_ && number(*spring, "rest_length") == 0;
    }
    fits_ = fits_ && stiffness > 0;
    centre_ = pull / stiffness;
    square_ = stiffness / mass;
    decay_ = damping / (2 * mass);
    offset_ = body.start.position.cast<R>() - centre_;
    velocity_ = body.start.velocity.cast<R>();
  }
  bool fits() const { return fits_; }
  ExactState<R> at(R t) const {
    const auto [c, s] = waves(t);
    const Vector<R> y = offset_ * (c + decay_ * s) + velocity_ * s;
    const Vector<R> v = velocity_ * (c - decay_ * s) - offset_ * (square_ * s);
    return state_of<R>(centre_ + y, v, spin_.orientation(t), spin_.spin());
  }

 private:
  /// e^-bt C and e^-bt S. Overdamped: by the slow root W/(b + w) of the characteristic equation, as b - w cancels and
  /// cosh may overflow.
  std::pair<R, R> waves(R t) const {
    const R difference = square_ - decay_ * decay_, w = std::sqrt(std::abs(difference)), fade = std::exp(-decay_ * t);
    if (difference == 0) return {fade, fade * t};
    if (difference > 0) return {fade * std::cos(w * t), fade * std::sin(w * t) / w};
    const R slow = std::exp(-square_ / (decay_ + w) * t);
    return {slow * (1 + std::exp(-2 * w * t)) / 2, -slow * std::expm1(-2 * w * t) / (2 * w)};
  }

  Vector<R> centre_, offset_, velocity_;
  R square_ = 0, decay_ = 0;
  UniformSpin<R> spin_;
  bool fits_ = true;
};

}  // namespace

std::optional<ExactMotion> oscillator(const LoneBody& body) {
  if (!only_these_act(body, {"spring", "linear_drag", "gravity"}) || !spins_uniformly(body)) return std::nullopt;
  return motion_of<Oscillator>("damped oscillation (Landau & Lifshitz, Mechanics 25)", body);
}

}  // namespace ballpark::cost
