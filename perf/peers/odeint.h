// Boost.odeint on the same problem: one state array and one call of the stepper per body, as its tutorials do it.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "perf/baselines/hand_written.h"

namespace ballpark::perf {

using OdeintState = std::array<double, 6>;  ///< x, y, z, vx, vy, vz of one body

struct OdeintMethod {
  const char* name;        ///< odeint's
  const char* integrator;  ///< Ballpark's row with the same coefficients
  void (*step)(const DragProblem& problem, OdeintState* bodies, std::size_t count);
};

/// Empty if built without Boost.
std::span<const OdeintMethod> odeint_methods();

}  // namespace ballpark::perf
