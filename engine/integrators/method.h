// Integrators: families are interpreters, methods are rows of coefficients. A step is a sequence of phases, the same
// for every family and whether the phases run in registers (fused) or as passes over memory (staged):
//   prepare(p)   from the state y and the rates so far, the trial state at which forces are evaluated
//   evaluate     rates k[p] at the trial state
//   finish       the state after the step
// Rates come in sets of one for each value of the state. Set p is that of phase p; some methods keep sets between
// steps.
#pragma once

#include "engine/core/real.h"

namespace ballpark::BALLPARK_PRECISION {

/// How orientations follow from spins. (Body: what moves is another motion, see Spin::body.)
enum class RotationRule { renormalise, exponential, splitting, body };

enum class Family { explicit_runge_kutta, chained_runge_kutta, taylor, splitting, multistep, implicit_runge_kutta };
inline constexpr int family_count = 5;  ///< of those with kernels: not the implicit one
inline constexpr int max_phases = 27;
inline constexpr int max_history = 4;  ///< sets of rates of earlier steps
inline constexpr int max_errors = 2;
inline constexpr int max_turns = 9;

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
  bool turns_velocity = false;  ///< splitting: effects that turn velocities do so within the kick (Boris)
  RotationRule rotation = RotationRule::renormalise;  ///< splitting: of drifts
  int turns = 1;                                      ///< by splitting: parts of each drift
  Real turn_share[max_turns] = {1};                   ///< and their shares of it

  // Embedded pairs, at a tolerance:
  int errors = 0;                           ///< estimates of the step's error; 0: the step is given
  Real error[max_errors][max_phases] = {};  ///< h times their weights
  Real absolute = 0, relative = 0;          ///< tolerance, see over_tolerance (error.h)
  bool first_known = false;                 ///< rates of the first phase are in set 0, from the step before
  int last_set = 0;                         ///< where whole steps leave those of the last phase

  // Multistep:
  bool keeps_first = false;         ///< Runge-Kutta that starts one: whole steps leave their first rates in set 0
  int history = 0;                  ///< sets of earlier steps that are read
  int history_begin = 0;            ///< the set of the step before; then that before it, ...
  Real past[max_history + 1] = {};  ///< h times the weights of the rates at this step's start, at the one before, ...
  Real corrector[max_history + 2] = {};  ///< of a second phase: of its own rates, then as `past`
};

}  // namespace ballpark::BALLPARK_PRECISION
