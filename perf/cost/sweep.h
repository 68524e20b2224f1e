// The ways to run a scene: which are tried, from coarse to fine, and how far off each one is.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "perf/cost/ground.h"

namespace ballpark::cost {

/// What to try; what is empty is chosen. Names were checked.
struct Axes {
  std::vector<std::string> integrators;
  std::vector<double> steps, tolerances;  ///< [s]; either: no other pace
  std::vector<Precision> precisions;
  std::vector<ContactChoice> contacts;  ///< of scenes with contacts; asked for: without numbers, the usual ones
  std::vector<std::string> rotations;   ///< of scenes in which bodies turn
  std::vector<double> openings;         ///< of scenes in which enough bodies attract each other for a tree [rad]
};

/// A curve to be tried: its settings from coarse to fine.
struct Candidate {
  Curve curve;
  std::vector<Setting> settings;
};
/// Curves that the scene takes (of contacts: those of the axes as they are, or the scene's own), those that serve most
/// scenes first, and sentences on those that it refuses.
std::vector<Candidate> candidates(const Scene& scene, const Axes& axes, std::size_t look_count,
                                  std::vector<std::string>& refused);

/// How long a sweep may take, timing included.
struct SweepTime {
  double seconds = 0;
  int rounds = 9;  ///< of timing
};

/// Runs every candidate from coarse to fine until it meets the floor, gains no more, or has used its share of the time.
/// Fills result.curves, points and left_out. False if it was stopped.
bool sweep(const Ground& ground, const std::vector<Candidate>& list, const SweepTime& time, Result& result,
           const std::function<bool(double fraction)>& go_on);

/// One point: built, run as `run` does, looked at.
Point measured_point(const Ground& ground, const Setting& setting, const GoOn& go_on);

}  // namespace ballpark::cost
