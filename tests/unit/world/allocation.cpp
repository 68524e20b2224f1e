// A step, once warm, asks for no heap memory.
#include "tests/catch.h"
#include "tests/integrators.h"
#include "tests/unit/world/allocation_counter.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using allocation_counter::allocations;
using ballpark::Path;
using ballpark::World;

namespace {

constexpr double h = 1.0 / 128;

/// Several blocks, every motion, and events within steps.
Scene busy() {
  Scene scene =
      scene_of({particles("p", 9001), spinning(balls("s", 5003)), bricks("b", 4999), particles("pivoted", 99)},
               {effect("gravity"), effect("pivot", {{"point", Vector3d(0, 0, 9)}}, {"pivoted"}),
                effect("magnus", {{"coefficient", 0.1}}, {"s"}),
                effect("force", {{"force", Vector3d(1, 2, 3)}, {"at", 30.5 * h}, {"until", 60.5 * h}})});
  scene.impulses = {{.at = 40.5 * h, .id = 17, .J = {1, 2, 3}}};
  return scene;
}

std::uint64_t allocations_of_100_steps(const Scene& scene, const Options& options,
                                       const std::vector<UserEffect>& users = {}) {
  World world(scene, options, users);
  world.step(20);
  const std::uint64_t before = allocations();
  for (int i = 0; i < 100; ++i) world.step();
  return allocations() - before;
}

}  // namespace

TEST_CASE("Allocation: the counter counts", "[allocation]") {
  const std::uint64_t before = allocations();
  const std::vector<int> memory(1000);
  allocation_counter::use(memory.data());
  CHECK(allocations() > before);
  const std::uint64_t aligned = allocations();
  void* raw = ::operator new (256, std::align_val_t{64});
  allocation_counter::use(raw);
  ::operator delete (raw, std::align_val_t{64});
  CHECK(allocations() > aligned);
}

TEST_CASE("Allocation: none in 100 steps, on both paths, with one thread and with two threads", "[allocation]") {
  for (const ballpark::IntegratorDescription& integrator : ballpark::integrators()) {
    Scene scene = ballpark::tests::run_by(busy(), integrator.name);
    if (integrator.implicit) {  // which take long
      for (BodyGroup& group : scene.bodies) {
        for (auto* rows : {&group.position, &group.velocity, &group.angular_velocity}) {
          rows->resize(std::min<std::size_t>(rows->size(), group.name == "p" ? 4100 : 20));
        }
      }
    }
    for (const int threads : {1, 2}) {
      for (const Path path : {Path::fused, Path::staged}) {
        if (integrator.implicit && path == Path::staged) continue;  // the same
        CAPTURE(integrator.name, threads, path == Path::staged);
        CHECK(allocations_of_100_steps(scene, {.threads = threads, .path = path}) == 0);
      }
    }
  }
}

TEST_CASE("Allocation: none in a user effect's passes either", "[allocation]") {
  const UserEffect wind = user_effect("wind", [](const ballpark::BodyBlock<double>& block) {
    for (std::size_t i = 0; i < block.count; ++i) block.force[0][i] += 0.1;
  });
  for (const int threads : {1, 2}) CHECK(allocations_of_100_steps(busy(), {.threads = threads}, {wind}) == 0);
  Scene iterated = scene_of({particles("p", 300), bricks("b", 20)});
  iterated.run.integrator = "gauss4";
  for (const int threads : {1, 2}) CHECK(allocations_of_100_steps(iterated, {.threads = threads}, {wind}) == 0);
}

TEST_CASE("Allocation: none in forces between bodies", "[allocation]") {
  const Scene scene =
      scene_of({particles("p", 300)},
               {effect("mutual_gravity", {{"softening", 0.1}}),
                effect("bonds", {{"pairs", std::vector<ballpark::IdPair>{{0, 1}, {1, 299}}}, {"stiffness", 3.0}})});
  for (const int threads : {1, 2}) CHECK(allocations_of_100_steps(scene, {.threads = threads}) == 0);
}

TEST_CASE("Allocation: none in forces that end at a cut-off, while neighbours come and go", "[allocation]") {
  BodyGroup gas = particles("gas", 0);
  gas.position.clear(), gas.velocity.clear();
  gas.generate =
      ballpark::Generate{.kind = "lattice", .count = {8, 8, 8}, .spacing = 1.2, .velocity_spread = {1, 1, 1}};
  Scene scene = scene_of({gas}, {effect("soft_repulsion", {{"strength", 2.0}, {"cutoff", 1.5}})});
  ballpark::Boundary space;
  space.shape = "periodic", space.size = {9.6, 9.6, 9.6};
  scene.boundaries = {space};
  for (const int threads : {1, 2}) {
    World world(scene, {.threads = threads});
    const ballpark::Snapshot start = world.snapshot();
    world.step(100);
    world.restore(start);
    const std::uint64_t before = allocations();
    world.step(100);
    CHECK(allocations() == before);
  }
}

TEST_CASE("Allocation: none in steps whose pairs and contacts stay below earlier peaks", "[allocation]") {
  BodyGroup heap = balls("heap", 0);
  heap.position.clear();
  heap.velocity = {{0, 0, 0}};
  heap.generate = ballpark::Generate{.kind = "lattice",
                                     .count = {20, 20, 12},
                                     .origin = {0.1, 0.1, 0.1},
                                     .spacing = 0.2,
                                     .velocity_spread = {1, 1, 1}};
  Scene scene = scene_of({heap}, {effect("gravity")});
  scene.run.step = 1e-3;
  scene.materials[""] = {0.5, 0.3};
  ballpark::Boundary box;
  box.shape = "box", box.point = {2, 2, 2}, box.size = {4, 4, 4};
  scene.boundaries = {box};
  const std::string kind = GENERATE(as<std::string>(), "impulse", "penalty");
  scene.contact.kind = kind;
  if (kind == "penalty") scene.contact.stiffness = 1e5, scene.run.step = 1e-4;
  for (const int threads : {1, 2}) {
    World world(scene, {.threads = threads});
    const ballpark::Snapshot start = world.snapshot();
    world.step(60);
    world.restore(start);
    const std::uint64_t before = allocations();
    world.step(60);
    const std::uint64_t asked = allocations() - before;
    CAPTURE(kind, threads);
    CHECK(asked == 0);
    CHECK(world.counters().contacts > 1000);
  }
}
