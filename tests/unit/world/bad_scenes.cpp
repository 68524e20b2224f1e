// Every bad value of a scene: where it is, what it is, what was expected, the nearest choice.
#include <limits>

#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::Generate;
using ballpark::Precision;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

struct Case {
  std::string path, words;
  void (*spoil)(Scene&);
};

/// Each case is spoilt alone, found under its path by check() and by World, and is the only problem.
void check_cases(const Scene& good, const std::vector<Case>& cases) {
  REQUIRE(check(good).empty());
  REQUIRE(problems_of(good).empty());
  for (const Case& c : cases) {
    Scene scene = good;
    c.spoil(scene);
    const std::vector<Problem> found = check(scene), thrown = problems_of(scene);
    CAPTURE(c.path, c.words);
    REQUIRE(found.size() == 1);
    CHECK(found[0].path == c.path);
    CAPTURE(found[0].message);
    CHECK(contains(found[0].message, c.words));
    REQUIRE(thrown.size() == 1);
    CHECK(thrown[0].path == found[0].path);
    CHECK(thrown[0].message == found[0].message);
  }
}

Scene ball_scene() {
  return scene_of({spinning(balls("a", 2)), bricks("b", 3)}, {effect("gravity")});
}

Scene generated() {
  BodyGroup group = balls("g", 0);
  group.generate = Generate{.kind = "lattice", .count = {2, 3, 4}, .spacing = 0.5};
  return scene_of({group});
}

}  // namespace

TEST_CASE("Bad scenes: run settings", "[check]") {
  check_cases(
      ball_scene(),
      {{"run.duration", "is -1, expected a finite number >= 0 [s]", [](Scene& s) { s.run.duration = -1; }},
       {"run.duration", "is nan", [](Scene& s) { s.run.duration = not_a_number; }},
       {"run.duration", "is inf", [](Scene& s) { s.run.duration = inf; }},
       {"run.step", "is not given, expected a number > 0 [s], or run.tolerance", [](Scene& s) { s.run.step = 0; }},
       {"run.step", "is -0.1", [](Scene& s) { s.run.step = -0.1; }},
       {"run.step", "is nan", [](Scene& s) { s.run.step = not_a_number; }},
       {"run.step", "more than 1e15 steps", [](Scene& s) { s.run.step = 1e-300; }},
       {"run.integrator", "unknown integrator \"rk44\"; did you mean \"rk4\"?",
        [](Scene& s) { s.run.integrator = "rk44"; }},
       {"run.integrator", "expected one of euler", [](Scene& s) { s.run.integrator = ""; }},
       {"run.rotation", "\"renormalise\"?", [](Scene& s) { s.run.rotation = "renormalize"; }},
       {"run.accept[0]", "\"stability\"?", [](Scene& s) { s.run.accept = {"stabilty"}; }}});
}

TEST_CASE("Bad scenes: what bodies are", "[check]") {
  check_cases(
      ball_scene(),
      {{"bodies[0].mass", "is -1, expected a finite number > 0 [kg]", [](Scene& s) { s.bodies[0].mass = {-1}; }},
       {"bodies[0].mass", "is 0,", [](Scene& s) { s.bodies[0].mass = {0}; }},
       {"bodies[1].mass", "is nan", [](Scene& s) { s.bodies[1].mass = {not_a_number}; }},
       {"bodies[1].mass[2]", "is inf",
        [](Scene& s) {
          s.bodies[1].mass = {1, 2, inf};
        }},
       {"bodies[1].mass", "has 2 rows, expected one, or one for each of the 3 bodies",
        [](Scene& s) {
          s.bodies[1].mass = {1, 2};
        }},
       {"bodies[0].mass", "is missing, expected mass [kg], or density", [](Scene& s) { s.bodies[0].mass.clear(); }},
       {"bodies[0].density", "beside mass", [](Scene& s) { s.bodies[0].density = {1}; }},
       {"bodies[0].density", "is -2", [](Scene& s) { s.bodies[0].mass.clear(), s.bodies[0].density = {-2}; }},
       {"bodies[1].density", "needs a shape", [](Scene& s) { s.bodies[1].mass.clear(), s.bodies[1].density = {2}; }},
       {"bodies[0].radius", "is 0, expected a finite number > 0 [m]", [](Scene& s) { s.bodies[0].radius = {0}; }},
       {"bodies[0].radius[1]", "is -1",
        [](Scene& s) {
          s.bodies[0].radius = {1, -1};
        }},
       {"bodies[0].radius", "is missing, a sphere needs one", [](Scene& s) { s.bodies[0].radius.clear(); }},
       {"bodies[0].shape", "\"sphere\"?", [](Scene& s) { s.bodies[0].shape = "spere"; }},
       {"bodies[1].inertia", "expected a finite number > 0 [kg m^2]",
        [](Scene& s) {
          s.bodies[1].inertia = {{1, 0, 1}};
        }},
       {"bodies[1].inertia", "the largest exceeds the sum of the other two, 2",
        [](Scene& s) {
          s.bodies[1].inertia = {{1, 2.1, 1}};
        }},
       {"bodies[1].inertia[1]", "is nan",
        [](Scene& s) {
          s.bodies[1].inertia = {{1, 1, 1}, {1, 1, not_a_number}, {1, 1, 1}};
        }},
       {"bodies[1].name", "\"a\" is the name of an earlier group", [](Scene& s) { s.bodies[1].name = "a"; }}});
}

