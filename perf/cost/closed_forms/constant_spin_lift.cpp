// Magnus lift on a ball whose spin stays, with or without gravity: a helix, or a drift across the pull.
#include "perf/cost/closed_forms/steady_turning.h"

namespace ballpark::cost {

namespace {

/// v' = W x v + g with W = S w/m.
template <class R>
class Lift : public SteadyTurning<R> {
 public:
  explicit Lift(const LoneBody& body)
      : SteadyTurning<R>(body,
                         sum<R>(body, "magnus", "coefficient") / R(body.mass) * body.start.angular_velocity.cast<R>(),
                         gravity<R>(body)) {}
  bool fits() const { return true; }
};

}  // namespace

std::optional<ExactMotion> constant_spin_lift(const LoneBody& body) {
  if (!only_these_act(body, {"magnus", "gravity"}) || !spins_uniformly(body)) return std::nullopt;
  return motion_of<Lift>("steady lift (as a charge in uniform fields: Landau & Lifshitz, Fields 21-22)", body);
}

}  // namespace ballpark::cost
