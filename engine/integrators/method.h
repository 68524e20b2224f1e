// Integrators: families are interpreters, methods are rows of coefficients. A step is a sequence of phases, the same
// for every family and whether the phases run in registers (fused) or as passes over memory (staged):
//   prepare(p)   from the state y and the rates so far, the trial state at which forces are evaluated
//   evaluate     rates k[p] at the trial state
//   finish       the state after the step
#pragma once

#include "engine/core/real.h"

namespace ballpark::BALLPARK_PRECISION {

enum class Family { explicit_runge_kutta, chained_runge_kutta, taylor, splitting };
inline constexpr int family_count = 4;
inline constexpr int max_phases = 13;

/// A row scaled by the step: all that kernels read of a method.
struct Method {
  Family family = Family::explicit_runge_kutta;
  int phases = 1;
  double offset[max_phases] = {};  ///< time of each phase's evaluation after the step's start [s]
  Real step = 0;
  Real half_square = 0;                 ///< h^2 / 2
  Real a[max_phases][max_phases] = {};  ///< Runge-Kutta: h a_ij
  Real b[max_phases] = {};              ///< Runge-Kutta: h b_i
  Real lead = 0;                        ///< splitting: h times the drift before the first kick
  Real kick[max_phases] = {};           ///< splitting: h times the i-th coefficient
  Real drift[max_phases] = {};
};

}  // namespace ballpark::BALLPARK_PRECISION
