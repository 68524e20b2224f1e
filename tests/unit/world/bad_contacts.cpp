// What contacts refuse: each problem is named by its path and says what was expected.
#include <cmath>

#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::Boundary;

namespace {

Scene touching() {
  Scene scene = scene_of({balls("balls", 3)});
  scene.contact.kind = "impulse";
  scene.materials["steel"] = {0.9, 0.1};
  Boundary floor;
  floor.shape = "plane";
  scene.boundaries = {floor};
  return scene;
}

/// The only problem of the scene is at this path and says this.
void check_one(const Scene& scene, const std::string& path, const std::string& says) {
  const std::vector<Problem> problems = ballpark::check(scene);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].path == path);
  INFO(problems[0].message);
  CHECK(problems[0].message.find(says) != std::string::npos);
}

}  // namespace

TEST_CASE("Bad contacts: materials", "[world]") {
  CHECK(ballpark::check(touching()).empty());
  Scene scene = touching();
  scene.materials["steel"].restitution = 1.5;
  check_one(scene, "materials.steel.restitution", "from 0 to 1");
  scene = touching();
  scene.materials["steel"].friction = -1;
  check_one(scene, "materials.steel.friction", ">= 0");
  scene = touching();
  scene.bodies[0].material = "stele";
  check_one(scene, "bodies[0].material", "did you mean \"steel\"?");
  scene = touching();
  scene.boundaries[0].material = "glass";
  check_one(scene, "boundaries[0].material", "unknown material");
  scene = touching();
  scene.material_pairs = {{{"steel"}, 0.5, 0}};
  check_one(scene, "material_pairs[0].between", "two materials");
  scene.material_pairs = {{{"steel", "steel"}, 0.5, 0}, {{"steel", "steel"}, 0.4, 0}};
  check_one(scene, "material_pairs[1].between", "earlier pair");
}

TEST_CASE("Bad contacts: boundaries", "[world]") {
  const auto with = [](auto change) {
    Scene scene = touching();
    change(scene.boundaries[0]);
    return scene;
  };
  check_one(with([](Boundary& b) { b.shape = "plain"; }), "boundaries[0].shape", "did you mean \"plane\"?");
  check_one(with([](Boundary& b) { b.normal = {0, 0, 0}; }), "boundaries[0].normal", "a direction");
  check_one(with([](Boundary& b) { b.shape = "box"; }), "boundaries[0].size", "> 0");
  check_one(with([](Boundary& b) { b.shape = "tube"; }), "boundaries[0].radius", "> 0");
  check_one(with([](Boundary& b) { b.shape = "periodic"; }), "boundaries[0].size", "a length to repeat");
  check_one(with([](Boundary& b) { b.shape = "periodic", b.size = {0.3, 0, 0}; }), "boundaries[0].size", "its image");
  check_one(with([](Boundary& b) { b.side = "below"; }), "boundaries[0].side", "unknown side");
  check_one(with([](Boundary& b) { b.open = {"+z"}; }), "boundaries[0].open", "only a box");
  check_one(with([](Boundary& b) {
              b.motion = ballpark::Motion{.amplitude = {0, 0, 1}, .frequency = 1e9};
            }),
            "boundaries[0].motion.frequency", "half a swing");
  Scene no_contact = touching();
  no_contact.contact.kind = "";
  check_one(no_contact, "boundaries[0].shape", "expected [contact]");
}

TEST_CASE("Bad contacts: settings, and bodies that cannot touch", "[world]") {
  Scene scene = touching();
  scene.contact.kind = "inpulse";
  check_one(scene, "contact.kind", "did you mean \"impulse\"?");
  scene = touching();
  scene.contact.substeps = 0;
  check_one(scene, "contact.substeps", "from 1");
  scene = touching();
  scene.contact.margin = 0;
  check_one(scene, "contact.margin", "0.01 to 10");
  scene = touching();
  scene.contact.restitution_threshold = -1;
  check_one(scene, "contact.restitution_threshold", ">= 0");
  scene = touching();
  scene.bodies[0].inertia = {{1, 1, 1.5}};
  check_one(scene, "bodies[0].inertia", "equal ones");
  scene = touching();
  scene.effects = {effect("pivot", {{"point", Vector3d(0, 0, 9)}})};
  check_one(scene, "bodies[0].shape", "pivot");
}

TEST_CASE("Bad contacts: penalty asks for its own settings, and no others", "[world]") {
  const auto with = [](auto change) {
    Scene scene = touching();
    scene.contact.kind = "penalty";
    scene.contact.stiffness = 1e4;
    scene.run.step = 1e-5;
    change(scene);
    return scene;
  };
  CHECK(ballpark::check(with([](Scene&) {})).empty());
  check_one(with([](Scene& s) { s.contact.stiffness = 0; }), "contact.stiffness", "> 0");
  check_one(with([](Scene& s) { s.contact.stiffness = std::nan(""); }), "contact.stiffness", "nan");
  check_one(with([](Scene& s) { s.contact.tangential_stiffness = -1; }), "contact.tangential_stiffness", "> 0");
  check_one(with([](Scene& s) { s.contact.substeps = 4; }), "contact.substeps", "\"penalty\" does not have");
  check_one(with([](Scene& s) { s.contact.iterations = 4; }), "contact.iterations", "\"penalty\" does not have");
  check_one(with([](Scene& s) { s.contact.restitution_threshold = 1; }), "contact.restitution_threshold",
            "does not have");
  check_one(with([](Scene& s) { s.run.integrator = "taylor2"; }), "run.integrator", "penalty contacts do not give");
  CHECK(ballpark::check(with([](Scene& s) { s.run.integrator = "pefrl"; })).empty());  // elastic, without friction
  check_one(with([](Scene& s) {
              s.run.integrator = "pefrl";
              s.materials["steel"].restitution = 0.9, s.bodies[0].material = "steel";
            }),
            "run.integrator", "a penalty contact with restitution");
  check_one(with([](Scene& s) { s.materials["steel"].restitution = 0.001, s.bodies[0].material = "steel"; }),
            "contact.kind", "restitution 0.001 of steel on steel is less than 0.0025");
  CHECK(ballpark::check(with([](Scene& s) {
          s.materials["steel"].restitution = 0, s.bodies[0].material = "steel", s.contact.pull = true;
        })).empty());
  Scene hard = touching();
  hard.contact.stiffness = 1e4;
  check_one(hard, "contact.stiffness", "\"impulse\" does not have");
  hard = touching();
  hard.contact.pull = true;
  check_one(hard, "contact.pull", "does not have");
  Scene fused = with([](Scene&) {});
  const std::vector<Problem> problems = problems_of(fused, {.path = ballpark::Path::fused});
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].message == "penalty contacts take the staged path, expected automatic or staged");
}
