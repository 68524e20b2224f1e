// Quadratic drag along a line: straight up, down, or with no gravity at all.
#include "perf/cost/closed_forms/acting.h"

namespace ballpark::cost {

namespace {

/// A way and a speed along the line.
template <class R>
struct Progress {
  R way, speed;
};

/// Falling from speed s >= 0, V^2 = g/c, T = g t/V, a = s/V (numerics 1.1, P-D1; Timmerman & van der Weele, Am. J.
/// Phys. 67 (1999) 538): v = V (a + tanh T)/(1 + a tanh T), y = V^2/g ln(cosh T + a sinh T).
template <class R>
Progress<R> fall(R s, R g, R c, R t) {
  const R terminal = std::sqrt(g / c), time = g / terminal * t, a = s / terminal, tangent = std::tanh(time);
  const R half = std::sinh(std::min(time, R(1)) / 2);
  const R logarithm = time < 1 ? std::log1p(2 * half * half + a * std::sinh(time))
                               : time + std::log((1 + a + (1 - a) * std::exp(-2 * time)) / 2);  // no overflow
  return {logarithm / c, terminal * (a + tangent) / (1 + a * tangent)};
}

/// Rising from speed s, until it stands at T = atan a: v = V (a - tan T)/(1 + a tan T), y = V^2/g ln(cos T + a sin T).
template <class R>
Progress<R> rise(R s, R g, R c, R t) {
  const R terminal = std::sqrt(g / c), time = g / terminal * t, a = s / terminal;
  const R sine = std::sin(time), cosine = std::cos(time), half = std::sin(time / 2);
  return {std::log1p(a * sine - 2 * half * half) / c, terminal * (a * cosine - sine) / (cosine + a * sine)};
}

template <class R>
class StraightDrag {
 public:
  explicit StraightDrag(const LoneBody& body)
      : start_(body.start.position.cast<R>()),
        drag_(sum<R>(body, "quadratic_drag", "coefficient") / R(body.mass)),
        spin_(body) {
    const Vector<R> pull = gravity<R>(body), velocity = body.start.velocity.cast<R>();
    gravity_ = pull.norm();
    down_ = gravity_ > 0 ? pull : velocity;
    down_.normalize();
    speed_ = velocity.dot(down_);
    const R tolerance = R(geometry_tolerance) * velocity.norm();
    fits_ = drag_ > 0 && velocity.cross(down_).norm() <= tolerance;
  }
  bool fits() const { return fits_; }
  ExactState<R> at(R t) const {
    const Progress<R> p = progress(t);
    return state_of<R>(start_ + p.way * down_, p.speed * down_, spin_.orientation(t), spin_.spin());
  }

 private:
  Progress<R> progress(R t) const {
    if (gravity_ == 0) return {std::log1p(drag_ * speed_ * t) / drag_, speed_ / (1 + drag_ * speed_ * t)};
    if (speed_ >= 0) return fall(speed_, gravity_, drag_, t);
    const R terminal = std::sqrt(gravity_ / drag_), top = terminal / gravity_ * std::atan(-speed_ / terminal);
    const Progress<R> up = rise(-speed_, gravity_, drag_, std::min(t, top));
    if (t <= top) return {-up.way, -up.speed};
    const Progress<R> back = fall(R(0), gravity_, drag_, t - top);
    return {back.way - up.way, back.speed};
  }

  Vector<R> start_, down_;
  R gravity_ = 0, drag_, speed_ = 0;
  UniformSpin<R> spin_;
  bool fits_ = false;
};

}  // namespace

std::optional<ExactMotion> vertical_drag(const LoneBody& body) {
  if (!only_these_act(body, {"gravity", "quadratic_drag"}) || !spins_uniformly(body)) return std::nullopt;
  return motion_of<StraightDrag>("straight motion with quadratic drag (Timmerman & van der Weele 1999)", body);
}

}  // namespace ballpark::cost
