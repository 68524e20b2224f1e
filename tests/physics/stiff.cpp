// P-O2, x'' + 1001 x' + 1000 x = 0: explicit methods have a largest step, and the world says when it is exceeded.
#include "tests/catch.h"
#include "tests/integrators.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

Scene stiff(const std::string& integrator, double step) {
  return scene(particle({1, 0, 0}), {spring(1000, 1001)}, 3, step, integrator);
}

}  // namespace

TEST_CASE("P-O2: a step beyond the limit is reported, and blows up", "[physics]") {
  const std::pair<std::string, double> limits[] = {
      {"euler", 2e-3}, {"midpoint", 2e-3}, {"heun", 2e-3}, {"taylor2", 2e-3}, {"rk4", 2.785293563405282e-3}};
  for (const auto& [name, limit] : limits) {
    INFO(name);
    World inside(stiff(name, 0.9999 * limit)), outside(stiff(name, 1.0001 * limit)), far(stiff(name, 1.2 * limit));
    CHECK(inside.status().code == Status::Code::ok);
    CHECK(outside.status().code == Status::Code::stability);
    CHECK(far.status().code == Status::Code::stability);
    const std::string sentence = far.status().sentence;
    INFO(sentence);
    CHECK(sentence.find(name) != std::string::npos);
    CHECK(sentence.find("particle") != std::string::npos);
    CHECK(sentence.find(name == "rk4" ? "0.00278529" : "0.002 s") != std::string::npos);
    inside.step(1000);
    CHECK(std::abs(inside.body(0).position.x()) < 1);
    far.step(1000);
    CHECK(!(std::abs(far.body(0).position.x()) < 1e10));
  }
}

TEST_CASE("P-O2: every explicit row reports the step of 0.05 s", "[physics]") {
  for (const IntegratorDescription& row : integrators_for(stiff("rk4", 0.05))) {
    const std::string& name = row.name;
    INFO(name);
    if (row.implicit) continue;
    CHECK(World(stiff(name, 0.05)).status().code == Status::Code::stability);
  }
}

TEST_CASE("what is no longer finite is reported with its body, step and time", "[physics]") {
  Scene made = stiff("euler", 0.05);
  made.bodies[0].position = {{0, 0, 0}, {1, 0, 0}};
  made.run.accept = {"stability"};
  World world(made);
  CHECK(world.status().code == Status::Code::stability);
  world.step(1000);
  CHECK(world.status().code == Status::Code::non_finite);  // accepting the limit must not hide it
  CHECK(world.status().body == 1);
  CHECK_THAT(world.status().sentence,
             Catch::Matchers::StartsWith("body 1 is no longer finite; a step of 0.05 s exceeds"));

  Scene pushed = scene(particle(Vector3d::Zero()), {}, 1, 0.125);
  pushed.bodies[0].position = {{0, 0, 0}, {1, 0, 0}};
  World far(pushed);
  far.apply_force(1, {1e308, 0, 0}, 0.5, 1e9);
  far.step(4);
  CHECK(far.status().code == Status::Code::ok);
  far.step(200);
  CHECK(far.status().code == Status::Code::non_finite);
  CHECK(far.status().body == 1);
  CHECK(far.status().step > 4);
  CHECK(far.status().time == static_cast<double>(far.status().step) * 0.125);
  CHECK(far.body(0).position == Vector3d(0, 0, 0));
}
