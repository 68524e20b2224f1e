// The centre of mass under uniform gravity and linear drag.
#pragma once

#include "perf/cost/closed_forms/acting.h"
#include "perf/cost/closed_forms/series.h"

namespace ballpark::cost {

inline bool moves_freely(const LoneBody& body) {
  return only_these_act(body, {"gravity", "linear_drag"});
}

/// x'' = g - b x' by variation of constants (Hochbruck & Ostermann, Acta Numerica 19 (2010) 2.1): with z = -b t,
///   v = v0 e^z + g t phi_1(z),   x = x0 + v0 t phi_1(z) + g t^2 phi_2(z).
template <class R>
class FreePath {
 public:
  explicit FreePath(const LoneBody& body)
      : position_(body.start.position.cast<R>()),
        velocity_(body.start.velocity.cast<R>()),
        gravity_(gravity<R>(body)),
        damping_(sum<R>(body, "linear_drag", "coefficient") / R(body.mass)) {}
  Vector<R> position(R t) const {
    const R z = -damping_ * t;
    return position_ + t * phi1(z) * velocity_ + t * t * phi2(z) * gravity_;
  }
  Vector<R> velocity(R t) const {
    const R z = -damping_ * t;
    return std::exp(z) * velocity_ + t * phi1(z) * gravity_;
  }

 private:
  Vector<R> position_, velocity_, gravity_;
  R damping_;
};

}  // namespace ballpark::cost
