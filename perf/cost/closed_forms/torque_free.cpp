// A body that spins freely about its centre of mass, which flies under gravity and linear drag.
#include <numeric>

#include "perf/cost/closed_forms/elliptic.h"
#include "perf/cost/closed_forms/free_path.h"

namespace ballpark::cost {

namespace {

/// Axes of the body by their moments: `a` is the one that the spin stays near (the greatest moment or the least), b the
/// middle one, c the other.
struct Axes {
  int a = 2, b = 1, c = 0;
  int sense = 1;  ///< 1: least, middle, greatest are right-handed; -1: left-handed
};

/// What the body does, seen from itself.
template <class R>
struct Seen {
  Vector<R> momentum, spin;  ///< body frame
  R turn;                    ///< of the body about its momentum, in excess of the shortest way [rad]
};

/// Landau & Lifshitz, Mechanics 37: w_c = C cn u, w_b = B sn u, w_a = A dn u, u = rate t + u0. The
/// angle of precession is an integral of the third kind (there, and in Hairer, Lubich & Wanner, Geometric Numerical
/// Integration VII.5):  Phi' = L/Ia + L (Ia - Ic)/(Ia Ic) / (cn^2 u + n sn^2 u),  n = Ib |Ia - Ic|/(Ic |Ia - Ib|).
template <class R>
class ThreeMoments {
 public:
  ThreeMoments(const Vector<R>& moments, const Vector<R>& spin) {
    Axes x = sorted(moments);
    const auto excess = [&](int i) { return moments[i] * std::abs(moments[i] - moments[x.b]) * spin[i] * spin[i]; };
    const R difference = excess(x.a) - excess(x.c);
    if (difference < 0) std::swap(x.a, x.c);
    axes_ = x;
    const R ia = moments[x.a], ib = moments[x.b], ic = moments[x.c];
    const R ab = std::abs(ia - ib), bc = std::abs(ib - ic), ac = std::abs(ia - ic);
    const R away = ic * ac * spin[x.c] * spin[x.c] + ib * ab * spin[x.b] * spin[x.b];  // |2 E Ia - L^2|
    const R near = ib * bc * spin[x.b] * spin[x.b] + ia * ac * spin[x.a] * spin[x.a];  // |2 E Ic - L^2|
    const R less = ac * std::abs(difference) / (ab * near);
    fits_ = less > 0 && away > 0;
    if (!fits_) return;
    functions_ = Elliptic<R>(bc * away / (ab * near), less);
    rate_ = std::sqrt(ab * near / (ia * ib * ic));
    side_ = std::copysign(R(1), spin[x.a]);
    largest_[x.a] = side_ * std::sqrt(near / (ia * ac));
    largest_[x.b] = side_ * x.sense * std::sqrt(away / (ib * ab));
    largest_[x.c] = std::sqrt(away / (ic * ac));
    begin_ = functions_.argument(spin[x.b] / largest_[x.b], spin[x.c] / largest_[x.c]);
    characteristic_ = ib * ac / (ic * ab);
    moments_ = moments;
    momentum_ = moments.cwiseProduct(spin).norm();
    outward_ = ia > ic ? R(1) : R(-1);
    turn_ = precession(begin_);
  }
  bool fits() const { return fits_; }

  Seen<R> at(R t) const {
    const R u = rate_ * t + begin_;
    const auto v = functions_.at(u);
    Seen<R> now;
    now.spin[axes_.a] = largest_[axes_.a] * v.dn;
    now.spin[axes_.b] = largest_[axes_.b] * v.sn;
    now.spin[axes_.c] = largest_[axes_.c] * v.cn;
    now.momentum = moments_.cwiseProduct(now.spin);
    now.turn = momentum_ * t / moments_[axes_.a] + precession(u) - turn_;
    return now;
  }
  /// The axis near which the spin stays, to its side.
  Vector<R> pole() const { return side_ * Vector<R>::Unit(axes_.a); }

 private:
  static Axes sorted(const Vector<R>& moments) {
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) { return moments[i] < moments[j]; });
    return {order[2], order[1], order[0], (order[1] - order[0] + 3) % 3 == 1 ? 1 : -1};
  }

