// Boost.odeint on the orbit problems, as its users would write them: the state in one std::array, its own steppers.
#pragma once

#include <cstddef>
#include <span>

namespace ballpark::perf {

struct OdeintTally {
  std::size_t steps = 0, evaluations = 0;  ///< accepted steps; all evaluations
};

struct OdeintOrbit {
  const char* problem;  ///< OrbitProblem::name
  const char* name;     ///< odeint's stepper
  bool adaptive;        ///< controlled by a tolerance; else given the number of steps
  /// From time 0 to `duration`. `state` as OrbitState. The tally costs time: it is for a run that is not timed.
  void (*solve)(double setting, double duration, double* state);
  OdeintTally (*tally)(double setting, double duration, double* state);
};

/// Empty if built without Boost.
std::span<const OdeintOrbit> odeint_orbits();

}  // namespace ballpark::perf
