// Springs of no rest length, traps, dampers, linear drag and gravity: a linear oscillator about a shifted centre, along
// each axis of its own.
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
    R damping = sum<R>(body, "linear_drag", "coefficient") + sum<R>(body, "spring", "damping");
    Vector<R> pull = mass * gravity<R>(body), stiffness = Vector<R>::Zero();
    for (const Effect* spring : of_kind(body, "spring")) {
      const R k = R(number(*spring, "stiffness"));
      pull += k * vector(*spring, "anchor", body.index).cast<R>();
      stiffness += Vector<R>::Constant(k);
      fits_ = fits_ && number(*spring, "rest_length") == 0;
    }
    for (const Effect* trap : of_kind(body, "harmonic_trap")) {
      const Vector<R> k = vector(*trap, "stiffness").template cast<R>();
      pull += k.cwiseProduct(vector(*trap, "centre").template cast<R>());
      stiffness += k;
    }
    fits_ = fits_ && stiffness.minCoeff() > 0;
    centre_ = pull.cwiseQuotient(stiffness);
    square_ = stiffness / mass;
    decay_ = damping / (2 * mass);
    offset_ = body.start.position.cast<R>() - centre_;
    velocity_ = body.start.velocity.cast<R>();
  }
  bool fits() const { return fits_; }
  ExactState<R> at(R t) const {
    Vector<R> y, v;
    for (int i = 0; i < 3; ++i) {
      const auto [c, s] = waves(square_[i], t);
      y[i] = offset_[i] * (c + decay_ * s) + velocity_[i] * s;
      v[i] = velocity_[i] * (c - decay_ * s) - offset_[i] * (square_[i] * s);
    }
    return state_of<R>(centre_ + y, v, spin_.orientation(t), spin_.spin());
  }

 private:
  /// e^-bt C and e^-bt S. Overdamped: by the slow root W/(b + w) of the characteristic equation, as b - w cancels and
  /// cosh may overflow.
  std::pair<R, R> waves(R square, R t) const {
    const R difference = square - decay_ * decay_, w = std::sqrt(std::abs(difference)), fade = std::exp(-decay_ * t);
    if (difference == 0) return {fade, fade * t};
    if (difference > 0) return {fade * std::cos(w * t), fade * std::sin(w * t) / w};
    const R slow = std::exp(-square / (decay_ + w) * t);
    return {slow * (1 + std::exp(-2 * w * t)) / 2, -slow * std::expm1(-2 * w * t) / (2 * w)};
  }

  Vector<R> centre_, offset_, velocity_, square_;
  R decay_ = 0;
  UniformSpin<R> spin_;
  bool fits_ = true;
};

}  // namespace

std::optional<ExactMotion> oscillator(const LoneBody& body) {
  if (!only_these_act(body, {"spring", "harmonic_trap", "linear_drag", "gravity"}) || !spins_uniformly(body))
    return std::nullopt;
  return motion_of<Oscillator>("damped oscillation (Landau & Lifshitz, Mechanics 25)", body);
}

}  // namespace ballpark::cost
