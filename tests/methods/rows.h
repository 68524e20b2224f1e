// The rows of ballpark::integrators(), and the slope of a row's error against its step.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/integrators.h"
#include "tests/physics/measures.h"
#include "tests/physics/scenes.h"

namespace ballpark::tests {

struct Refinement {
  std::vector<long double> errors;  ///< at n, 2 n, 4 n, 8 n steps

  long double slope(std::size_t halving) const { return std::log2(errors[halving] / errors[halving + 1]); }
};

/// The error of a scene's end at n, 2 n, 4 n and 8 n steps over its duration. Rows of order 5 and more run in extended
/// precision: in double, rounding hides their slopes.
inline Refinement refine(Scene scene, std::uint64_t n, const std::function<long double(const World&)>& error) {
  Refinement refinement;
  for (const IntegratorDescription& row : integrators()) {
    if (row.name == scene.run.integrator && row.order >= 5) scene.run.precision = Precision::extended;
  }
  for (const std::uint64_t steps : {n, 2 * n, 4 * n, 8 * n}) {
    scene.run.step = scene.run.duration / static_cast<double>(steps);
    World world(scene);
    world.step(steps);
    refinement.errors.push_back(error(world));
  }
  return refinement;
}

}  // namespace ballpark::tests
