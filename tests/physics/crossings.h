// The time at which a quantity falls through zero: by whole steps to the last one before it, then by the length of one
// shorter step.
#pragma once

#include <functional>

#include "tests/catch.h"
#include "tests/physics/scenes.h"

namespace ballpark::tests {

struct Crossing {
  double time = 0;
  BodyState state;
};

inline World after_one_step(const Scene& scene, const BodyState& state, double step) {
  Scene shorter = scene;
  shorter.run.duration = shorter.run.step = step;
  World world(shorter);
  world.set(0, state);
  world.step();
  return world;
}

/// Of the scene's first body, after the time `from`; fails the test if nothing crosses within the scene's duration.
inline Crossing first_fall_through_zero(const Scene& scene, const std::function<double(const World&)>& quantity,
                                        double from = 0) {
  World world(scene);
  world.advance_to(from);
  BodyState before = world.body(0);
  double value = quantity(world), last = value;
  do {
    before = world.body(0);
    last = value;
    world.step();
    value = quantity(world);
    REQUIRE(world.time() <= scene.run.duration);
  } while (!(last > 0 && value <= 0));
  const double start = world.time() - scene.run.step;
  double low = 0, high = scene.run.step;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (quantity(after_one_step(scene, before, middle)) > 0 ? low : high) = middle;
  }
  return {start + high, after_one_step(scene, before, high).body(0)};
}

}  // namespace ballpark::tests
