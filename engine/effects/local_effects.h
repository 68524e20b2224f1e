// The effects of this build. To add one: write its file beside the others, include it here and name it in the list.
// Loads are summed in this order, and those of one kind by their parameters, whatever the order in the scene. What
// reads loads stands behind what adds them.
#pragma once

#include "engine/effects/added_mass.h"
#include "engine/effects/applied_force.h"
#include "engine/effects/applied_torque.h"
#include "engine/effects/buoyancy.h"
#include "engine/effects/central_gravity.h"
#include "engine/effects/electric_field.h"
#include "engine/effects/gravity.h"
#include "engine/effects/gusts.h"
#include "engine/effects/harmonic_trap.h"
#include "engine/effects/linear_drag.h"
#include "engine/effects/magnetic_field.h"
#include "engine/effects/magnus.h"
#include "engine/effects/pivot.h"
#include "engine/effects/quadratic_drag.h"
#include "engine/effects/reynolds_drag.h"
#include "engine/effects/rotating_frame.h"
#include "engine/effects/spin_decay.h"
#include "engine/effects/spring.h"
#include "engine/effects/table.h"
#include "engine/effects/wind.h"

namespace ballpark::BALLPARK_PRECISION {

template <class... E>
struct EffectList {
  static constexpr int count = sizeof...(E);
};

using LocalEffects = EffectList<Gravity, LinearDrag, QuadraticDrag, Magnus, Spring, CentralGravity, ElectricField,
                                MagneticField, RotatingFrame, AppliedForce, AppliedTorque, HarmonicTrap, Buoyancy,
                                ReynoldsDrag, SpinDecay, AddedMass, Wind, Gusts, Table>;

/// One effect on a group: which of the list, and its Constants.
struct EffectInstance {
  int effect = 0;
  const void* constants = nullptr;
};

/// Loads of bodies in a fluid that flows. Called, so that where nothing flows registers are as if this were not here.
struct LocalForces;
template <class V>
static void add_loads_in_flow(const LocalForces& forces, const Body<V>& body, double after, Loads<V>& sum);

/// All local effects on one group, as kernels read them. What is off is not in the list.
struct LocalForces {
  const EffectInstance *begin = nullptr, *end = nullptr;            ///< that push or turn, by effect
  const EffectInstance *flow_begin = nullptr, *flow_end = nullptr;  ///< that flow
  double start = 0;                                                 ///< of the step [s]
  SumColumns sums;
  bool read_position = true;   ///< does any of them?
  bool turning_apart = false;  ///< loads() leaves out what turning() tells

  bool flows() const { return flow_begin != flow_end; }

  /// So long after the step's start [s].
  template <class V>
  BALLPARK_INLINE Loads<V> loads(const Body<V>& body, double after) const {
    Loads<V> sum;
    if (sums.force[0]) sum.force = from_columns<V>(sums.force, body.row);
    if (sums.torque[0]) sum.torque = from_columns<V>(sums.torque, body.row);
    if (__builtin_expect(flows(), false)) {
      const Body<V> here = body;  // nothing else has an address
      Loads<V> all = sum;
      add_loads_in_flow(*this, here, after, all);
      return all;
    }
    add_loads(body, body, sum);
    return sum;
  }

  /// `through`: the body as seen by what feels the flow.
  template <class V>
  BALLPARK_INLINE void add_loads(const Body<V>& body, const Body<V>& through, Loads<V>& sum) const {
    for (const EffectInstance* at = begin; at != end; ++at) {
      of_kind(LocalEffects{}, *at, [&]<class E>(const typename E::Constants& c) BALLPARK_INLINE_LAMBDA {
        if constexpr (requires { E::turning(c, body); }) {
          if (turning_apart) return E::force(c, at_rest(body), sum);
        }
        if constexpr (requires { E::feels_flow; }) {
          E::force(c, through, sum);
        } else if constexpr (requires { E::force(c, body, sum); }) {
          E::force(c, body, sum);
        }
      });
    }
  }

  /// Velocity of the fluid where the body is, and its rate along the body's path.
  template <class V>
  BALLPARK_INLINE Vector3<V> flow(const Body<V>& body, double time) const {
    Vector3<V> sum;
    for (const EffectInstance* at = flow_begin; at != flow_end; ++at) {
      of_kind(LocalEffects{}, *at, [&]<class E>(const typename E::Constants& c) BALLPARK_INLINE_LAMBDA {
        if constexpr (requires { E::flow(c, body, time); }) sum += E::flow(c, body, time);
      });
    }
    return sum;
  }
  template <class V>
  BALLPARK_INLINE Vector3<V> flow_rate(const Body<V>& body, double time) const {
    Vector3<V> sum;
    for (const EffectInstance* at = flow_begin; at != flow_end; ++at) {
      of_kind(LocalEffects{}, *at, [&]<class E>(const typename E::Constants& c) BALLPARK_INLINE_LAMBDA {
        if constexpr (requires { E::flow_rate(c, body, time); }) sum += E::flow_rate(c, body, time);
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

  /// Time derivative of the loads at the step's start; build has checked that every effect on the group has one.
  template <class V>
  BALLPARK_INLINE Loads<V> load_rates(const Body<V>& body, const Acceleration<V>& a) const {
    Loads<V> sum;
    Body<V> through = body;
    Acceleration<V> past = a;
    if (flows()) {
      through.velocity -= flow(body, start);
      past.linear -= flow_rate(body, start);
    }
    for (const EffectInstance* at = begin; at != end; ++at) {
      of_kind(LocalEffects{}, *at, [&]<class E>(const typename E::Constants& c) BALLPARK_INLINE_LAMBDA {
        if constexpr (requires { E::feels_flow; }) {
          E::force_rate(c, through, past, sum);
        } else if constexpr (requires { E::force_rate(c, body, a, sum); }) {
          E::force_rate(c, body, a, sum);
        }
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

template <class V>
[[gnu::noinline]] static void add_loads_in_flow(const LocalForces& forces, const Body<V>& body, double after,
                                                Loads<V>& sum) {
  Body<V> through = body;
  through.velocity -= forces.flow(body, forces.start + after);
  forces.add_loads(body, through, sum);
}

#ifndef BALLPARK_TARGET
/// Every effect's description and type-erased calls, in the order of LocalEffects.
const std::vector<EffectInfo>& local_effects();
/// Position of an effect in local_effects() by its name; -1 for constraints and unknown names.
int local_effect_index(const std::string& name);
/// Descriptions of all effects, constraints included.
std::vector<EffectDescription> describe_effects();
#endif

}  // namespace ballpark::BALLPARK_PRECISION
