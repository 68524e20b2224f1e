// Magnus lift on a ball whose spin stays, with or without gravity: a helix, or a drift across the pull.
#include "perf/cost/closed_forms/acting.h"
#include "perf/cost/closed_forms/series.h"

namespace ballpark::cost {

namespace {

/// v' = W x v + g with W = S w/m, as of a charge in uniform fields (Landau & Lifshitz, Fields 21-22). The exponential
/// of the cross product K = W x and its integrals, by Rodrigues' formula in Stumpff's functions c_k(W^2 t^2):
///   e^(tK) = 1 + t c1 K + t^2 c2 K^2,  and each integral over time raises every power of t and index by one.
template <class R>
class Lift {
 public:
  explicit Lift(const LoneBody& body)
      : start_(body.start.position.cast<R>()),
        velocity_(body.start.velocity.cast<R>()),
        gravity_(gravity<R>(body)),
        rate_(sum<R>(body, "magnus", "coefficient") / R(body.mass) * body.start.angular_velocity.cast<R>()),
        spin_(body) {}
  bool fits() const { return true; }
  ExactState<R> at(R t) const {
    const Stumpff<R> c(rate_.squaredNorm() * t * t);
    const Vector<R> v = turned(velocity_, R(1), t * c.c1, t * t * c.c2);
    const Vector<R> falling = turned(gravity_, t, t * t * c.c2, t * t * t * c.c3);
    const Vector<R> way = turned(velocity_, t, t * t * c.c2, t * t * t * c.c3);
    const Vector<R> fall = turned(gravity_, t * t / 2, t * t * t * c.c3, t * t * t * t * c.c4);
    return state_of<R>(start_ + way + fall, v + falling, spin_.orientation(t), spin_.spin());
  }

 private:
  Vector<R> turned(const Vector<R>& a, R plain, R once, R twice) const {
    const Vector<R> k = rate_.cross(a);
    return plain * a + once * k + twice * rate_.cross(k);
  }

  Vector<R> start_, velocity_, gravity_, rate_;
  UniformSpin<R> spin_;
};

}  // namespace

std::optional<ExactMotion> constant_spin_lift(const LoneBody& body) {
  if (!only_these_act(body, {"magnus", "gravity"}) || !spins_uniformly(body)) return std::nullopt;
  return motion_of<Lift>("steady lift (as a charge in uniform fields: Landau & Lifshitz, Fields 21-22)", body);
}

}  // namespace ballpark::cost
