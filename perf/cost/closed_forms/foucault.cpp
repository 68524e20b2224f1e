// Foucault's pendulum: springs of no rest length under forces that turn the velocity (Coriolis, or a magnetic field).
#include "perf/cost/closed_forms/acting.h"

namespace ballpark::cost {

namespace {

/// m y'' = -k y - 2 m W x y' about a shifted centre. Along W an oscillator of frequency w0 = sqrt(k/m). Across it, in
/// the plane as complex numbers, z'' + 2 i W z' + w0^2 z = 0 (Sommerfeld, Mechanics 31): with w^2 = w0^2 + W^2,
///   z = e^(-i W t) u,  u = z0 cos w t + (v0 + i W z0) sin w t / w,  z' = e^(-i W t) (u' - i W u).
template <class R>
class TurningOscillator {
 public:
  explicit TurningOscillator(const LoneBody& body) : rate_(turning<R>(body) / R(-2)), spin_(body) {
    const R mass = R(body.mass);
    R stiffness = 0;
    Vector<R> pull = mass * uniform_push<R>(body);
    for (const Effect* spring : of_kind(body, "spring")) {
      const R k = R(number(*spring, "stiffness"));
      pull += k * vector(*spring, "anchor", body.index).cast<R>();
      stiffness += k;
      fits_ = fits_ && number(*spring, "rest_length") == 0 && number(*spring, "damping") == 0;
    }
    for (const Effect* frame : of_kind(body, "rotating_frame")) fits_ = fits_ && word(*frame, "centrifugal") == "off";
    fits_ = fits_ && stiffness > 0;
    centre_ = pull / stiffness;
    square_ = stiffness / mass;
    offset_ = body.start.position.cast<R>() - centre_;
    velocity_ = body.start.velocity.cast<R>();
  }
  bool fits() const { return fits_; }
  ExactState<R> at(R t) const {
    const Vector<R> offset = along(offset_), velocity = along(velocity_);
    const auto [y, v] = swing(offset, velocity, square_, t);
    const Vector<R> across = offset_ - offset;
    const auto [u, du] = swing(across, velocity_ - velocity + rate_.cross(across), square_ + rate_.squaredNorm(), t);
    const Rotation<R> turn = rotation_by<R>(-t * rate_);
    return state_of<R>(centre_ + y + turn * u, v + turn * Vector<R>(du - rate_.cross(u)), spin_.orientation(t),
                       spin_.spin());
  }

 private:
  Vector<R> along(const Vector<R>& a) const {
    if (rate_.isZero(0)) return Vector<R>::Zero();
    return rate_.dot(a) / rate_.squaredNorm() * rate_;
  }
  /// Position and velocity of y'' = -square y.
  static std::pair<Vector<R>, Vector<R>> swing(const Vector<R>& y, const Vector<R>& v, R square, R t) {
    const R w = std::sqrt(square), c = std::cos(w * t), s = std::sin(w * t);
    return {c * y + (s / w) * v, c * v - (w * s) * y};
  }

  Vector<R> rate_, centre_, offset_, velocity_;
  R square_ = 0;
  UniformSpin<R> spin_;
  bool fits_ = true;
};

}  // namespace

std::optional<ExactMotion> foucault(const LoneBody& body) {
  if (!only_these_act(body, {"spring", "rotating_frame", "magnetic_field", "electric_field", "gravity"}) ||
      !spins_uniformly(body)) {
    return std::nullopt;
  }
  return motion_of<TurningOscillator>("oscillation whose plane turns (Foucault's pendulum: Sommerfeld, Mechanics 31)",
                                      body);
}

}  // namespace ballpark::cost
