// Who looks at a run between its steps changes no bit of it.
#include "ballpark/watch.h"
#include "tests/catch.h"
#include "tests/determinism/scenarios.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using namespace scenarios;
using ballpark::Snapshot;
using ballpark::Watch;
using ballpark::World;

namespace {

/// Some steps, unequal parts of which are looked at.
double end_of(const Scene& scene, std::uint64_t steps) {
  return scene.run.step > 0 ? static_cast<double>(steps) * scene.run.step : scene.run.duration;
}

void check_looks(const Scene& scene, const Options& options, std::uint64_t steps) {
  CAPTURE(scene.name, scene.run.integrator, scene.run.tolerance, scene.run.compensated, options.threads);
  const double end = end_of(scene, steps);
  World alone(scene, options), seen(scene, options);
  alone.approach(end, end);
  std::size_t looks = 0;
  constexpr int count = 7;
  for (int k = 1; k <= count; ++k) {
    const double t = end * (k / (count + 0.37));
    REQUIRE(seen.approach(t, end));
    CHECK(seen.time() <= t);
    const double now = seen.time();
    const std::uint64_t hash = seen.state_hash();
    seen.look_ahead(t, [&] {
      looks += std::abs(seen.time() - t) <= 1e-9 * end;
      CHECK((t == now || seen.state_hash() != hash));
    });
    CHECK(seen.time() == now);
    CHECK(seen.state_hash() == hash);
  }
  REQUIRE(seen.approach(end, end));
  CHECK(looks == count);
  CHECK(seen.time() == alone.time());
  CHECK(seen.state_hash() == alone.state_hash());
  CHECK(seen.steps() == alone.steps());
  CHECK(seen.counters().rejected_steps == alone.counters().rejected_steps);
  CHECK(seen.counters().force_evaluations == alone.counters().force_evaluations);
  CHECK(seen.counters().contacts == alone.counters().contacts);
  CHECK(seen.status().sentence == alone.status().sentence);
}

/// The first part of a scene, with steps as a tolerance allows; nothing if it does not take that.
std::vector<Scene> with_tolerance(Scene scene, const std::string& integrator, double duration) {
  scene.run.integrator = integrator;
  scene.run.duration = duration;
  scene.run.step = 0;
  scene.run.tolerance = 1e-4;
  return ballpark::check(scene).empty() ? std::vector{scene} : std::vector<Scene>{};
}

}  // namespace

TEST_CASE("Looks: change no bit of a run of whole steps, in every scenario", "[bits]") {
  for (const std::string& file : files()) {
    const Scene scene = small(file);
    if (scene.run.step > 0) check_looks(scene, {.threads = 2}, 12);
  }
}

TEST_CASE("Looks: change no bit under any integrator, nor by impulses and windows", "[bits]") {
  Scene scene = scene_of({particles("p", 3), spinning(balls("s", 2)), bricks("b", 5)}, {effect("gravity")});
  const double h = scene.run.step;
  scene.effects.push_back(effect("force", {{"force", Vector3d(1, 2, 3)}, {"at", 3.5 * h}, {"until", 20.25 * h}}));
  for (const double at : {0.0, 2.0, 5.3, 10.0, 17.0}) {
    scene.impulses.push_back({.at = at * h, .id = 7, .J = {1, 0.1, 0.2}, .offset = {0, 0.1, 0}});
  }
  for (const ballpark::IntegratorDescription& row : ballpark::integrators()) {
    for (const bool compensated : {false, true}) {
      Scene made = ballpark::tests::run_by(scene, row.name);
      made.run.compensated = compensated;
      check_looks(made, {.threads = 1}, 20);
      check_looks(made, {.threads = 2, .precision = Precision::single_, .path = Path::staged}, 20);
      if (!row.adaptive) continue;
      made.run.tolerance = 1e-6;
      made.run.duration = 20 * h;
      made.run.step = 0;
      check_looks(made, {.threads = 1}, 0);
      check_looks(made, {.threads = 3, .path = Path::staged}, 0);
    }
  }
}

TEST_CASE("Looks: change no step that a tolerance allows, in every scenario", "[bits]") {
  for (const std::string& file : files()) {
    const Scene scene = small(file);
    const double part = (scene.run.step > 0 ? 12 * scene.run.step : scene.run.duration / 20);
    for (const char* integrator : {"bogacki_shampine3", "dormand_prince8"}) {
      for (const Scene& made : with_tolerance(scene, integrator, part)) check_looks(made, {.threads = 2}, 0);
    }
  }
}

TEST_CASE("Looks: a watched run keeps its bits", "[bits]") {
  for (const double tolerance : {0.0, 1e-7}) {
    Scene scene =
        scene_of({particles("p", 2)}, {effect("spring", {{"anchor", Vector3d(0, 0, 0)}, {"stiffness", 4.0}})});
    scene.run.integrator = "dormand_prince5";
    scene.run.duration = 6;
    scene.run.step = tolerance > 0 ? 0 : 0.01;
    scene.run.tolerance = tolerance;
    World alone(scene), watched(scene);
    alone.approach(6, 6);
    std::size_t seen = 0;
    const std::vector<Watch> watches{{[&] { return watched.body(1).position.x(); }, [&](double, bool) { ++seen; }}};
    ballpark::advance_watching(watched, 6, watches);
    CHECK(seen >= 3);
    CHECK(watched.state_hash() == alone.state_hash());
    CHECK(watched.steps() == alone.steps());
    CHECK(watched.time() == alone.time());
  }
}
