// A heavy symmetric top about its pivot, and with it the spherical pendulum: any start.
#include <array>

#include "perf/cost/closed_forms/elliptic.h"
#include "perf/cost/closed_forms/pivoted.h"
#include "perf/cost/closed_forms/root.h"

namespace ballpark::cost {

namespace {

/// c0 + c1 x + c2 x^2 + c3 x^3
template <class R>
using Cubic = std::array<R, 4>;

/// The one x in [0, end] where the polynomial rises through zero.
template <class R>
R rising_root_of(const Cubic<R>& p, R end) {
  return rising_root<R>(
      [&](R x) {
        return std::pair<R, R>(p[0] + x * (p[1] + x * (p[2] + x * p[3])), p[1] + x * (2 * p[2] + 3 * x * p[3]));
      },
      R(0), end);
}

/// How far the axis leans: cosine u of the angle to the vertical, u'^2 = f(u) = (1 - u^2)(E - B u) - (b - a u)^2, B = 2
/// m g l/J1, b and a the vertical and axial momenta over J1 (Goldstein, Classical Mechanics 5.7). u swings between
/// roots u1 <= u2 of f, the third is u3: u = u1 + D sn^2, D = u2 - u1, rate^2 = B (u3 - u1)/4, m = D/(u3 - u1)
/// (Whittaker, Analytical Dynamics 71). Roots are sought from the start, from the zenith and from the nadir, each as
/// a distance, as differences of roots lose digits.
template <class R>
class Nutation {
 public:
  struct Start {
    R above, below;  ///< 1 - u and 1 + u
    R rate, square;  ///< u', and the square of the axis's angular velocity
    R level;         ///< vertical component of that: b - a u
    R a, weight;     ///< B
  };
  /// Sine and cosine of half the angle, and their rates. They change sign where the axis passes the zenith or nadir.
  struct Half {
    R sine, cosine, sine_rate, cosine_rate;
  };

  Nutation() = default;
  explicit Nutation(const Start& s) : zenith_(s.level - s.a * s.above), nadir_(s.level + s.a * s.below) {
    const R u = (s.below - s.above) / 2, b = s.weight;
    const Cubic<R> f = {s.rate * s.rate, 2 * s.a * s.level - 2 * u * s.square - b * s.above * s.below,
                        2 * u * b - s.square - s.a * s.a, b};
    find_turns(f, s.above, s.below);
    depth_ = down_ + up_;
    // A turn that is near is found from the start, one near its pole from there: roots close together are sought best
    // from close by.
    const R zenith_slope = s.square - b * s.above, nadir_slope = s.square + b * s.below;
    top_ = 2 * up_ < s.above ? s.above - up_ : gap(zenith_, zenith_slope, b, s.a, s.above);
    bottom_ = 2 * down_ < s.below ? s.below - down_ : gap(nadir_, nadir_slope, -b, -s.a, s.below);
    // B (u3 - u2) from the pair products of 1 - u1, 1 - u2, 1 - u3: a sleeping top's u3 is close to 1.
    const R lowest = top_ + depth_, linear = 2 * (zenith_slope - s.a * zenith_);
    const R beyond = b * top_ + (linear + b * lowest * top_) / (lowest + top_), reach = beyond + b * depth_;
    fits_ = beyond > 0 && (zenith_ != 0 || nadir_ != 0);
    if (!fits_) return;
    rate_ = std::sqrt(reach) / 2;
    functions_ = Elliptic<R>(b * depth_ / reach, beyond / reach);
    const R cn = std::copysign(std::sqrt(up_ / depth_), s.rate);
    begin_ = depth_ > 0 ? functions_.argument(std::sqrt(down_ / depth_), cn) : R(0);
  }
  bool fits() const { return fits_; }
  R zenith() const { return zenith_; }  ///< b - a
  R nadir() const { return nadir_; }    ///< b + a

