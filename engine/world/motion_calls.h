// A motion without its type: what implicit steps ask of one body.
#pragma once

#include "engine/world/kernel_table.h"

namespace ballpark::BALLPARK_PRECISION {

/// Rates of a body's state, and what they change with: the state, and a pull (a force at its centre of mass).
struct BodyRates {
  Real rate[max_state_size];
  Real by_state[max_state_size][max_state_size];
  Real by_pull[max_state_size][3];
  Real place_by_state[6][max_state_size];  ///< of position and velocity
};

struct MotionCalls {
  int size;                            ///< of the state
  int quantity_begin[max_state_size];  ///< of each value: where the vector or quaternion begins that it is part of
  void (*load)(const StepGroup&, std::size_t row, Real* y);
  /// What is of one size over a step h: distances; their rates, by h; angular momenta, as turns over h; quaternions.
  void (*units)(const StepGroup&, std::size_t row, Real h, Real* unit);
  /// Position and velocity.
  void (*place)(const StepGroup&, std::size_t row, const Real* y, Real (&place)[6]);
  /// So long after the step's start [s].
  void (*rates)(const StepGroup&, std::size_t row, const Real* y, double after, BodyRates& out);
  void (*pulled_rates)(const StepGroup&, std::size_t row, const Real* y, double after, const Vector3<Real>& pull,
                       BodyRates& out);
  /// The state changed, normalised and stored. Is it finite (and not so large that its sum overflows)?
  bool (*move)(const StepGroup&, std::size_t row, const Real* change);
};

const MotionCalls& calls_of(MotionKind kind);

}  // namespace ballpark::BALLPARK_PRECISION
