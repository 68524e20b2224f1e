// What `orbits` compares: a problem, a method of Ballpark's and odeint's counterpart, one solve or many copies.
#pragma once

#include <string>
#include <vector>

#include "perf/peers/orbits_curves.h"

namespace ballpark::perf {

struct OrbitCase {
  std::string name;
  std::string problem, integrator, stepper;  ///< Ballpark's and odeint's names
  std::vector<double> ours, peers;           ///< settings of each
  std::vector<double> errors;                ///< at which times are compared
  int copies = 1;
  bool at_most = true;  ///< the bar is on ours / odeint's; else on odeint's / ours
  double bar = 0;
  double aim = 0;  ///< what one would like; 0: the bar
};

struct OrbitResult {
  OrbitCase orbit;
  std::vector<Curve> curves;  ///< ours, odeint's; of copies also ours on two threads
  std::vector<EqualError> at_errors;
  EqualError mean{};
  std::vector<EqualError> gain_of_threads;  ///< copies: one thread over two
  bool met = false;                         ///< by the minima
};

std::vector<OrbitCase> orbit_cases();
OrbitResult measure(const OrbitCase& orbit, const Effort& effort);

}  // namespace ballpark::perf
