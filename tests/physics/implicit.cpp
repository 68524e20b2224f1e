// Implicit integrators on what is stiff: bounded and right at steps far beyond every explicit limit.
#include "tests/catch.h"
#include "tests/integrators.h"
#include "tests/physics/measures.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

Scene overdamped(const std::string& integrator, double step) {
  return scene(particle({1, 0, 0}), {spring(1000, 1001)}, 1, step, integrator);
}

/// X02: z = 316.
Scene stiff_spring(const std::string& integrator) {
  BodyGroup group = particle({1, 0, 0});
  group.mass = {1e-3};
  return scene(std::move(group), {spring(1e8)}, 1, 1e-3, integrator);
}

/// A chain that hangs from its first body, which a spring holds. Slack by as much as its weight will stretch it.
Scene chain(std::size_t links, double stiffness, double damping, double step, const std::string& integrator) {
  BodyGroup group = particle({0, 0, 0});
  group.mass = {0.1};
  group.position.clear();
  group.velocity.clear();
  std::vector<IdPair> pairs;
  for (std::size_t i = 0; i <= links; ++i) {
    group.position.push_back({0.1 * static_cast<double>(i), 0, 0});
    if (i > 0) pairs.push_back({i - 1, i});
  }
  const Effect bonds{"bonds", {}, {{"pairs", pairs}, {"stiffness", stiffness}, {"damping", damping}}};
  Scene made = scene(std::move(group), {gravity(), bonds}, 0.5, step, integrator);
  BodyGroup anchor = particle({-0.1, 0, 0});
  anchor.name = "anchor";
  anchor.mass = {1e6};
  made.bodies.push_back(anchor);
  made.effects[0].groups = {"particle"};
  auto& all = std::get<std::vector<IdPair>>(made.effects[1].parameters["pairs"]);
  all.push_back({links + 1, 0});
  return made;
}

double error_after(const Scene& made, const std::vector<Vector3d>& exact) {
  World world(made);
  world.step(static_cast<std::uint64_t>(std::llround(made.run.duration / made.run.step)));
  CHECK(world.status().sentence == "ok");
  double most = 0;
  for (std::size_t id = 0; id < exact.size(); ++id) {
    most = std::max(most, (world.body(id).position - exact[id]).norm());
  }
  return most;
}

}  // namespace

TEST_CASE("P-O2: implicit rows stay bounded at 0.05 s, and backward Euler and Gauss follow the solution", "[physics]") {
  constexpr double exact = 0.368247688860302624;
  const auto error = [&](const std::string& integrator, double step) {
    World world(overdamped(integrator, step));
    CHECK(world.status().code == Status::Code::ok);
    for (int n = 1; n * step < 1 + step / 2; ++n) {
      world.step();
      REQUIRE(std::abs(world.body(0).position.x()) <= 1);
    }
    CHECK(world.counters().newton_residual < 1e-12);
    return std::abs(world.body(0).position.x() - exact);
  };
  // Of y' = -y: 1.05^-20 = 0.37689 in place of exp(-1).
  CHECK(std::abs(error("backward_euler", 0.05) - 0.0091) < 2e-4);
  CHECK(error("backward_euler", 0.005) < 1e-3);
  // What is stiff swings on: Gauss's rows multiply it by nearly -1 or 1, and it was 1e-3 of the start.
  CHECK(error("implicit_midpoint", 0.05) < 2e-3);
  CHECK(error("gauss4", 0.05) < 2e-3);
  CHECK(error("gauss4", 0.0025) < 1e-6);
}

TEST_CASE("X02: a spring of z = 316 keeps its energy under Gauss's rows and loses it under backward Euler",
          "[physics]") {
  for (const IntegratorDescription& row : integrators()) {
    INFO(row.name);
    World world(stiff_spring(row.name));
    CHECK((world.status().code == Status::Code::ok) == row.implicit);
    if (!row.implicit) continue;
    const double start = world.totals().energy();
    world.step(10000);
    CHECK(world.status().code == Status::Code::ok);
    const double end = world.totals().energy() / start;
    CHECK((row.symplectic ? std::abs(end - 1) < 1e-10 : end < 1e-100));
  }
}

TEST_CASE("an implicit row takes two iterations for a step of a linear scene", "[physics]") {
  World world(stiff_spring("implicit_midpoint"));
  world.step(100);
  CHECK(world.counters().newton_iterations == 200);
  CHECK(world.counters().force_evaluations == 200);
  CHECK(world.counters().newton_residual < 1e-13);
}

