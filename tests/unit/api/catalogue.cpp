// The catalogue is what worlds accept: every name in it works, and lists describe themselves.
#include "ballpark/catalogue.h"

#include <algorithm>

#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::World;

namespace {

/// Has it a damper, which sample() leaves at 0?
bool damps(const ballpark::EffectDescription& description) {
  return std::any_of(description.parameters.begin(), description.parameters.end(),
                     [](const ballpark::ParameterInfo& parameter) { return parameter.name == "damping"; });
}

}  // namespace

TEST_CASE("Catalogue: every effect and integrator runs", "[api]") {
  for (const ballpark::EffectDescription& description : ballpark::effects()) {
    for (const ballpark::IntegratorDescription& integrator : ballpark::integrators()) {
      const bool flows = contains(description.exerts, "flow"), resists = contains(description.exerts, "inertia");
      const bool of_balls = description.name == "table";  // which bodies of unequal moments do not roll on
      Scene scene = scene_of({sized(of_balls ? round_bricks("b", 3) : bricks("b", 3))}, {sample(description)});
      if (of_balls) scene.effects[0].parameters["settling"] = 1.0;
      if (description.name == "reflecting_wall") scene.effects[0].parameters["point"] = Vector3d(0, 0, 50);
      if (flows) scene.effects.push_back(effect("linear_drag", {{"coefficient", 0.3}}));  // which it acts through
      if (resists || of_balls) scene.effects.push_back(effect("gravity"));
      scene.run.integrator = integrator.name;
      scene.run.duration = 10 * scene.run.step;
      const bool between = description.between_steps;
      const bool differentiated = integrator.name != "taylor2" || description.has_force_derivative || between;
      const bool turned = integrator.turns_velocity && description.turns_velocity;
      const bool blind =
          integrator.family == "splitting" && (integrator.order > 2 || (integrator.turns_velocity && !turned));
      const bool reads = (contains(description.reads, "velocity") || contains(description.reads, "spin") || flows) &&
                         !damps(description) && description.name != "pivot";
      const bool accepted = differentiated && !(blind && reads) && !(resists && integrator.turns_velocity) &&
                            !(between && integrator.start_steps > 0) &&
                            !(contains(description.exerts, "present") && integrator.implicit);
      CHECK(check(scene).empty() == accepted);
      if (!accepted) continue;
      World with(scene);
      scene.effects.erase(scene.effects.begin());
      World without(scene);
      with.step(10);
      without.step(10);
      CAPTURE(description.name, integrator.name);
      CHECK(with.status().code == ballpark::Status::Code::ok);
      CHECK(with.body(0).has_orientation != of_balls);
      CHECK(with.totals().non_finite_bodies == 0);
      CHECK(with.state_hash() != without.state_hash());
    }
  }
}

TEST_CASE("Catalogue: shapes, rotations and targets are accepted where they belong", "[api]") {
  for (const ballpark::NamedDescription& shape : ballpark::shapes()) {
    Scene scene = scene_of({balls("s", 1)});
    scene.bodies[0].shape = shape.name;
    CHECK(check(scene).empty());
    CHECK_FALSE(shape.doc.empty());
  }
  for (const ballpark::NamedDescription& rotation : ballpark::rotations()) {
    Scene scene = scene_of({bricks("b", 1)});
    scene.run.rotation = rotation.name;
    if (rotation.name == "splitting") scene.run.integrator = "velocity_verlet";
    CHECK(check(scene).empty());
    CHECK_FALSE(rotation.doc.empty());
  }
  CHECK(ballpark::targets().at(0).name == "base");
  CHECK(ballpark::targets().at(0).available);
  for (const ballpark::NamedDescription& target : ballpark::targets()) {
    if (target.available) CHECK(World(scene_of({}), {.target = target.name}).target() == target.name);
  }
}

TEST_CASE("Catalogue: what an effect exerts and reads is what it does", "[api]") {
  for (const ballpark::EffectDescription& description : ballpark::effects()) {
    const bool reads_spin = contains(description.reads, "spin");
    Scene scene = scene_of({sized(particles("p", 2))}, {sample(description)});
    const bool refused = !check(scene).empty();
    CAPTURE(description.name);
    CHECK(refused == ((reads_spin || description.name == "torque") && description.name != "pivot"));
  }
}

TEST_CASE("Catalogue: the nearest name", "[api]") {
  const std::vector<std::string> names{"gravity", "linear_drag", "magnus"};
  CHECK(ballpark::nearest("gravty", names) == "gravity");
  CHECK(ballpark::nearest("lineardrag", names) == "linear_drag");
  CHECK(ballpark::nearest("zzz", names).empty());
  CHECK(ballpark::nearest("", names).empty());
  CHECK(ballpark::nearest("gravity", {}).empty());
  CHECK_FALSE(ballpark::version().empty());
}
