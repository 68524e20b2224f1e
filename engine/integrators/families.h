// The families of methods: a family is code, a method is a row of coefficients for it.
#pragma once

#include "engine/integrators/multistep_family.h"
#include "engine/integrators/runge_kutta_family.h"
#include "engine/integrators/splitting_family.h"

namespace ballpark::BALLPARK_PRECISION {

/// A whole step in registers: all phases of the family F. `kept`: sets of rates that stay between steps.
template <class F, class S, class Constants, class Forces>
BALLPARK_INLINE void whole_step(const Method& m, const Constants& c, const Forces& forces,
                                const ColumnRates<typename S::Motion, typename S::Value>& kept, S& state) {
  if constexpr (requires { F::whole_step(m, c, forces, kept, state); }) {
    F::whole_step(m, c, forces, kept, state);
  } else {
    using M = typename S::Motion;
    typename S::Value trial[S::size];
    LocalRates<M, typename S::Value> k;
    for (int p = 0; p < m.phases; ++p) {
      F::prepare(m, p, c, forces, state, k, trial);
      evaluate<M>(forces, c, trial, m.offset[p], k.values[p]);
    }
    F::finish(m, c, forces, k, state);
  }
}

/// Calls f with the family's type, as `f.template operator()<F>()`.
template <class F>
decltype(auto) with_family(Family family, F&& f) {
  switch (family) {
    case Family::chained_runge_kutta:
      return f.template operator()<ChainedRungeKutta>();
    case Family::taylor:
      return f.template operator()<Taylor>();
    case Family::splitting:
      return f.template operator()<Splitting>();
    case Family::multistep:
      return f.template operator()<Multistep>();
    case Family::explicit_runge_kutta:
    case Family::implicit_runge_kutta:  // solved elsewhere
      break;
  }
  return f.template operator()<ExplicitRungeKutta>();
}

}  // namespace ballpark::BALLPARK_PRECISION
