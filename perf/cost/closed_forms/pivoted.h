// A body on a fixed point, under gravity alone: what its closed forms start from.
#pragma once

#include "perf/cost/closed_forms/acting.h"

namespace ballpark::cost {

inline bool hangs_on_one_pivot(const LoneBody& body) {
  return of_kind(body, "pivot").size() == 1 && only_these_act(body, {"pivot", "gravity"});
}

template <class R>
struct Pivoted {
  Vector<R> pivot, arm, spin, gravity;  ///< world frame; the arm from the pivot to the centre of mass
  Rotation<R> orientation;
  Vector<R> moments;  ///< about the centre of mass, body frame
  R mass;

  explicit Pivoted(const LoneBody& body)
      : pivot(vector(*of_kind(body, "pivot").front(), "point", body.index).cast<R>()),
        arm(body.start.position.cast<R>() - pivot),
        spin(body.start.angular_velocity.cast<R>()),
        gravity(cost::gravity<R>(body)),
        orientation(start_orientation<R>(body)),
        moments(cost::moments<R>(body)),
        mass(R(body.mass)) {
    // As the engine has it: without a spin the velocity tells it, and a point mass never spins about its arm.
    if (spin.isZero(0)) spin = arm.cross(body.start.velocity.cast<R>()) / arm.squaredNorm();
    if (moments.isZero(0)) spin -= arm.dot(spin) / arm.squaredNorm() * arm;
  }

  /// The body turned from its start by `turn`, with angular velocity `w`.
  ExactState<R> turned(const Rotation<R>& turn, const Vector<R>& w) const {
    const Vector<R> now = turn * arm;
    return state_of<R>(pivot + now, w.cross(now), turn * orientation, w);
  }
};

}  // namespace ballpark::cost