TEST_CASE("Bad scenes: where bodies are and how they move", "[check]") {
  check_cases(
      ball_scene(),
      {{"bodies[0].position[1]", "is nan, expected a finite number [m]",
        [](Scene& s) { s.bodies[0].position[1].y() = not_a_number; }},
       {"bodies[0].position", "is missing, though other lists have 2 rows",
        [](Scene& s) { s.bodies[0].position.clear(); }},
       {"bodies[1].velocity[0]", "is -inf", [](Scene& s) { s.bodies[1].velocity[0].z() = -inf; }},
       {"bodies[1].velocity", "has 2 rows", [](Scene& s) { s.bodies[1].velocity.pop_back(); }},
       {"bodies[0].angular_velocity[1]", "is nan",
        [](Scene& s) { s.bodies[0].angular_velocity[1].x() = not_a_number; }},
       {"bodies[0].angular_velocity_frame", "\"body\"?", [](Scene& s) { s.bodies[0].angular_velocity_frame = "bdy"; }},
       {"bodies[0].orientation", "has length 2, expected a unit quaternion",
        [](Scene& s) {
          s.bodies[0].orientation = {{2, 0, 0, 0}};
        }},
       {"bodies[0].orientation[1]", "has length nan",
        [](Scene& s) {
          s.bodies[0].orientation = {{}, {not_a_number, 0, 0, 0}};
        }},
       {"bodies[0].orientation", "has length 0",
        [](Scene& s) {
          s.bodies[0].orientation = {{0, 0, 0, 0}};
        }},
       {"bodies[1].angular_velocity", "given for particles", [](Scene& s) { s.bodies[1].inertia.clear(); }}});
}

TEST_CASE("Bad scenes: generators", "[check]") {
  check_cases(
      generated(),
      {{"bodies[0].generate.kind", "\"lattice\"?", [](Scene& s) { s.bodies[0].generate->kind = "latice"; }},
       {"bodies[0].generate.count", "expected three numbers", [](Scene& s) { s.bodies[0].generate->count = {3}; }},
       {"bodies[0].generate.count", "expected one number", [](Scene& s) { s.bodies[0].generate->kind = "random"; }},
       {"bodies[0].generate.spacing", "is 0,", [](Scene& s) { s.bodies[0].generate->spacing = 0; }},
       {"bodies[0].generate.origin", "is nan", [](Scene& s) { s.bodies[0].generate->origin.x() = not_a_number; }},
       {"bodies[0].generate.upper", "below lower",
        [](Scene& s) {
          s.bodies[0].generate = Generate{.kind = "random", .count = {1}, .lower = {0, 0, 1}};
        }},
       {"bodies[0].generate.velocity_spread", "is inf",
        [](Scene& s) { s.bodies[0].generate->velocity_spread.x() = inf; }},
       {"bodies[0].generate", "beside position",
        [](Scene& s) {
          s.bodies[0].position = {{0, 0, 0}};
        }},
       {"bodies[0].generate", "expected at most",
        [](Scene& s) {
          s.bodies[0].generate->count = {1000, 1001, 1000};
        }},
       {"bodies[0].generate", "expected at most", [](Scene& s) {
          s.bodies[0].generate->count = {1ull << 32, 1ull << 32, 2};
        }}});
}

