// A source: the bodies of a group enter one after the other, at times k every, in the order of their ids.
#pragma once

#include <limits>

#include "engine/effects/step_effect.h"

namespace ballpark::BALLPARK_PRECISION {

class Emitter : public StepEffect {
 public:
  static constexpr int values = 0;  ///< but for who enters

  explicit Emitter(const StepInput& input)
      : every_(input.effect.exact("every")), at_(input.effect.exact("at")), until_(input.effect.exact("until")) {}

  double entry(std::uint64_t index) const override { return at_ + static_cast<double>(index) * every_; }

  double entries(double time) const override {
    const double open = smaller(time, until_) - at_;
    constexpr double rounding = 1 + 1e-12;
    return open < 0 || every_ == 0 ? 0 : 1 + __builtin_floor(open / every_ * rounding);
  }

  void act(const StepBodies& bodies, const EndedStep& step) const override {
    const double on_the_step = 1e-9 * step.length;  // as near to a step's end as this is on it
    const double end = step.end(), begin = end - step.length, last = smaller(end, until_) + on_the_step;
    if (last < at_ || begin > until_) return;
    for (std::size_t row = bodies.first; row < bodies.last; ++row) {
      const double due = entry(bodies.name_of(row).index);
      if (due > begin + on_the_step && due <= last && due > 0) bodies.enter(row, due < end ? end - due : 0);
    }
  }

  static EffectDescription description() {
    return {
        .name = "emitter",
        .doc =
            "a source: body k of a group enters at the time at + k every, with the position, velocity and spin that "
            "the scene starts it with, by free flight to the end of that step; before that it is not there. A group "
            "has room for as many bodies as it lists, and an id is never used again",
        .source = "Poeschel & Schwager 2005, Computational Granular Dynamics (feeding)",
        .parameters = {{.name = "every",
                        .unit = "s",
                        .fallback = {},
                        .minimum = 0,
                        .doc = "from one body to the next; 0: all at once"},
                       {.name = "at", .unit = "s", .fallback = 0.0, .doc = "when the first one enters"},
                       {.name = "until",
                        .unit = "s",
                        .fallback = std::numeric_limits<double>::infinity(),
                        .doc = "none enters later"}},
        .reads = {},
        .exerts = {"present", "position", "velocity"},
        .flops = 6,
        .between_steps = true};
  }

 private:
  static double smaller(double a, double b) { return a < b ? a : b; }
  double every_, at_, until_;
};

}  // namespace ballpark::BALLPARK_PRECISION
