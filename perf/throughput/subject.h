// What is timed: subjects with as many bodies do as many steps in a run, and show their state afterwards.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ballpark/ballpark.h"
#include "perf/baselines/hand_written.h"
#include "perf/peers/odeint.h"
#include "perf/timing.h"

namespace ballpark::perf {

/// x, y, z, vx, vy, vz, each by id.
using StateColumns = std::vector<std::vector<double>>;

struct Subject {
  std::string name;
  std::size_t bodies = 0;               ///< 0: not about bodies
  double units = 0;                     ///< body-steps (for the triad: elements) in one run
  double bytes_per_unit = 0;            ///< that must be read and written
  Task run;                             ///< throws if the subject's status is no longer ok
  std::function<StateColumns()> state;  ///< empty if there is none to compare
};

/// The problem and its bodies as bare columns, for subjects that are not a World.
struct Start {
  DragProblem problem;
  StateColumns columns;
};

/// Steps of one run: as many as make a quarter of a million body-steps (some ms), at least one.
std::size_t steps_per_run(std::size_t bodies);

/// Positions and velocities of a world of double precision.
StateColumns state_of(const World& world);

Subject world_subject(std::string name, const Scene& scene, const Options& options);
Subject hand_written_subject(std::string name, const Start& start);
Subject touch_subject(std::string name, const Start& start);
Subject odeint_subject(std::string name, const Start& start, const OdeintMethod& method);
Subject triad_subject(std::string name, int threads);

}  // namespace ballpark::perf
