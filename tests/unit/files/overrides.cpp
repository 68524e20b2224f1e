// --set: what it addresses, what it changes, and what it refuses.
#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace scene_texts;

namespace {

const std::string scene = drifting +
                          "[[bodies]]\nname = \"b.c\"\nmass = 1.0\ngenerate = { kind = \"random\", count = 4 }\n"
                          "[[effects]]\nkind = \"gravity\"\n"
                          "[[effects]]\nkind = \"linear_drag\"\ncoefficient = 1.0\ngroups = [\"ball\"]\n"
                          "[[effects]]\nkind = \"linear_drag\"\ncoefficient = 2.0\ngroups = [\"b.c\"]\n";

ballpark::Scene with(const std::string& key, const std::string& value) {
  return ballpark::scenes::parse(scene, "test.toml", {{key, value}}).scene;
}

LocatedProblem refused(const std::string& key, const std::string& value) {
  INFO(key + "=" + value);
  const std::vector<LocatedProblem> problems = problems_of(scene, {{key, value}});
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].location.file == "--set");
  CHECK(problems[0].location.line == 0);
  CHECK(contains(problems[0].message, "(" + key + "=" + value + ")"));
  return problems[0];
}

}  // namespace

TEST_CASE("Overrides: to ask for a tolerance takes the step out of the scene, and the other way round", "[files]") {
  const auto run_of = [](const std::vector<ballpark::scenes::Override>& changes) {
    return ballpark::scenes::parse(scene, "test.toml", changes).scene.run;
  };
  const ballpark::RunSettings adaptive =
      run_of({{"run.integrator", "tsitouras5"}, {"run.tolerance", "1e-8"}, {"run.absolute_tolerance", "1e-6"}});
  CHECK(adaptive.tolerance == 1e-8);
  CHECK(adaptive.absolute_tolerance == 1e-6);
  CHECK(adaptive.step == 0);
  const ballpark::RunSettings fixed = run_of({{"run.integrator", "tsitouras5"},
                                              {"run.tolerance", "1e-8"},
                                              {"run.absolute_tolerance", "1"},
                                              {"run.step", "0.5"}});
  CHECK(fixed.step == 0.5);
  CHECK(fixed.tolerance == 0);
  CHECK(fixed.absolute_tolerance == 0);
}

TEST_CASE("Overrides: a table is addressed by its name, else its kind, else its index", "[files]") {
  CHECK(with("run.step", "0.2").run.step == 0.2);
  CHECK(with("bodies.ball.mass", "3").bodies[0].mass == std::vector<double>{3});
  CHECK(with("bodies.0.mass", "3").bodies[0].mass == std::vector<double>{3});
  CHECK(with("bodies.\"b.c\".generate.count", "9").bodies[1].generate->count == std::vector<std::size_t>{9});
  CHECK(with("effects.gravity.acceleration", "[0, 0, -1.62]").effects[0].parameters.at("acceleration") ==
        ballpark::Value(ballpark::Vector3d(0, 0, -1.62)));
  CHECK(with("effects.2.coefficient", "5").effects[2].parameters.at("coefficient") == ballpark::Value(5.0));
}

TEST_CASE("Overrides: new keys, bare words, whole lists, several at once", "[files]") {
  CHECK(with("run.integrator", "euler").run.integrator == "euler");
  CHECK(with("run.integrator", "\"euler\"").run.integrator == "euler");
  CHECK(with("bodies.ball.position", "[[0, 0, 1], [0, 0, 2]]").bodies[0].position.size() == 2);
  CHECK(with("effects", "[]").effects.empty());
  const auto file = ballpark::scenes::parse(scene, "test.toml", {{"run.step", "0.5"}, {"run.step", "0.25"}});
  CHECK(file.scene.run.step == 0.25);
  CHECK(file.locations.at("run.step").file == "--set");
  CHECK(file.locations.at("run.duration").file == "test.toml");
}

TEST_CASE("Overrides: unknown addresses name the nearest choice", "[files]") {
  CHECK(contains(refused("bodies.bal.mass", "1").message, "expected one of ball, b.c; did you mean \"ball\"?"));
  CHECK(contains(refused("rum.step", "1").message, "did you mean \"run\"?"));
  CHECK(contains(refused("run.step.deep", "1").message, "there is no \"deep\" in run.step, which is 0.1"));
  CHECK(contains(refused("effects.linear_drag.coefficient", "1").message, "by its index"));
  CHECK(contains(refused("effects.3.coefficient", "1").message, "expected one of gravity, 1, 2"));
  CHECK(contains(refused("run..step", "1").message, "expected a path"));
  CHECK(contains(refused("", "1").message, "expected a path"));
}

TEST_CASE("Overrides: bad values are located as --set", "[files]") {
  CHECK(refused("run.step", "-1").key == "run.step");
  CHECK(refused("run.steps", "1").key == "run.steps");
  CHECK(contains(refused("run.steps", "1").message, "did you mean \"step\"?"));
  CHECK(contains(refused("run.integrator", "eulr").message, "did you mean \"euler\"?"));
  CHECK(refused("bodies.ball.mass", "heavy").key == "bodies[0].mass");
  CHECK(refused("bodies.ball.mass", "-1").key == "bodies[0].mass");
  CHECK(contains(refused("bodies.ball.mass", "[1").message, "is no TOML value"));
  CHECK(contains(refused("bodies.ball.mass", "").message, "is no TOML value"));
  CHECK(contains(refused("run.integrator", "two words").message, "is no TOML value"));
}
