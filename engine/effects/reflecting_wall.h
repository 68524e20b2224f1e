// A plane that mirrors bodies' centres: of those behind it, the place and the velocity after a step.
#pragma once

#include "engine/effects/step_effect.h"

namespace ballpark::BALLPARK_PRECISION {

class ReflectingWall : public StepEffect {
 public:
  static constexpr int values = 12;

  explicit ReflectingWall(const StepInput& input) : point_(input.effect.vector("point")) {
    const Vector3d n = input.effect.exact_vector("normal").normalized();
    normal_ = {static_cast<Real>(n.x()), static_cast<Real>(n.y()), static_cast<Real>(n.z())};
  }

  void act(const StepBodies& bodies, const EndedStep&) const override {
    for (std::size_t row = bodies.first; row < bodies.last; ++row) {
      const auto at = [row](Real* const* columns) {
        return Vector3<Real>{columns[0][row], columns[1][row], columns[2][row]};
      };
      const Vector3<Real> x = at(bodies.position), v = at(bodies.velocity);
      const Real height = dot(normal_, x - point_), speed = dot(normal_, v);
      if (!(height < 0)) continue;
      put(bodies.position, row, x - (2 * height) * normal_);
      if (speed < 0) put(bodies.velocity, row, v - (2 * speed) * normal_);
    }
  }

  static EffectDescription description() {
    return {.name = "reflecting_wall",
            .doc =
                "mirrors bodies whose centre a step took behind a plane: x - 2 (n.(x - p)) n, v - 2 (n.v) n; exact for "
                "free flight, of first order where forces act; bodies do not touch it ([contact] and [[boundaries]] "
                "have walls that they touch)",
            .source = "Allen & Tildesley, Computer Simulation of Liquids",
            .parameters = {{.name = "point",
                            .kind = ParameterKind::vector,
                            .unit = "m",
                            .fallback = Vector3d(0, 0, 0),
                            .doc = "p, on the plane"},
                           {.name = "normal",
                            .kind = ParameterKind::vector,
                            .unit = "1",
                            .fallback = Vector3d(0, 0, 1),
                            .doc = "n, towards the bodies, of any length"}},
            .reads = {},
            .exerts = {"position", "velocity"},
            .flops = 23,
            .between_steps = true};
  }

 private:
  static void put(Real* const* columns, std::size_t row, const Vector3<Real>& a) {
    columns[0][row] = a.x, columns[1][row] = a.y, columns[2][row] = a.z;
  }
  Vector3<Real> point_, normal_;
};

}  // namespace ballpark::BALLPARK_PRECISION
