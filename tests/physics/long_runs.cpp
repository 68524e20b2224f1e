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

/// How fast the invariant's drift grows with the number of steps, as a power of it, from 1e4 to n steps: of 64
/// oscillators, root mean square.
double growth_exponent(bool compensated, std::uint64_t n) {
  constexpr std::size_t count = 64;
  Scene made = verlet_oscillator();
  made.run.compensated = compensated;
  BodyGroup& group = made.bodies[0];
  group.position.clear();
  group.velocity.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const double phase = 0.1 * static_cast<double>(i), size = 1 + 0.01 * static_cast<double>(i);
    group.position.emplace_back(size * std::cos(phase), 0, 0);
    group.velocity.emplace_back(size * std::sin(phase), 0, 0);
  }
  World world(made);
  const auto invariant = [&](std::size_t i) {
    const BodyState now = world.body(i);
    const long double v = now.velocity.x(), x = now.position.x(), z = 0.1;
    return v * v + x * x * (1 - z * z / 4);
  };
  std::vector<long double> start;
  for (std::size_t i = 0; i < count; ++i) start.push_back(invariant(i));
  const auto drift = [&] {
    long double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += std::pow(invariant(i) / start[i] - 1, 2.0L);
    return std::sqrt(sum / count);
  };
  world.step(10'000);
  const long double early = drift();
  world.step(n - 10'000);
  return static_cast<double>(std::log(drift() / early) / std::log(static_cast<long double>(n) / 10'000));
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

TEST_CASE("rounding of compensated sums walks at random: drift grows as the root of the steps", "[physics]") {
  const double exponent = growth_exponent(true, 1'000'000);
  INFO(exponent);
  CHECK(exponent > 0.3);
  CHECK(exponent <= 0.65);
}

TEST_CASE("rounding of compensated sums walks at random for 1e8 steps", "[physics][long]") {
  const double exponent = growth_exponent(true, 100'000'000);
  INFO(exponent);
  CHECK(exponent <= 0.65);
}

TEST_CASE("velocity Verlet keeps its invariant to 1e-10 over 1e8 steps", "[physics][long]") {
  const double drift = invariant_drift(verlet_oscillator(), 100'000'000, 1000);
  INFO(drift);
  CHECK(drift < 1e-10);
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
