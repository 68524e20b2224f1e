// Langevin's thermostat: friction and noise that hold a temperature, as the exact solution over a step of
//   dv = -g v dt + sqrt(2 g kT / m) dW:  v' = c v + sqrt((1 - c^2) kT / m) xi,  c = exp(-g h),
// xi normal. Behind a step of velocity Verlet: Bussi & Parrinello 2007, Phys. Rev. E 75, 056707.
#pragma once

#include "engine/core/maths.h"
#include "engine/core/random.h"
#include "engine/effects/step_effect.h"

namespace ballpark::BALLPARK_PRECISION {

class Thermostat : public StepEffect {
 public:
  static constexpr int values = 6;

  explicit Thermostat(const StepInput& input)
      : energy_(input.effect.exact("energy")),
        rate_(input.effect.exact("rate")),
        seed_(input.seed),
        stream_(std::uint64_t{1} << 63 | input.ordinal << 48) {}

  void act(const StepBodies& bodies, const EndedStep& step) const override {
    const double left = maths::exp(-rate_ * step.length);
    const double variance = (1 - left * left) * energy_;
    for (std::size_t row = bodies.first; row < bodies.last; ++row) {
      const BodyName name = bodies.name_of(row);
      const double spread = __builtin_sqrt(variance / static_cast<double>(bodies.mass.at<Real>(row)));
      for (std::uint64_t c = 0; c < 3; ++c) {
        const double noise = random::normal({seed_ + name.copy, stream_ | step.number, 3 * name.id + c});
        Real& v = bodies.velocity[c][row];
        v = static_cast<Real>(left) * v + static_cast<Real>(spread * noise);
      }
    }
  }

  static EffectDescription description() {
    return {.name = "thermostat",
            .doc =
                "holds a temperature by friction and noise (Langevin), dv = -g v dt + sqrt(2 g kT / m) dW, solved "
                "exactly for the velocity after each step; spin is left alone",
            .source = "Langevin 1908; Bussi & Parrinello 2007, Phys. Rev. E 75, 056707",
            .parameters = {{.name = "energy",
                            .unit = "J",
                            .fallback = {},
                            .minimum = 0,
                            .doc = "kT, k = 1.380649e-23 J/K; bodies end with m <v^2> = 3 kT"},
                           {.name = "rate", .unit = "1/s", .fallback = {}, .minimum = 0, .doc = "g"}},
            .reads = {},
            .exerts = {"velocity"},
            .flops = 150,
            .between_steps = true};
  }

 private:
  double energy_, rate_;
  std::uint64_t seed_, stream_;
};

}  // namespace ballpark::BALLPARK_PRECISION