  Half half(R t) const {
    const auto [sn, cn, dn, amplitude] = functions_.at(rate_ * t + begin_);
    const R through = std::sqrt(depth_ / 2), slope = depth_ * rate_ * sn * cn * dn / 2;
    Half h;
    h.sine = top_ == 0 ? through * cn : std::sqrt((top_ + depth_ * cn * cn) / 2);
    h.cosine = bottom_ == 0 ? through * sn : std::sqrt((bottom_ + depth_ * sn * sn) / 2);
    h.sine_rate = top_ == 0 ? -through * rate_ * sn * dn : -slope / h.sine;
    h.cosine_rate = bottom_ == 0 ? through * rate_ * cn * dn : slope / h.cosine;
    return h;
  }
  /// (b - a) int_0^t dt/(1 - u), without the jump by pi of an axis that passes the zenith: there b = a.
  R zenith_angle(R t) const { return zenith_ == 0 ? R(0) : zenith_ * third(top_ + depth_, top_, t); }
  /// (b + a) int_0^t dt/(1 + u)
  R nadir_angle(R t) const { return nadir_ == 0 ? R(0) : nadir_ * third(bottom_, bottom_ + depth_, t); }

 private:
  R third(R p, R q, R t) const {
    return (functions_.third_kind(p, q, rate_ * t + begin_) - functions_.third_kind(p, q, begin_)) / rate_;
  }

  /// Ways down to u1 and up to u2 from the start; if it is at a turn, that root is split off.
  void find_turns(const Cubic<R>& f, R above, R below) {
    if (f[0] > 0) {
      up_ = rising_root_of<R>({-f[0], -f[1], -f[2], -f[3]}, above);
      down_ = rising_root_of<R>({-f[0], f[1], -f[2], f[3]}, below);
    } else if (f[1] > 0) {
      up_ = rising_root_of<R>({-f[1], -f[2], -f[3], 0}, above);
    } else if (f[1] < 0) {
      down_ = rising_root_of<R>({f[1], -f[2], f[3], 0}, below);
    }
  }

  /// The distance x of a turn from its pole, where f = x (2 - x)(e + b x) - (d + a x)^2.
  static R gap(R d, R e, R b, R a, R end) {
    const R linear = 2 * e - 2 * a * d, square = 2 * b - e - a * a;
    if (d != 0) return rising_root_of<R>({-d * d, linear, square, -b}, end);
    return linear > 0 ? R(0) : rising_root_of<R>({linear, square, -b, 0}, end);
  }

  Elliptic<R> functions_;
  R zenith_ = 0, nadir_ = 0, down_ = 0, up_ = 0, depth_ = 0, top_ = 0, bottom_ = 0, rate_ = 0, begin_ = 0;
  bool fits_ = false;
};

/// The axis's azimuth phi and the body's turn psi about it: phi' = (b - a u)/(1 - u^2), psi' = w3 - u phi'. By partial
/// fractions (phi + psi)' = w3 - a + (b + a)/(1 + u), (phi - psi)' = a - w3 + (b - a)/(1 - u): integrals of the third
/// kind, each harmless at the other's pole.
template <class R>
class Top {
 public:
  explicit Top(const LoneBody& body) : start_(body) {
    const R length = start_.arm.norm(), pull = start_.gravity.norm();
    if (!(length > 0) || !(pull > 0)) return;
    const Vector<R> axis = start_.arm / length;
    const std::optional<Vector<R>> moments = about_axis(start_.orientation.conjugate() * axis);
    if (!moments) return;
    const R across = moments->x() + start_.mass * length * length;
    up_ = -start_.gravity / pull;
    axial_spin_ = start_.spin.dot(axis);
    axial_ = moments->y() * axial_spin_ / across;
    const Vector<R> swing = start_.spin.cross(axis), leaning = start_.spin - axial_spin_ * axis;
    const R above = (axis - up_).squaredNorm() / 2, below = (axis + up_).squaredNorm() / 2;
    still_ = swing.squaredNorm() == 0 && (above == 0 || below == 0);
    nutation_ = Nutation<R>({above, below, swing.dot(up_), leaning.squaredNorm(), leaning.dot(up_), axial_,
                             2 * start_.mass * pull * length / across});
    fits_ = still_ || nutation_.fits();
    if (fits_ && !still_) choose_frame(axis, swing, above < below);
  }
  bool fits() const { return fits_; }

