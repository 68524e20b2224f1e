// Reference problems: a scene, and the values that its quantities must end with.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/physics/measures.h"
#include "tests/physics/scenes.h"

namespace ballpark::tests {

struct Quantity {
  std::string name;
  std::function<Numbers(const World&)> measure;
  Numbers exact;  ///< at the end of the run
};

struct ReferenceProblem {
  std::string name;
  Scene scene;
  std::vector<Quantity> quantities;
  long double tolerance = 1e-9L;  ///< of the error over each quantity's largest value
};

/// One entry for each quantity of a problem.
struct Outcome {
  std::vector<Numbers> end;
  std::vector<long double> scale;   ///< the largest value on the way
  std::vector<long double> errors;  ///< over the scale
  Status status;
};

inline Outcome run(const ReferenceProblem& problem) {
  World world(problem.scene);
  const std::size_t count = problem.quantities.size();
  Outcome outcome{std::vector<Numbers>(count), std::vector<long double>(count), {}, {}};
  constexpr int samples = 64;
  for (int sample = 0; sample <= samples; ++sample) {
    world.advance_to(problem.scene.run.duration * sample / samples);
    for (std::size_t i = 0; i < count; ++i) {
      outcome.end[i] = problem.quantities[i].measure(world);
      outcome.scale[i] = std::max(outcome.scale[i], largest(outcome.end[i]));
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    outcome.errors.push_back(largest_difference(outcome.end[i], problem.quantities[i].exact) / outcome.scale[i]);
  }
  outcome.status = world.status();
  return outcome;
}

/// Fall under gravity and quadratic drag from rest, after 2 s or 10 s.
ReferenceProblem p_d1_from_rest(double duration);
ReferenceProblem p_d2_throw();
ReferenceProblem p_o1_damped_oscillator();
ReferenceProblem p_o2_stiff_oscillator();
ReferenceProblem p_k1_kepler(double eccentricity);
ReferenceProblem p_m1_magnus();
ReferenceProblem p_b1_charge();
ReferenceProblem p_f1_foucault();
ReferenceProblem p_n1_pendulum(double degrees);
ReferenceProblem p_r1_torque_free();
ReferenceProblem p_r2_tennis_racket();
ReferenceProblem p_r3_top();

/// All of them, each with a step that meets its tolerance in double.
std::vector<ReferenceProblem> reference_problems();

}  // namespace ballpark::tests
