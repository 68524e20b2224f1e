// A velocity that turns at a steady rate and is pushed steadily: a helix, drifting across the push.
#pragma once

#include "perf/cost/closed_forms/acting.h"
#include "perf/cost/closed_forms/series.h"

namespace ballpark::cost {

/// v' = W x v + a, as of a charge in uniform fields (Landau & Lifshitz, Fields 21-22). The exponential of the cross
/// product K = W x and its integrals, by Rodrigues' formula in Stumpff's functions c_k(W^2 t^2), which hold at W = 0:
///   e^(tK) = 1 + t c1 K + t^2 c2 K^2,  and each integral over time raises every power of t and index by one.
template <class R>
class SteadyTurning {
 public:
  SteadyTurning(const LoneBody& body, const Vector<R>& rate, const Vector<R>& push)
      : start_(body.start.position.cast<R>()),
        velocity_(body.start.velocity.cast<R>()),
        push_(push),
        rate_(rate),
        spin_(body) {}
  ExactState<R> at(R t) const {
    const Stumpff<R> c(rate_.squaredNorm() * t * t);
    const Vector<R> v = turned(velocity_, R(1), t * c.c1, t * t * c.c2);
    const Vector<R> pushed = turned(push_, t, t * t * c.c2, t * t * t * c.c3);
    const Vector<R> way = turned(velocity_, t, t * t * c.c2, t * t * t * c.c3);
    const Vector<R> drift = turned(push_, t * t / 2, t * t * t * c.c3, t * t * t * t * c.c4);
    return state_of<R>(start_ + way + drift, v + pushed, spin_.orientation(t), spin_.spin());
  }

 private:
  Vector<R> turned(const Vector<R>& a, R plain, R once, R twice) const {
    const Vector<R> k = rate_.cross(a);
    return plain * a + once * k + twice * rate_.cross(k);
  }

  Vector<R> start_, velocity_, push_, rate_;
  UniformSpin<R> spin_;
};

}  // namespace ballpark::cost
