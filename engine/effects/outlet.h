// A sink: bodies whose centre is in a box are gone.
#pragma once

#include "engine/effects/step_effect.h"

namespace ballpark::BALLPARK_PRECISION {

class Outlet : public StepEffect {
 public:
  static constexpr int values = 3;

  explicit Outlet(const StepInput& input) {
    const Vector3d &middle = input.effect.exact_vector("point"), half = 0.5 * input.effect.exact_vector("size");
    for (int c = 0; c < 3; ++c) {
      lower_[c] = static_cast<Real>(middle[c] - half[c]);
      upper_[c] = static_cast<Real>(middle[c] + half[c]);
    }
  }

  void act(const StepBodies& bodies, const EndedStep&) const override {
    for (std::size_t row = bodies.first; row < bodies.last; ++row) {
      bool inside = true;
      for (int c = 0; c < 3; ++c) {
        const Real x = bodies.position[c][row];
        inside = inside && x >= lower_[c] && x <= upper_[c];
      }
      if (inside) bodies.leave(row);
    }
  }

  static EffectDescription description() {
    return {
        .name = "outlet",
        .doc =
            "a sink: takes away bodies whose centre is in a box when a step has ended; what they carried goes with "
            "them (a step should be shorter than the box is thick over the speed)",
        .source = "Poeschel & Schwager 2005, Computational Granular Dynamics",
        .parameters =
            {{.name = "point",
              .kind = ParameterKind::vector,
              .unit = "m",
              .fallback = Vector3d(0, 0, 0),
              .doc = "the middle of the box"},
             {.name = "size", .kind = ParameterKind::vector, .unit = "m", .fallback = {}, .doc = "its three lengths"}},
        .reads = {"position"},
        .exerts = {"present"},
        .flops = 6,
        .between_steps = true};
  }

 private:
  Real lower_[3], upper_[3];
};

}  // namespace ballpark::BALLPARK_PRECISION
