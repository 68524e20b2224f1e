#include "scenarios/command/scene_edit.h"

#include "perf/cost/subject.h"
#include "scenarios/command/errors.h"
#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::command;

namespace {

const std::string bodies = "[[bodies]]  # one\nmass = 1.0\nposition = [[1.0, 0.0, 0.0]]\n";

std::string edited(const std::string& text, const cost::Setting& setting) {
  return with_setting(text, scenes::parse(text, "a.toml"), setting);
}

cost::Setting by_step(const std::string& integrator, double step) {
  return {integrator, step, 0, Precision::double_};
}

}  // namespace

TEST_CASE("a setting is written in place, and the rest of the file stays", "[cost]") {
  const std::string text =
      "# a scene\n[run]\nduration = 1.0\n  step = 1e-3   # s\nintegrator = \"euler\"  # the \"first\"\n\n" + bodies;
  CHECK(edited(text, by_step("rk4", 0.25)) ==
        "# a scene\n[run]\nduration = 1.0\n  step = 0.25   # s\nintegrator = \"rk4\"  # the \"first\"\n\n" + bodies);
}

TEST_CASE("what a file leaves out is added below run.duration", "[cost]") {
  const std::string text = "[run]\n  duration = 1.0  # s\nstep = 0.5\n" + bodies;
  CHECK(edited(text, {"velocity_verlet", 0.5, 0, Precision::single_}) ==
        "[run]\n  duration = 1.0  # s\n  integrator = \"velocity_verlet\"\n  precision = \"single\"\nstep = 0.5\n" +
            bodies);
}

TEST_CASE("a step becomes a tolerance, and a tolerance a step", "[cost]") {
  const std::string stepped = "[run]\nduration = 1.0\nstep = 0.5\nintegrator = \"rk4\"\n" + bodies;
  const std::string tolerant =
      "[run]\nduration = 1.0\ntolerance = 1e-09\nabsolute_tolerance = 1e-6\nintegrator = \"dormand_prince5\"\n" +
      bodies;
  CHECK(edited(stepped, {"dormand_prince5", 0, 1e-9, Precision::double_}).find("\ntolerance = 1e-09\n") !=
        std::string::npos);
  CHECK(edited(tolerant, by_step("rk4", 0.5)) == stepped);
}

TEST_CASE("keys in one line and dotted keys are edited too", "[cost]") {
  const std::string in_line = "run = { duration = 1.0, step = 0.5, integrator = \"rk4\" }\n" + bodies;
  CHECK(edited(in_line, by_step("euler", 0.125)) ==
        "run = { duration = 1.0, step = 0.125, integrator = \"euler\" }\n" + bodies);
  const std::string dotted = "run.duration = 1.0\nrun.step = 0.5\n" + bodies;
  CHECK(edited(dotted, by_step("euler", 0.25)) ==
        "run.duration = 1.0\nrun.integrator = \"euler\"\nrun.step = 0.25\n" + bodies);
}

TEST_CASE("contact settings are written where they differ", "[cost]") {
  const std::string text =
      "[run]\nduration = 1.0\nstep = 0.5\n[contact]\nkind = \"impulse\"\niterations = 12\n[[bodies]]\nshape = "
      "\"sphere\"\nradius = 0.1\nmass = 1.0\nposition = [[1.0, 0.0, 0.0]]\n";
  const std::string changed = edited(text, {"rk4", 0.5, 0, Precision::double_, {"impulse", 4, 2}});
  CHECK(changed.find("kind = \"impulse\"\nsubsteps = 2\niterations = 4\n") != std::string::npos);
}

TEST_CASE("the other formulation of contacts is written without what it does not have", "[cost]") {
  const std::string head = "[run]\nduration = 1.0\nintegrator = \"rk4\"\nstep = 0.5\n[contact]\n",
                    tail =
                        "margin = 0.5\n[[bodies]]\nshape = \"sphere\"\nradius = 0.1\nmass = 1.0\nposition = [[1.0, "
                        "0.0, 0.0]]\n";
  const std::string hard = head + "kind = \"impulse\"\niterations = 4\nrelax_iterations = 2\n" + tail,
                    soft = head + "kind = \"penalty\"\nstiffness = 1500\n" + tail;
  cost::Setting setting = by_step("rk4", 0.5);
  setting.contact = {.kind = "penalty", .stiffness = 1500};
  CHECK(edited(hard, setting) == soft);
  setting.contact.stiffness = 0.1;
  CHECK(edited(soft, setting) == head + "kind = \"penalty\"\nstiffness = 0.1\n" + tail);
  setting.contact = {"impulse", 12, 3};
  CHECK(edited(soft, setting) == head + "kind = \"impulse\"\nsubsteps = 3\n" + tail);
}

TEST_CASE("line ends stay as they are, and so does a last line without one", "[cost]") {
  const std::string text =
      "[run]\r\nduration = 1.0\r\nstep = 0.5\r\n[[bodies]]\r\nmass = 1.0\r\nposition = [[1.0, 0.0, 0.0]]";
  CHECK(edited(text, by_step("euler", 0.25)) ==
        "[run]\r\nduration = 1.0\r\nintegrator = \"euler\"\r\nstep = 0.25\r\n[[bodies]]\r\nmass = "
        "1.0\r\nposition = [[1.0, 0.0, 0.0]]");
}

TEST_CASE("a file that can't be edited line by line is refused, and nothing is lost", "[cost]") {
  const std::string text = "run = { duration = 1.0, step = 0.5 }\n" + bodies;  // no place for an integrator
  CHECK_THROWS_AS(edited(text, by_step("euler", 0.5)), UsageError);
}