  ExactState<R> at(R t) const {
    if (still_) return start_.turned(rotation_by<R>(start_.spin * t), start_.spin);
    const typename Nutation<R>::Half half = nutation_.half(t);
    const R drift = (axial_spin_ - axial_) * t, sum = drift + nutation_.nadir_angle(t);
    const R difference = nutation_.zenith_angle(t) - drift, phi = (sum + difference) / 2;
    // Turns about up by phi, west by the lean, up by psi; before them the start's lean is undone.
    const Vector<R> imaginary = half.cosine * std::sin(sum / 2) * up_ + half.sine * std::cos(difference / 2) * west_ -
                                half.sine * std::sin(difference / 2) * north_;
    const Rotation<R> leaning(half.cosine * std::cos(sum / 2), imaginary.x(), imaginary.y(), imaginary.z());
    return start_.turned(leaning * upright_, spin(half, phi));
  }

 private:
  /// Moments across and along the axis, if the body has one there.
  std::optional<Vector<R>> about_axis(const Vector<R>& axis) const {
    const Vector<R>& i = start_.moments;
    const R tolerance = R(geometry_tolerance);
    for (int e = 0; e < 3; ++e) {
      const R one = i[(e + 1) % 3], other = i[(e + 2) % 3];
      const bool round = std::abs(one - other) <= tolerance * one;
      const bool along = axis.cross(Vector<R>::Unit(e)).norm() <= tolerance;
      if (round && (along || i[e] == one)) return Vector<R>(one, i[e], 0);
    }
    return std::nullopt;
  }

  /// The axis starts in the plane of up and north. If it starts on the vertical, where it goes is north or, as the sine
  /// of its lean falls through zero at the zenith, south.
  void choose_frame(const Vector<R>& axis, const Vector<R>& swing, bool zenith) {
    const typename Nutation<R>::Half half = nutation_.half(0);
    const Vector<R> level = axis - axis.dot(up_) * up_;
    if (level.squaredNorm() > 0) {
      north_ = std::copysign(R(1), half.sine * half.cosine) * level.normalized();
    } else {
      north_ = (zenith ? -1 : 1) * swing.normalized();
    }
    west_ = up_.cross(north_);
    const Vector<R> imaginary = -half.sine * west_;
    upright_ = Rotation<R>(half.cosine, imaginary.x(), imaginary.y(), imaginary.z()).normalized();
  }

  /// theta' about the line of nodes, phi' sin(theta) across it and the axis, and the axial spin.
  Vector<R> spin(const typename Nutation<R>::Half& h, R phi) const {
    const bool near_zenith = std::abs(h.sine) < std::abs(h.cosine);
    const R theta_rate = near_zenith ? 2 * h.sine_rate / h.cosine : -2 * h.cosine_rate / h.sine;
    const R d = nutation_.zenith(), s = nutation_.nadir();
    R sideways = 0;
    if (near_zenith) {
      sideways = (d == 0 ? R(0) : d / (2 * h.sine * h.cosine)) + axial_ * h.sine / h.cosine;
    } else {
      sideways = (s == 0 ? R(0) : s / (2 * h.sine * h.cosine)) - axial_ * h.cosine / h.sine;
    }
    const R sine = 2 * h.sine * h.cosine, cosine = (h.cosine - h.sine) * (h.cosine + h.sine);
    const Vector<R> outward = std::cos(phi) * north_ + std::sin(phi) * west_;
    const Vector<R> axis = sine * outward + cosine * up_;
    return theta_rate * up_.cross(outward) + sideways * (sine * up_ - cosine * outward) + axial_spin_ * axis;
  }

  Pivoted<R> start_;
  Vector<R> up_, north_, west_;
  R axial_spin_ = 0, axial_ = 0;  ///< w3, and a = J3 w3/J1
  Nutation<R> nutation_;
  Rotation<R> upright_;
  bool fits_ = false, still_ = false;
};

}  // namespace

std::optional<ExactMotion> symmetric_top(const LoneBody& body) {
  if (!hangs_on_one_pivot(body)) return std::nullopt;
  return motion_of<Top>("heavy symmetric top in elliptic functions (Goldstein, Classical Mechanics 5.7)", body);
}

}  // namespace ballpark::cost
