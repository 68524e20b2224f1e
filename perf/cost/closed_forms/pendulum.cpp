// A rigid pendulum in a plane, from any angle and speed: to and fro, over the top, or close to neither.
#include "perf/cost/closed_forms/elliptic.h"
#include "perf/cost/closed_forms/pivoted.h"

namespace ballpark::cost {

namespace {

/// theta'' = -W^2 sin theta, W^2 = m g l/J, theta from hanging (Landau & Lifshitz, Mechanics 11 problem 1; Ochs, Eur.
/// J. Phys. 32 (2011) 479). With q = |theta'|/(2 W) at the start, k^2 = sin^2(theta/2) + q^2, k1^2 = cos^2(theta/2) -
/// q^2:
///   to and fro (k < 1):  sin(theta/2) = k sn(W t + u, k^2),  cos(theta/2) = dn,  theta' = 2 k W cn;
///   over the top:        sin(theta/2) = sn(k W t + u, 1/k^2), cos(theta/2) = cn, theta' = 2 k W dn.
template <class R>
class Pendulum {
 public:
  explicit Pendulum(const LoneBody& body) : start_(body) {
    const R length = start_.arm.norm(), pull = start_.gravity.norm();
    fits_ = length > 0 && pull > 0;
    if (!fits_) return;
    const Vector<R> down = start_.gravity / pull, arm = start_.arm / length;
    find_axis(down, arm);
    const Vector<R> in_body = start_.orientation.conjugate() * axis_, turning = start_.moments.cwiseProduct(in_body);
    fits_ = fits_ && turning.cross(in_body).norm() <= R(geometry_tolerance) * start_.moments.maxCoeff();
    frequency_ = std::sqrt(start_.mass * pull * length / (turning.dot(in_body) + start_.mass * length * length));
    const R sine = std::copysign((arm - down).norm() / 2, axis_.dot(down.cross(arm))), cosine = (arm + down).norm() / 2;
    find_motion(sine, cosine, axis_.dot(start_.spin));
  }
  bool fits() const { return fits_; }

  ExactState<R> at(R t) const {
    if (still_) return start_.turned(Rotation<R>::Identity(), Vector<R>::Zero());
    const Half half = at_argument(rate_ * t + begin_);
    const R sine = half.sine * first_.cosine - half.cosine * first_.sine;
    const R cosine = half.cosine * first_.cosine + half.sine * first_.sine;
    const Vector<R> imaginary = sine * axis_;
    return start_.turned(Rotation<R>(cosine, imaginary.x(), imaginary.y(), imaginary.z()), half.speed * axis_);
  }

 private:
  struct Half {
    R sine = 0, cosine = 1;  ///< of theta/2
    R speed = 0;             ///< theta'
  };

  /// Horizontal, across the arm, and what the body spins about if it does.
  void find_axis(const Vector<R>& down, const Vector<R>& arm) {
    const R speed = start_.spin.norm(), tolerance = R(geometry_tolerance);
    const Vector<R> across = arm.cross(down);
    still_ = speed == 0 && across.norm() == 0;  // hanging, or upright
    axis_ = speed > 0 ? start_.spin : still_ ? arm.unitOrthogonal() : across;
    axis_.normalize();
    fits_ = speed == 0 || (std::abs(axis_.dot(down)) <= tolerance && std::abs(axis_.dot(arm)) <= tolerance);
  }

  void find_motion(R sine, R cosine, R speed) {
    if (still_ || !fits_) return;
    const R q = std::abs(speed) / (2 * frequency_), energy = sine * sine + q * q, k = std::sqrt(energy);
    const R less = (cosine - q) * (cosine + q);
    over_ = less < 0;
    if (over_) {
      functions_ = Elliptic<R>(1 / energy, -less / energy);
      direction_ = std::copysign(R(1), speed);
      begin_ = functions_.argument(direction_ * sine, cosine);
      scale_ = 1;
      rate_ = k * frequency_;
    } else {
      functions_ = Elliptic<R>(energy, less);
      begin_ = functions_.argument(sine / k, std::copysign(q / k, speed));
      scale_ = k;
      rate_ = frequency_;
    }
    still_ = !std::isfinite(begin_);  // at rest on the top, to rounding
    first_ = at_argument(begin_);
  }

  Half at_argument(R u) const {
    const auto [sn, cn, dn, amplitude] = functions_.at(u);
    const R swing = 2 * scale_ * rate_ * direction_;
    return over_ ? Half{direction_ * sn, cn, swing * dn} : Half{scale_ * sn, dn, swing * cn};
  }

  Pivoted<R> start_;
  Vector<R> axis_ = Vector<R>::Zero();
  Elliptic<R> functions_;
  Half first_;
  R frequency_ = 0, rate_ = 0, scale_ = 1, begin_ = 0, direction_ = 1;
  bool fits_ = false, still_ = false, over_ = false;
};

}  // namespace

std::optional<ExactMotion> pendulum(const LoneBody& body) {
  if (!hangs_on_one_pivot(body)) return std::nullopt;
  return motion_of<Pendulum>("rigid pendulum in elliptic functions (Landau & Lifshitz, Mechanics 11; Ochs 2011)", body);
}

}  // namespace ballpark::cost
