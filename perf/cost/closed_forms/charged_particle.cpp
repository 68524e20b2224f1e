// A charge in uniform fields, with or without gravity: a helix about B that speeds up along it, and drifts across E.
#include "perf/cost/closed_forms/steady_turning.h"

namespace ballpark::cost {

namespace {

/// m v' = q E + q v x B + m g.
template <class R>
class Charge : public SteadyTurning<R> {
 public:
  explicit Charge(const LoneBody& body) : SteadyTurning<R>(body, turning<R>(body), uniform_push<R>(body)) {}
  bool fits() const { return true; }
};

}  // namespace

std::optional<ExactMotion> charged_particle(const LoneBody& body) {
  if (!only_these_act(body, {"electric_field", "magnetic_field", "gravity"}) || !spins_uniformly(body)) {
    return std::nullopt;
  }
  return motion_of<Charge>("charge in uniform fields (Landau & Lifshitz, Fields 20-22)", body);
}

}  // namespace ballpark::cost