TEST_CASE("Bad scenes: impulses", "[check]") {
  Scene good = scene_of({particles("p", 2), balls("s", 2)});
  good.impulses = {{.at = 0.5, .id = 2, .J = {1, 0, 0}, .offset = {0, 0.1, 0}}};
  check_cases(
      good, {{"impulse[0].at", "is -1", [](Scene& s) { s.impulses[0].at = -1; }},
             {"impulse[0].at", "is nan", [](Scene& s) { s.impulses[0].at = not_a_number; }},
             {"impulse[0].J", "is inf", [](Scene& s) { s.impulses[0].J.y() = inf; }},
             {"impulse[0].offset", "is nan", [](Scene& s) { s.impulses[0].offset.z() = not_a_number; }},
             {"impulse[0].offset", "body 1 is a particle", [](Scene& s) { s.impulses[0].id = 1; }},
             {"impulse[0].id", "is 4, expected the id of one of the 4 bodies", [](Scene& s) { s.impulses[0].id = 4; }},
             {"impulse[1].id", "is 9", [](Scene& s) { s.impulses.push_back({.id = 9}); }}});
}

TEST_CASE("Bad scenes: all problems are found at once", "[check]") {
  Scene scene = ball_scene();
  scene.run.step = 0;
  scene.bodies[0].mass = {-1};
  scene.bodies[1].inertia = {{1, 9, 1}};
  scene.effects[0].kind = "gravty";
  const std::vector<Problem> found = check(scene);
  REQUIRE(found.size() == 4);
  try {
    const ballpark::World world(scene);
    FAIL("accepted");
  } catch (const ballpark::SceneError& error) {
    CHECK(error.problems().size() == 4);
    CHECK(contains(error.what(), "bodies[0].mass: is -1"));
    CHECK(contains(error.what(), "\nbodies[1].inertia: "));
  }
}

TEST_CASE("Bad scenes: what single precision cannot hold is found for it alone", "[check]") {
  const auto spoilt = [](void (*spoil)(Scene&)) {
    Scene scene = ball_scene();
    spoil(scene);
    CHECK(problems_of(scene).empty());
    const std::vector<Problem> found = problems_of(scene, {.precision = Precision::single_});
    scene.run.precision = Precision::single_;
    CHECK(check(scene).size() == found.size());
    return found.empty() ? std::string() : found[0].path;
  };
  CHECK(spoilt([](Scene& s) { s.bodies[0].position[1].x() = 1e39; }) == "bodies[0].position[1]");
  CHECK(spoilt([](Scene& s) { s.bodies[0].mass = {1e39}; }) == "bodies[0].mass");
  CHECK(spoilt([](Scene& s) { s.bodies[0].mass = {1e-50}; }) == "bodies[0].mass");
  CHECK(spoilt([](Scene& s) { s.bodies[0].mass = {1e-40}; }) == "bodies[0].mass");
  CHECK(spoilt([](Scene& s) {
          s.run.step = 1e-41;
          s.run.duration = 1e-40;
        }) == "run.step");
}

TEST_CASE("Bad scenes: mass and inertia that follow from good values but overflow or vanish", "[check]") {
  const auto path = [](double radius, double density) {
    Scene scene = scene_of({spinning(balls("a", 2))});
    scene.bodies[0].radius = {radius};
    scene.bodies[0].mass.clear();
    scene.bodies[0].density = {density};
    const std::vector<Problem> found = problems_of(scene);
    return found.empty() ? std::string() : found[0].path;
  };
  CHECK(path(0.1, 1000).empty());
  CHECK(path(1e200, 1000) == "bodies[0].density");
  CHECK(path(1e-130, 1e-10) == "bodies[0].density");
  CHECK(path(1e-70, 1000) == "bodies[0].density");  // mass is in range, inertia is not
}
