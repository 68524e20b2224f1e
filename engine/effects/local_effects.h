// The effects of this build. To add one: write its file beside the others, include it here and name it in the list.
// Loads are summed in this order, and those of one kind by their parameters, whatever the order in the scene.
#pragma once

#include "engine/effects/applied_force.h"
#include "engine/effects/applied_torque.h"
#include "engine/effects/central_gravity.h"
#include "engine/effects/gravity.h"
#include "engine/effects/linear_drag.h"
#include "engine/effects/magnus.h"
#include "engine/effects/pivot.h"
#include "engine/effects/quadratic_drag.h"
#include "engine/effects/spring.h"

namespace ballpark::BALLPARK_PRECISION {

template <class... E>
struct EffectList {
  static constexpr int count = sizeof...(E);
};

using LocalEffects =
    EffectList<Gravity, LinearDrag, QuadraticDrag, Magnus, Spring, CentralGravity, AppliedForce, AppliedTorque>;

/// The instances of one effect on one group: an array of its Constants.
struct EffectSlot {
  const void* constants = nullptr;
  int count = 0;
};

template <class E, class V>
BALLPARK_INLINE void add_force(const EffectSlot& slot, const Body<V>& body, Loads<V>& sum) {
  const auto* constants = static_cast<const typename E::Constants*>(slot.constants);
  for (int i = 0; i < slot.count; ++i) E::force(constants[i], body, sum);
}

template <class E, class V>
BALLPARK_INLINE void add_force_rate(const EffectSlot& slot, const Body<V>& body, const Acceleration<V>& a,
                                    Loads<V>& sum) {
  const auto* constants = static_cast<const typename E::Constants*>(slot.constants);
  if constexpr (requires { E::force_rate(*constants, body, a, sum); }) {
    for (int i = 0; i < slot.count; ++i) E::force_rate(constants[i], body, a, sum);
  }
}

/// All local effects on one group, as kernels read them: one predicted branch for each effect that is off.
struct LocalForces {
  EffectSlot slots[LocalEffects::count];
  SumColumns sums;

  template <class V>
  BALLPARK_INLINE Loads<V> loads(const Body<V>& body) const {
    Loads<V> sum;
    if (sums.force[0]) sum.force = from_columns<V>(sums.force, body.row);
    if (sums.torque[0]) sum.torque = from_columns<V>(sums.torque, body.row);
    add_forces(LocalEffects{}, body, sum);
    return sum;
  }

  /// Time derivative of the loads; build has checked that every effect on the group has one.
  template <class V>
  BALLPARK_INLINE Loads<V> load_rates(const Body<V>& body, const Acceleration<V>& a) const {
    Loads<V> sum;
    add_force_rates(LocalEffects{}, body, a, sum);
    return sum;
  }

 private:
  template <class V>
  BALLPARK_INLINE static Vector3<V> from_columns(const Real* const (&columns)[3], std::size_t row) {
    return {load<V>(columns[0] + row), load<V>(columns[1] + row), load<V>(columns[2] + row)};
  }

  template <class V, class... E>
  BALLPARK_INLINE void add_forces(EffectList<E...>, const Body<V>& body, Loads<V>& sum) const {
    const EffectSlot* slot = slots;
    (add_force<E>(*slot++, body, sum), ...);
  }

  template <class V, class... E>
  BALLPARK_INLINE void add_force_rates(EffectList<E...>, const Body<V>& body, const Acceleration<V>& a,
                                       Loads<V>& sum) const {
    const EffectSlot* slot = slots;
    (add_force_rate<E>(*slot++, body, a, sum), ...);
  }
};

#ifndef BALLPARK_TARGET
/// Every effect's description and type-erased calls, in the order of LocalEffects.
const std::vector<EffectInfo>& local_effects();
/// Position of an effect in local_effects() by its name; -1 for constraints and unknown names.
int local_effect_index(const std::string& name);
/// Descriptions of all effects, constraints included.
std::vector<EffectDescription> describe_effects();
#endif

}  // namespace ballpark::BALLPARK_PRECISION
