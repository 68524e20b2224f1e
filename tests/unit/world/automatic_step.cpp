// step = "auto": a tenth of the largest stable step, in whole steps.
#include <cmath>

#include "ballpark/scenes.h"
#include "ballpark/world.h"
#include "tests/catch.h"

using namespace ballpark;

namespace {

std::string spring_scene(
    const std::string& run,
    const std::string& effect = "kind = \"spring\"\nanchor = [0.0, 0.0, 0.0]\nstiffness = 25.0\n") {
  return "[run]\nduration = 10.0\n" + run + "\n[[bodies]]\nmass = 1.0\nposition = [[1.0, 0.0, 0.0]]\n[[effects]]\n" +
         effect;
}

Scene loaded(const std::string& text, const std::vector<scenes::Override>& overrides = {}) {
  return scenes::parse(text, "a.toml", overrides).scene;
}

std::string why(const std::string& text) {
  try {
    loaded(text);
  } catch (const scenes::SceneFileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("auto: a tenth of the stability limit of the scene's integrator, shortened to whole steps", "[auto]") {
  for (const auto& [integrator, limit] : {std::pair{"rk4", 2 * std::sqrt(2.0)}, std::pair{"velocity_verlet", 2.0}}) {
    const double step =
        loaded(spring_scene("step = \"auto\"\nintegrator = \"" + std::string(integrator) + "\"")).run.step;
    const double longest = 0.1 * limit / 5;  // omega = 5/s
    CHECK(step <= longest * (1 + 1e-6));
    CHECK(step > 0.98 * longest);
    const double steps = 10 / step;
    CHECK(std::abs(steps - std::round(steps)) < 1e-9);
  }
}

TEST_CASE("auto: a scene built in code gets the same step as its file", "[auto]") {
  Scene scene = loaded(spring_scene("step = 1.0"));
  const double from_file = loaded(spring_scene("step = \"auto\"")).run.step;
  scene.run.step = 0;
  scene.run.automatic_step = true;
  World world(scene);
  world.step(1);
  CHECK(world.time() == from_file);
  CHECK(world.status().code == Status::Code::ok);
  CHECK(loaded(spring_scene("step = 1.0"), {{"run.step", "auto"}}).run.step == from_file);
  scene.run.step = 0.1;
  CHECK_THROWS_AS(World(scene), SceneError);
}

TEST_CASE("auto: penalty contacts limit the step", "[auto]") {
  const std::string balls =
      "[run]\nduration = 1.0\nstep = \"auto\"\nintegrator = \"velocity_verlet\"\n[contact]\nkind = "
      "\"penalty\"\nstiffness = "
      "1e4\n[[bodies]]\nshape = \"sphere\"\nradius = 0.1\nmass = 2.0\nposition = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]\n";
  const double limit = 2 / std::sqrt(1e4 * (1 / 2.0 + 1 / 2.0));  // two bodies on one spring
  CHECK(std::abs(loaded(balls).run.step / (0.1 * limit) - 1) < 0.02);
}

TEST_CASE("auto: where nothing limits a step, or no step is stable, that is said", "[auto]") {
  CHECK(why(spring_scene("step = \"auto\"", "kind = \"gravity\"\n")).find("nothing that limits a step") !=
        std::string::npos);
  const std::string euler = why(spring_scene("step = \"auto\"\nintegrator = \"euler\""));
  CHECK(euler.find("no stable step for euler") != std::string::npos);
  CHECK(euler.find("a.toml:3:8: run.step") != std::string::npos);
  CHECK(why(spring_scene("step = \"aut\"")).find("did you mean \"auto\"") != std::string::npos);
  CHECK(why(spring_scene("step = \"auto\"\ntolerance = 1e-6\nintegrator = \"dormand_prince5\""))
            .find("expected one of the two") != std::string::npos);
}