TEST_CASE("a chain of stiff bonds at a hundred times the step that explicit rows take", "[physics]") {
  const double stiffness = 1e7, damping = 30;
  const auto limit = [&](const char* integrator) {
    for (const StepLimitReport& row : World(chain(10, stiffness, damping, 1e-7, integrator)).explain().step_limits) {
      if (row.of == "bonds") return row.largest;
    }
    return 0.0;
  };
  CHECK(limit("rk4") > 0);
  const double step = 0.5 / std::floor(0.5 / (100 * limit("rk4")));
  CHECK(World(chain(10, stiffness, damping, step, "rk4")).status().code == Status::Code::stability);
  // The same chain of bonds so much softer that rk4 can follow them: as rods, they move alike.
  World reference(chain(10, stiffness, damping, limit("rk4") / 2, "rk4"));
  reference.advance_to(0.5);
  std::vector<Vector3d> exact;
  for (std::size_t id = 0; id <= 10; ++id) exact.push_back(reference.body(id).position);
  CHECK(error_after(chain(10, stiffness, damping, step, "backward_euler"), exact) < 0.2);
  const double coarse = error_after(chain(10, stiffness, damping, step, "implicit_midpoint"), exact);
  const double fine = error_after(chain(10, stiffness, damping, step / 4, "implicit_midpoint"), exact);
  INFO("errors " << coarse << ", " << fine);
  CHECK(coarse < 0.03);
  CHECK(fine < coarse / 4);
}

TEST_CASE("bonds and attraction keep momentum under implicit rows, and energy under Gauss's", "[physics]") {
  BodyGroup group = particle({0, 0, 0});
  group.position = {{0, 0, 0}, {1, 0, 0.1}, {0.2, 1, 0}, {4, 4, 4}};
  group.velocity = {{0.1, 0, 0}, {0, 0.2, 0}, {0, -0.1, 0.3}, {0, 0, 0}};
  const Effect bonds{"bonds", {}, {{"pairs", std::vector<IdPair>{{0, 1}, {1, 2}}}, {"stiffness", 50.0}}};
  const Effect attraction{"mutual_gravity", {}, {{"strength", 1.0}, {"softening", 0.1}}};
  for (const char* name : {"backward_euler", "implicit_midpoint", "gauss4"}) {
    INFO(name);
    World world(scene(group, {bonds, attraction}, 10, 0.01, name));
    const Totals start = world.totals();
    world.step(1000);
    const Totals end = world.totals();
    CHECK((end.momentum - start.momentum).norm() < 1e-12);
    CHECK(world.status().sentence == "ok");
    const double drift = std::abs(end.energy() / start.energy() - 1);
    INFO("energy drift " << drift);
    if (std::string(name) != "backward_euler") CHECK(drift < (std::string(name) == "gauss4" ? 1e-3 : 1e-2));
    // Quadratic invariants are kept. (Hairer, Lubich & Wanner, theorem IV.2.1)
    if (std::string(name) != "backward_euler") {
      CHECK((end.angular_momentum - start.angular_momentum).norm() < 1e-11);
    }
  }
}

TEST_CASE("bonds between pivoted bodies: implicit rows agree with rk4", "[physics]") {
  BodyGroup group = particle({0, 0, 0});
  group.position = {{0, 0, -1}, {1, 0, -1}};
  group.velocity = {{0.4, 0.3, 0}, {0, 0, 0}};
  const Effect pivots{"pivot", {}, {{"point", std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}}}}};
  const Effect bonds{"bonds", {}, {{"pairs", std::vector<IdPair>{{0, 1}}}, {"stiffness", 20.0}, {"damping", 0.5}}};
  const auto end = [&](const char* name, double step) {
    World world(scene(group, {gravity(), pivots, bonds}, 2, step, name));
    world.step(static_cast<std::uint64_t>(std::llround(2 / step)));
    CHECK(world.status().sentence == "ok");
    return world.body(1).position;
  };
  const Vector3d exact = end("rk4", 1.0 / 4096);
  CHECK((end("gauss4", 1.0 / 64) - exact).norm() < 1e-5);
  const double coarse = (end("implicit_midpoint", 1.0 / 64) - exact).norm();
  const double fine = (end("implicit_midpoint", 1.0 / 128) - exact).norm();
  CHECK(std::abs(std::log2(coarse / fine) - 2) < 0.15);
}
