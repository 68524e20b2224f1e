// The loops one would write by hand for one scene, over bare arrays: what Ballpark is measured against.
#pragma once

#include <cstddef>

namespace ballpark::perf {

/// Particles under uniform gravity along z and quadratic drag.
struct DragProblem {
  double gravity = 0;         ///< downwards [m/s^2]
  double drag_over_mass = 0;  ///< k/m [1/m]
  double step = 0;            ///< [s]
};

/// One classic Runge-Kutta step of `count` particles, all four stages in registers. The arrays start on 64 bytes.
void hand_written_rk4(const DragProblem& problem, double* __restrict x, double* __restrict y, double* __restrict z,
                      double* __restrict vx, double* __restrict vy, double* __restrict vz, std::size_t count);

/// Stars that attract each other, G = 1.
struct AttractionProblem {
  double softening = 0;  ///< > 0 [m]
  double step = 0;       ///< [s]
};

/// One step of semi-implicit Euler of `count` stars, every pair from both sides, 16 of them at a time in registers. The
/// arrays have room for a multiple of 16.
void hand_written_attraction(const AttractionProblem& problem, const double* mass, double* const* position,
                             double* const* velocity, std::size_t count);

/// Reads and writes the same arrays with one addition each: the time that memory alone takes.
void touch(double* __restrict x, double* __restrict y, double* __restrict z, double* __restrict vx,
           double* __restrict vy, double* __restrict vz, std::size_t count);

}  // namespace ballpark::perf
