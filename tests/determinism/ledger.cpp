// Who keeps the energy ledger changes no bit of the run.
#include "tests/catch.h"
#include "tests/determinism/scenarios.h"
#include "tests/integrators.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using namespace scenarios;
using ballpark::World;

namespace {

void check_ledger(const Scene& scene, const Options& options, double end) {
  CAPTURE(scene.name, scene.run.integrator, scene.run.tolerance, options.threads);
  World alone(scene, options), booked(scene, options);
  booked.keep_ledger(true);
  alone.advance_to(end);
  booked.advance_to(end);
  CHECK(booked.time() == alone.time());
  CHECK(booked.state_hash() == alone.state_hash());
  CHECK(booked.steps() == alone.steps());
  CHECK(booked.counters().rejected_steps == alone.counters().rejected_steps);
  CHECK(booked.counters().force_evaluations == alone.counters().force_evaluations);
  CHECK(booked.counters().contacts == alone.counters().contacts);
  CHECK(booked.status().sentence == alone.status().sentence);
}

}  // namespace

TEST_CASE("Ledger: changes no bit of any scenario", "[bits]") {
  for (const std::string& file : files()) {
    const Scene scene = small(file);
    const double end = scene.run.step > 0 ? 6 * scene.run.step : scene.run.duration / 100;
    check_ledger(scene, {.threads = 2}, end);
  }
}

TEST_CASE("Ledger: changes no bit under any integrator, and is the same for any number of threads", "[bits]") {
  Scene scene = scene_of({particles("p", 3), spinning(balls("s", 2)), bricks("b", 5)}, {effect("gravity")});
  const double h = scene.run.step;
  scene.effects.push_back(effect("force", {{"force", Vector3d(1, 2, 3)}, {"at", 1.5 * h}, {"until", 4.25 * h}}));
  scene.impulses.push_back({.at = 2.3 * h, .id = 7, .J = {1, 0.1, 0.2}, .offset = {0, 0.1, 0}});
  for (const ballpark::IntegratorDescription& row : ballpark::integrators()) {
    Scene made = ballpark::tests::run_by(scene, row.name);
    check_ledger(made, {.threads = 1}, 6 * h);
    check_ledger(made, {.threads = 2, .path = Path::staged}, 6 * h);
    if (!row.adaptive) continue;
    made.run.tolerance = 1e-6;
    made.run.duration = 6 * h;
    made.run.step = 0;
    check_ledger(made, {.threads = 1}, 6 * h);
  }
  Scene many = scene_of({particles("p", 20000)}, {effect("gravity"), effect("linear_drag", {{"coefficient", 0.1}})});
  double work[2] = {};
  for (const int threads : {1, 3}) {
    World world(many, {.threads = threads});
    world.keep_ledger(true);
    world.step(2);
    work[threads > 1] = world.ledger().lines[1].work;
  }
  CHECK(work[0] == work[1]);
  CHECK(work[0] < 0);
}
