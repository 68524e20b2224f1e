#include "perf/peers/orbits_problems.h"

#include <algorithm>
#include <cmath>

namespace ballpark::perf {

OrbitProblem kepler_problem() {
  return {.name = "kepler",
          .duration = 20,
          .mass = {},
          .position = {{0.4, 0}},
          .velocity = {{0, 2}},
          .end = {{-0.77007557841124045, 0.78834481699442439}}};
}

OrbitProblem pleiades_problem() {
  return {.name = "pleiades",
          .duration = 3,
          .mass = {1, 2, 3, 4, 5, 6, 7},
          .position = {{3, 3}, {3, -3}, {-1, 2}, {-3, 0}, {2, 0}, {-2, -4}, {2, 4}},
          .velocity = {{0, 0}, {0, 0}, {0, 0}, {0, -1.25}, {0, 1}, {1.75, 0}, {-1.5, 0}},
          .end = {{0.3706139143970502, -3.943437585517392},
                  {3.237284092057233, -3.271380973972550},
                  {-3.222559032418324, 5.225081843456543},
                  {0.6597091455775310, -2.590612434977470},
                  {0.3425581707156584, 1.198213693392275},
                  {1.562172101400631, -0.2429682344935824},
                  {-0.7003092922212495, 1.091449240428980}}};
}

namespace {

void append(const std::vector<PlaneVector>& vectors, OrbitState& state) {
  for (const PlaneVector& v : vectors) state.push_back(v.x);
  for (const PlaneVector& v : vectors) state.push_back(v.y);
}

}  // namespace

OrbitState start_of(const OrbitProblem& problem) {
  OrbitState state;
  append(problem.position, state);
  append(problem.velocity, state);
  return state;
}

OrbitState end_of(const OrbitProblem& problem) {
  OrbitState state;
  append(problem.end, state);
  return state;
}

double orbit_error(const OrbitState& places, const OrbitState& end) {
  double error = 0, scale = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    error = std::max(error, std::abs(end.at(i) - places[i]));
    scale = std::max(scale, std::abs(places[i]));
  }
  return error / scale;
}

}  // namespace ballpark::perf
