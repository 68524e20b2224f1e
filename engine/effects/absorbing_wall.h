// A plane that swallows bodies: those whose centre a step took behind it are gone.
#pragma once

#include "engine/effects/step_effect.h"

namespace ballpark::BALLPARK_PRECISION {

class AbsorbingWall : public StepEffect {
 public:
  static constexpr int values = 3;

  explicit AbsorbingWall(const StepInput& input) : point_(input.effect.vector("point")) {
    const Vector3d n = input.effect.exact_vector("normal").normalized();
    normal_ = {static_cast<Real>(n.x()), static_cast<Real>(n.y()), static_cast<Real>(n.z())};
  }

  void act(const StepBodies& bodies, const EndedStep&) const override {
    for (std::size_t row = bodies.first; row < bodies.last; ++row) {
      const Vector3<Real> x{bodies.position[0][row], bodies.position[1][row], bodies.position[2][row]};
      if (dot(normal_, x - point_) < 0) bodies.leave(row);
    }
  }

  static EffectDescription description() {
    return {.name = "absorbing_wall",
            .doc =
                "takes away bodies whose centre is behind a plane, n.(x - p) < 0, when a step has ended; what they "
                "carried goes with them",
            .source = "Bird 1994, Molecular Gas Dynamics and the Direct Simulation of Gas Flows",
            .parameters = {{.name = "point",
                            .kind = ParameterKind::vector,
                            .unit = "m",
                            .fallback = Vector3d(0, 0, 0),
                            .doc = "p, on the plane"},
                           {.name = "normal",
                            .kind = ParameterKind::vector,
                            .unit = "1",
                            .fallback = Vector3d(0, 0, 1),
                            .doc = "n, towards the bodies that stay, of any length"}},
            .reads = {"position"},
            .exerts = {"present"},
            .flops = 8,
            .between_steps = true};
  }

 private:
  Vector3<Real> point_, normal_;
};

}  // namespace ballpark::BALLPARK_PRECISION
