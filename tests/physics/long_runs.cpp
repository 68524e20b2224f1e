// What many steps must not change.
#include "tests/catch.h"
#include "tests/physics/measures.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

/// Largest relative drift of v^2 + x^2 (1 - z^2/4), looked at `looks` times over n steps.
double invariant_drift(Scene made, std::uint64_t n, std::uint64_t looks) {
  const double z = made.run.step;
  World world(made);
  double drift = 0;
  const double start = 1 - z * z / 4;
  for (std::uint64_t i = 0; i < looks; ++i) {
    world.step(n / looks);
    const BodyState now = world.body(0);
    const double v = now.velocity.x(), x = now.position.x();
    drift = std::max(drift, std::abs((v * v + x * x * (1 - z * z / 4)) / start - 1));
  }
  return drift;
}

Scene verlet_oscillator() {
  return scene(particle({1, 0, 0}), {spring(1)}, 1e4, 0.1, "velocity_verlet");
}

}  // namespace

TEST_CASE("velocity Verlet keeps its invariant over 1e5 steps", "[physics]") {
  const double drift = invariant_drift(verlet_oscillator(), 100'000, 1000);
  INFO(drift);
  CHECK(drift < 1e-12);
}

TEST_CASE("compensated sums drift less", "[physics]") {
  Scene compensated = verlet_oscillator();
  compensated.run.compensated = true;
  const double plain = invariant_drift(verlet_oscillator(), 100'000, 1000);
  const double drift = invariant_drift(compensated, 100'000, 1000);
  INFO(plain << ", compensated " << drift);
  CHECK(drift < plain / 4);
}

TEST_CASE("rounding walks at random: the invariant's drift grows slower than the steps", "[physics][long]") {
  const double early = invariant_drift(verlet_oscillator(), 10'000, 100);
  const double late = invariant_drift(verlet_oscillator(), 100'000'000, 1000);
  INFO(early << ", " << late);
  CHECK(late < 1e-10);
  CHECK(std::log10(late / early) / 4 <= 0.65);
}

TEST_CASE("symplectic rows keep the energy of an orbit bounded, rk4 lets it drift", "[physics]") {
  const auto drift = [](const std::string& integrator, std::uint64_t steps) {
    World world(orbit(0.3, 1e4, 0.02, integrator));
    const double start = world.totals().energy();
    double largest = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
      world.step(steps / 100);
      largest = std::max(largest, std::abs(world.totals().energy() / start - 1));
    }
    return largest;
  };
  for (const char* name : {"velocity_verlet", "semi_implicit_euler"}) {
    INFO(name);
    CHECK(drift(name, 200'000) < 1.5 * drift(name, 20'000));
  }
  CHECK(drift("rk4", 200'000) > 5 * drift("rk4", 20'000));
}

TEST_CASE("time is n h, never a running sum", "[physics]") {
  for (const double h : {0.1, 1e-3, 1.0 / 3}) {
    World world(scene(particle(Vector3d::Zero()), {}, 1, h));
    for (int i = 0; i < 1000; ++i) world.step(997);
    CHECK(world.steps() == 997'000);
    CHECK(world.time() == 997'000 * h);
  }
}

TEST_CASE("advance_to takes whole steps and keeps the remainder", "[physics]") {
  World world(scene(particle(Vector3d::Zero(), {1, 0, 0}), {}, 1, 0.1));
  for (int frame = 1; frame <= 1000; ++frame) world.advance_to(frame / 60.0);
  CHECK(world.steps() == 166);
  world.advance_to(50 * 0.1 * 4);  // on a step
  CHECK(world.steps() == 200);
  world.advance_to(3);
  CHECK(world.steps() == 200);
}
