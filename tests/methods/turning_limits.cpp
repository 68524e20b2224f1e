// Forces that turn the velocity: the largest stable step, and what is reported beyond it.
#include "tests/catch.h"
#include "tests/methods/rows.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

Scene charge(const std::string& integrator, double step, double duration) {
  return scene(particle(Vector3d::Zero(), {1, 0, 0}), {magnetic_field(1, {0, 0, 1})}, duration, step, integrator);
}

/// Every row with a limit that takes forces which read velocity.
std::vector<IntegratorDescription> takers() {
  auto rows = integrators_for(charge("rk4", 1, 1));
  std::erase_if(rows, [](const IntegratorDescription& row) { return row.implicit; });
  return rows;
}

/// As explain tells it.
double limit_of(Scene made, const std::string& integrator) {
  made.run.integrator = integrator;
  const auto limits = World(made).explain().step_limits;
  REQUIRE(limits.size() == 1);
  return limits[0].largest;
}

/// Where |R(iz)| leaves 1 as a high power of z, rounding decides.
double tolerance_of(const IntegratorDescription& row) {
  return row.order == 10 ? 0.02 : 1e-6;
}

double speed(const World& world) {
  return world.body(0).velocity.norm();
}

}  // namespace

TEST_CASE("a charge is stable up to the limit on the imaginary axis, and what is beyond is reported", "[methods]") {
  for (const IntegratorDescription& row : takers()) {
    INFO(row.name);
    if (row.family == "splitting") continue;  // below
    CHECK(std::abs(limit_of(charge("rk4", 0.01, 1), row.name) - row.imaginary_limit) < tolerance_of(row));
    if (row.imaginary_limit == 0) continue;
    const double margin = row.start_steps > 0 || row.order == 10 ? 0.02 : 0.001;
    for (const double fraction : {1 - margin, 1 + margin}) {
      World world(charge(row.name, fraction * row.imaginary_limit, 1e5));
      CHECK((world.status().code == Status::Code::ok) == (fraction < 1));
      world.step(10000);
      CHECK((speed(world) < 1) == (fraction < 1));
    }
  }
  CHECK(std::abs(limit_of(charge("rk4", 0.01, 1), "rk4") - 2 * std::sqrt(2.0)) < 1e-6);
}

TEST_CASE("a charge that gains speed at every step is reported when it gains a tenth", "[methods]") {
  // |R|^2 = 1 + z^2 for Euler's method and for a kick by the force at the start, 1 + z^4 / 4 at second order.
  for (const std::string name : {"euler", "semi_implicit_euler", "midpoint", "taylor2", "velocity_verlet"}) {
    INFO(name);
    const bool first = name == "euler" || name == "semi_implicit_euler";
    const double z = first ? 0.01 : 0.1, gain = first ? z * z : z * z * z * z / 4;
    CHECK(limit_of(charge("rk4", z, 1), name) == 0);
    for (const double wanted : {1.05, 1.15}) {
      const double steps = std::ceil(2 * std::log(wanted) / std::log1p(gain));
      World world(charge(name, z, steps * z));
      CHECK((world.status().code == Status::Code::ok) == (wanted < 1.1));
      world.step(static_cast<std::uint64_t>(steps));
      CHECK(std::abs(speed(world) / std::pow(1 + gain, steps / 2) - 1) < 1e-9);
      if (wanted < 1.1) continue;
      CHECK(world.status().sentence.find("no step is stable for " + name + " on group particle") != std::string::npos);
    }
  }
}

TEST_CASE("the limit of a rotating frame is that of its bodies' own frequencies", "[methods]") {
  const double rate = 3, w0 = 4;
  const auto limit = [&](const IntegratorDescription& row, std::vector<Effect> effects) {
    BodyGroup group = particle({1, 0, 0});
    group.position = {{1, 0, 0}, {2, 0, 0}};
    group.mass = {2, 5};  // of the lightest: springs; of all: frames
    return limit_of(scene(group, std::move(effects), 1, 1e-3), row.name);
  };
  const Effect whole = rotating_frame({0, 0, rate}, "on"), coriolis = rotating_frame({0, 0, rate}, "off");
  const Effect held = spring(2 * w0 * w0);
  for (const IntegratorDescription& row : takers()) {
    if (row.family == "splitting" || row.imaginary_limit == 0) continue;
    INFO(row.name);
    const double z = row.imaginary_limit, tolerance = tolerance_of(row);
    CHECK(std::abs(limit(row, {coriolis}) * 2 * rate - z) < tolerance);
    // Straight lines, as seen from the frame: a double frequency, whose roots rounding parts by its own square root.
    if (row.start_steps == 0) CHECK(std::abs(limit(row, {whole}) * rate - z) < 1e-5);
    CHECK(std::abs(limit(row, {whole, held}) * (w0 + rate) - z) < tolerance);
    CHECK(std::abs(limit(row, {coriolis, held}) * (rate + std::hypot(rate, w0)) - z) < tolerance);
  }
}

TEST_CASE("what is flung out by itself, against drag, is not the method's doing", "[methods]") {
  for (const IntegratorDescription& row : takers()) {
    INFO(row.name);
    Scene flung = scene(particle({1, 0, 0}), {rotating_frame({0, 0, 1}, "on"), effect("linear_drag", 1)}, 10, 0.01);
    flung.run.integrator = row.name;
    if (!accepts(flung, row.name)) continue;  // drag
    const World world(flung);
    CHECK(world.status().sentence == "ok");
  }
}