  /// Phi less its even part, and less the azimuth of the momentum about the pole, which follows the amplitude.
  R precession(R u) const {
    const R ia = moments_[axes_.a], ic = moments_[axes_.c];
    const R phi = momentum_ * (ia - ic) / (ia * ic * rate_) * functions_.third_kind(R(1), characteristic_, u);
    const auto [sn, cn, dn, amplitude] = functions_.at(u);
    const R r = std::sqrt(characteristic_),
            azimuth = amplitude + std::atan((r - 1) * sn * cn / (cn * cn + r * sn * sn));
    return phi - outward_ * azimuth;
  }

  Axes axes_;
  Elliptic<R> functions_;
  Vector<R> moments_ = Vector<R>::Zero(), largest_ = Vector<R>::Zero();
  R rate_ = 0, side_ = 1, begin_ = 0, characteristic_ = 1, momentum_ = 0, outward_ = 1, turn_ = 0;
  bool fits_ = false;
};

/// Two equal moments I and one more along e (or three equal): the body turns about its momentum by L/I and about its
/// own axis e by (1 - Ie/I) w.e (Landau & Lifshitz 33). Also any body that spins about a principal axis e, of moment I.
template <class R>
struct Regular {
  Vector<R> about_momentum = Vector<R>::Zero();  ///< rad/s, world frame
  Vector<R> about_axis = Vector<R>::Zero();      ///< body frame
};

template <class R>
std::optional<Regular<R>> regular_spin(const Vector<R>& moments, const Vector<R>& spin, const Rotation<R>& start) {
  const Vector<R> momentum = moments.cwiseProduct(spin);
  if (moments.isZero(0) || spin.isZero(0)) return Regular<R>{start * spin, Vector<R>::Zero()};
  for (int e = 0; e < 3; ++e) {
    const int f = (e + 1) % 3, g = (e + 2) % 3;
    if (spin[f] == 0 && spin[g] == 0) return Regular<R>{start * spin, Vector<R>::Zero()};
    if (moments[f] != moments[g]) continue;
    return Regular<R>{start * momentum / moments[f], (1 - moments[e] / moments[f]) * spin[e] * Vector<R>::Unit(e)};
  }
  return std::nullopt;
}

template <class R>
class FreeBody {
 public:
  explicit FreeBody(const LoneBody& body)
      : path_(body),
        start_(start_orientation<R>(body)),
        spin_(start_.conjugate() * Vector<R>(body.start.angular_velocity.cast<R>())),
        regular_(regular_spin<R>(moments<R>(body), spin_, start_)),
        general_(moments<R>(body), spin_),
        frame_(start_ * shortest(moments<R>(body).cwiseProduct(spin_)).conjugate()) {}
  bool fits() const { return regular_ || general_.fits(); }

  ExactState<R> at(R t) const {
    const Vector<R> x = path_.position(t), v = path_.velocity(t);
    if (regular_) {
      const Rotation<R> turn = rotation_by<R>(regular_->about_momentum * t),
                        own = rotation_by<R>(regular_->about_axis * t);
      const Rotation<R> q = turn * start_ * own;
      return state_of<R>(x, v, q, regular_->about_momentum + q * regular_->about_axis);
    }
    const Seen<R> now = general_.at(t);
    const Rotation<R> q = frame_ * rotation_by<R>(now.turn * general_.pole()) * shortest(now.momentum);
    return state_of<R>(x, v, q, q * now.spin);
  }

 private:
  /// The shortest rotation that takes the momentum to the pole, from which it is never 90 degrees away.
  Rotation<R> shortest(const Vector<R>& momentum) const {
    const Vector<R> from = momentum.normalized(), to = general_.pole(), across = from.cross(to);
    return Rotation<R>(1 + from.dot(to), across.x(), across.y(), across.z()).normalized();
  }

  FreePath<R> path_;
  Rotation<R> start_;
  Vector<R> spin_;  ///< at the start, body frame
  std::optional<Regular<R>> regular_;
  ThreeMoments<R> general_;
  Rotation<R> frame_;  ///< from the pole to the momentum, which stays
};

}  // namespace

std::optional<ExactMotion> torque_free(const LoneBody& body) {
  if (!moves_freely(body)) return std::nullopt;
  return motion_of<FreeBody>("free rigid body in elliptic functions (Landau & Lifshitz, Mechanics 37)", body);
}

}  // namespace ballpark::cost
