// The effects of this build. To add one: write its file beside the others, include it here and name it in the list.
// Loads are summed in this order, and those of one kind by their parameters, whatever the order in the scene.
#pragma once

#include "engine/effects/applied_force.h"
#include "engine/effects/applied_torque.h"
#include "engine/effects/central_gravity.h"
#include "engine/effects/electric_field.h"
#include "engine/effects/gravity.h"
#include "engine/effects/linear_drag.h"
#include "engine/effects/magnetic_field.h"
#include "engine/effects/magnus.h"
#include "engine/effects/pivot.h"
#include "engine/effects/quadratic_drag.h"
#include "engine/effects/rotating_frame.h"
#include "engine/effects/spring.h"

namespace ballpark::BALLPARK_PRECISION {

template <class... E>
struct EffectList {
  static constexpr int count = sizeof...(E);
};

using LocalEffects = EffectList<Gravity, LinearDrag, QuadraticDrag, Magnus, Spring, CentralGravity, ElectricField,
                                MagneticField, RotatingFrame, AppliedForce, AppliedTorque>;

/// One effect on a group: which of the list, and its Constants.
struct EffectInstance {
  int effect = 0;
  const void* constants = nullptr;
};

/// All local effects on one group, as kernels read them. What is off is not in the list.
struct LocalForces {
  const EffectInstance *begin = nullptr, *end = nullptr;  ///< by effect
  SumColumns sums;
  bool read_position = true;   ///< does any of them?
  bool turning_apart = false;  ///< loads() leaves out what turning() tells

  template <class V>
  BALLPARK_INLINE Loads<V> loads(const Body<V>& body) const {
    Loads<V> sum;
    if (sums.force[0]) sum.force = from_columns<V>(sums.force, body.row);
    if (sums.torque[0]) sum.torque = from_columns<V>(sums.torque, body.row);
    for (const EffectInstance* at = begin; at != end; ++at) {
      of_kind(LocalEffects{}, *at, [&]<class E>(const typename E::Constants& c) BALLPARK_INLINE_LAMBDA {
        if constexpr (requires { E::turning(c, body); }) {
          if (turning_apart) return E::force(c, at_rest(body), sum);
        }
        E::force(c, body, sum);
      });
    }
    return sum;
  }

  /// W of all that turns velocities, dv/dt = W x v [1/s].
  template <class V>
  BALLPARK_INLINE Vector3<V> turning(const Body<V>& body) const {
    Vector3<V> sum;
    for (const EffectInstance* at = begin; at != end; ++at) {
      of_kind(LocalEffects{}, *at, [&]<class E>(const typename E::Constants& c) BALLPARK_INLINE_LAMBDA {
        if constexpr (requires { E::turning(c, body); }) sum += E::turning(c, body);
      });
    }
    return sum;
  }

  /// Time derivative of the loads; build has checked that every effect on the group has one.
  template <class V>
  BALLPARK_INLINE Loads<V> load_rates(const Body<V>& body, const Acceleration<V>& a) const {
    Loads<V> sum;
    for (const EffectInstance* at = begin; at != end; ++at) {
      of_kind(LocalEffects{}, *at, [&]<class E>(const typename E::Constants& c) BALLPARK_INLINE_LAMBDA {
        if constexpr (requires { E::force_rate(c, body, a, sum); }) E::force_rate(c, body, a, sum);
      });
    }
    return sum;
  }

 private:
  template <class V>
  BALLPARK_INLINE static Body<V> at_rest(Body<V> body) {
    body.velocity = {};
    return body;
  }
  template <class V>
  BALLPARK_INLINE static Vector3<V> from_columns(Real* const (&columns)[3], std::size_t row) {
    return {load<V>(columns[0] + row), load<V>(columns[1] + row), load<V>(columns[2] + row)};
  }

  /// Calls f with the instance's effect as a type: compilers make a jump table of the comparisons.
  template <class... E, class F>
  BALLPARK_INLINE static void of_kind(EffectList<E...>, const EffectInstance& instance, F f) {
    int kind = 0;
    (void)((instance.effect == kind++ &&
            (f.template operator()<E>(*static_cast<const typename E::Constants*>(instance.constants)), true)) ||
           ...);
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
