// Two problems whose end is known: an eccentric Kepler orbit, and the Pleiades of the IVP test set.
#pragma once

#include <string>
#include <vector>

namespace ballpark::perf {

struct PlaneVector {
  double x, y;
};

/// Bodies in a plane, G = 1.
struct OrbitProblem {
  std::string name;
  double duration;
  std::vector<double> mass;  ///< empty: one body, drawn to the origin by GM = 1
  std::vector<PlaneVector> position, velocity;
  std::vector<PlaneVector> end;  ///< positions at `duration`
  std::size_t bodies() const { return position.size(); }
};

/// Eccentricity 0.6, half axis 1, from the pericentre: 3.2 turns. Kepler's equation gives its end.
OrbitProblem kepler_problem();
/// Seven bodies with close encounters. (Mazzia & Magherini, Test Set for IVP Solvers, Bari; HNW II.10.)
OrbitProblem pleiades_problem();

/// x of all bodies, y of all, then velocities alike.
using OrbitState = std::vector<double>;
OrbitState start_of(const OrbitProblem& problem);
/// The largest distance of a coordinate from its place over the largest coordinate. `places`: at least x and y of all.
double orbit_error(const OrbitState& places, const OrbitState& end);
OrbitState end_of(const OrbitProblem& problem);

}  // namespace ballpark::perf
