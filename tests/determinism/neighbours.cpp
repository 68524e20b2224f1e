// When neighbours are looked for again never reaches the bits: whatever was done between, and on any number of threads.
#include "tests/catch.h"
#include "tests/determinism/body_bits.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::Precision;
using ballpark::World;

namespace {

/// A fluid whose atoms use up the skin of their lists every few steps, in two groups, some of them beside the others.
Scene fluid(const std::string& integrator) {
  std::vector<BodyGroup> groups;
  for (const char* name : {"one", "other"}) {
    BodyGroup group{.name = name, .mass = {1}};
    group.generate = ballpark::Generate{.kind = "lattice",
                                        .count = {6, 6, 3},
                                        .origin = {0, 0, groups.empty() ? 0.0 : 3.6},
                                        .spacing = 1.2,
                                        .velocity_spread = {3, 3, 3}};
    groups.push_back(group);
  }
  Scene scene = scene_of(groups, {effect("lennard_jones", {{"epsilon", 1.0}, {"sigma", 1.0}, {"cutoff", 2.5}}),
                                  effect("soft_repulsion", {{"strength", 5.0}, {"cutoff", 1.5}}, {"other"})});
  ballpark::Boundary space;
  space.shape = "periodic", space.size = {7.2, 7.2, 7.2};
  scene.boundaries = {space};
  scene.run.integrator = integrator;
  scene.run.step = 0.004;
  return scene;
}

constexpr std::uint64_t steps = 120;

}  // namespace

TEST_CASE("Neighbours: the same bits on one to four threads, and in copies", "[bits]") {
  for (const Precision precision : {Precision::double_, Precision::single_}) {
    World one(fluid("velocity_verlet"), {.threads = 1, .precision = precision});
    one.step(steps);
    for (const int threads : {2, 3, 4}) {
      World many(fluid("velocity_verlet"), {.threads = threads, .precision = precision});
      many.step(steps);
      CHECK(many.state_hash() == one.state_hash());
    }
    Scene cold = fluid("velocity_verlet");
    for (BodyGroup& group : cold.bodies) group.generate->velocity_spread = {0, 0, 0};  // no seeds
    World solo(cold, {.precision = precision}), copies(cold, {.threads = 2, .precision = precision, .copies = 19});
    solo.step(steps);
    copies.step(steps);
    for (const std::size_t copy : {0, 7, 18}) {
      CHECK((body_bits::of(copies, copy * 216, 216) == body_bits::of(solo, 0, 216)));
    }
  }
}

TEST_CASE("Neighbours: looks ahead, profiles, energies and restored states change no bit", "[bits]") {
  for (const std::string integrator : {"velocity_verlet", "rk4", "ab4"}) {
    World plain(fluid(integrator)), busy(fluid(integrator));
    plain.step(steps);
    ballpark::Snapshot middle;
    for (std::uint64_t i = 0; i < steps; ++i) {
      if (i % 7 == 0) busy.look_ahead(busy.time() + 0.1, [] {});
      if (i % 11 == 0) busy.profile(i % 2 == 0);
      if (i % 5 == 0) busy.totals();
      if (i == steps / 2) middle = busy.snapshot();
      busy.step();
    }
    CAPTURE(integrator);
    CHECK(busy.state_hash() == plain.state_hash());
    busy.restore(middle);
    busy.step(steps - steps / 2);
    CHECK(busy.state_hash() == plain.state_hash());
    World fresh(fluid(integrator));
    fresh.restore(middle);
    fresh.step(steps - steps / 2);
    CHECK(fresh.state_hash() == plain.state_hash());
  }
}

TEST_CASE("Neighbours: steps that are taken back leave nothing behind", "[bits]") {
  Scene scene = fluid("dormand_prince5");
  scene.run.step = 0;
  scene.run.tolerance = 1e-6;
  World one(scene, {.threads = 1});
  one.advance_to(0.3);
  CHECK(one.counters().rejected_steps > 0);
  const ballpark::Snapshot there = one.snapshot();
  one.advance_to(0.5);
  World other(scene, {.threads = 3});
  other.restore(there);
  other.advance_to(0.5);
  CHECK(other.state_hash() == one.state_hash());
}
