// Every way a scene file can be wrong: which line, column and key is named, and what was expected.
#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace scene_texts;

namespace {

struct Wrong {
  std::string what, text;
  std::size_t line, column;
  std::string key, message;
};

std::string with_body(const std::string& lines) {
  return run_table + "[[bodies]]\nname = \"a\"\n" + lines;
}

std::string with_effect(const std::string& lines) {
  return drifting + "[[effects]]\n" + lines;
}

std::string with_expectation(const std::string& lines) {
  return drifting + "[[expect]]\n" + lines;
}

void require_one(const Wrong& wrong) {
  INFO(wrong.what << "\n" << wrong.text);
  const std::vector<LocatedProblem> problems = problems_of(wrong.text);
  for (const LocatedProblem& problem : problems) INFO(problem.key << ": " << problem.message);
  REQUIRE(problems.size() == 1);
  const LocatedProblem& problem = problems.front();
  CHECK(problem.location.file == "test.toml");
  CHECK(problem.location.line == wrong.line);
  CHECK(problem.location.column == wrong.column);
  CHECK(problem.key == wrong.key);
  INFO(problem.message);
  CHECK(contains(problem.message, wrong.message));
}

void require_each(const std::vector<Wrong>& list) {
  for (const Wrong& wrong : list) require_one(wrong);
}

}  // namespace

TEST_CASE("Scene files: unknown keys are named with the nearest known one", "[files]") {
  require_each({
      {"top", "nme = \"x\"\n" + drifting, 1, 1, "nme", "did you mean \"name\"?"},
      {"run", "[run]\nduration = 1\nstep = 1\nintegratr = \"rk4\"\n", 4, 1, "run.integratr", "\"integrator\"?"},
      {"bodies", with_body("mass = 1\nposition = [0, 0, 0]\n  raduis = 1\n"), 8, 3, "bodies[0].raduis", "\"radius\"?"},
      {"generate", with_body("mass = 1\ngenerate = { kind = \"random\", count = 1, cuont = 2 }\n"), 7, 42,
       "bodies[0].generate.cuont", "\"count\"?"},
      {"effect", with_effect("kind = \"linear_drag\"\ncoefficient = 1\ncoeficient = 1\n"), 12, 1,
       "effects[0].coeficient", "\"coefficient\"?"},
      {"another effect's parameter", with_effect("kind = \"gravity\"\nstiffness = 1\n"), 11, 1, "effects[0].stiffness",
       "expected one of kind, groups, acceleration"},
      {"impulse", drifting + "[[impulse]]\nat = 0\nid = 0\nJ = [0, 0, 0]\nofset = [0, 0, 0]\n", 13, 1,
       "impulse[0].ofset", "\"offset\"?"},
      {"output", drifting + "[[output]]\nevery = 1\nfile = \"a.csv\"\nfiles = \"b.csv\"\n", 12, 1, "output[0].files",
       "\"file\"?"},
      {"expect", with_expectation("quantity = \"time\"\nmin = 0\nmaximum = 2\n"), 12, 1, "expect[0].maximum",
       "expected one of quantity, at, min, max, value, tolerance"},
      {"contact", drifting + "[contact]\nkind = \"impulse\"\nsubstep = 2\n", 11, 1, "contact.substep", "\"substeps\"?"},
      {"material", drifting + "[materials.steel]\nfricton = 0.1\n", 10, 1, "materials.steel.fricton", "\"friction\"?"},
      {"boundary", drifting + "[contact]\nkind = \"impulse\"\n[[boundaries]]\nshape = \"plane\"\nnormall = [0, 0, 1]\n",
       13, 1, "boundaries[0].normall", "\"normal\"?"},
      {"what does not exist yet", "[run]\nduration = 1\nstep = 1\ntolerances = 1e-8\n", 4, 1, "run.tolerances",
       "unknown key"},
  });
}

TEST_CASE("Scene files: values of another type say what was expected", "[files]") {
  require_each({
      {"text for number", "[run]\nduration = \"long\"\nstep = 1\n", 2, 12, "run.duration",
       "is \"long\", expected a number >= 0 [s]"},
      {"no adaptive step yet", "[run]\nduration = 1\nstep = \"auto\"\n", 3, 8, "run.step", "expected a number > 0 [s]"},
      {"date for number", "[run]\nduration = 2020-01-01\nstep = 1\n", 2, 12, "run.duration", "is a date or time"},
      {"flag for number", "[run]\nduration = true\nstep = 1\n", 2, 12, "run.duration", "is true"},
      {"negative seed", "[run]\nduration = 1\nstep = 1\nseed = -1\n", 4, 8, "run.seed", "whole number >= 0"},
      {"number for text", "name = 3\n" + run_table, 1, 8, "name", "a text in quotes"},
      {"number for table", "run = 3\n", 1, 7, "run", "expected a table [run]"},
      {"table for tables", run_table + "[effects]\nkind = \"gravity\"\n", 4, 1, "effects", "under [[effects]]"},
      {"text for mass", with_body("mass = \"heavy\"\nposition = [0, 0, 0]\n"), 6, 8, "bodies[0].mass",
       "is \"heavy\", expected a number > 0 [kg]"},
      {"two numbers for a vector", with_body("mass = 1\nposition = [0, 0]\n"), 7, 12, "bodies[0].position",
       "is [0, 0], expected [x, y, z] [m]"},
      {"a short row", with_body("mass = 1\nposition = [[0, 0, 0],\n [1, 2]]\n"), 8, 2, "bodies[0].position",
       "row 1 is [1, 2]"},
      {"text in a row", with_body("mass = 1\nposition = [[0, 0, 0], [0, 0, \"x\"]]\n"), 7, 31, "bodies[0].position",
       "row 1 holds \"x\""},
      {"three numbers for a quaternion", with_body("mass = 1\nposition = [0, 0, 0]\norientation = [1, 0, 0]\n"), 8, 15,
       "bodies[0].orientation", "[w, x, y, z]"},
      {"number for flag", with_body("mass = 1\ngenerate = { kind = \"random\", count = 1, random_orientation = 1 }\n"),
       7, 63, "bodies[0].generate.random_orientation", "true or false"},
      {"fraction for count", with_body("mass = 1\ngenerate = { kind = \"random\", count = 1.5 }\n"), 7, 39,
       "bodies[0].generate.count", "whole number"},
      {"number for vector", with_effect("kind = \"gravity\"\nacceleration = 9.81\n"), 11, 16, "effects[0].acceleration",
       "[x, y, z]"},
      {"one time alone", drifting + "[[output]]\nat = 0.5\nfile = \"a.csv\"\n", 10, 6, "output[0].at", "a list"},
  });
}

TEST_CASE("Scene files: words are among the known ones", "[files]") {
  require_each({
      {"integrator", "[run]\nduration = 1\nstep = 1\nintegrator = \"rk44\"\n", 4, 14, "run.integrator", "\"rk4\"?"},
      {"rotation", "[run]\nduration = 1\nstep = 1\nrotation = \"renormalize\"\n", 4, 12, "run.rotation",
       "\"renormalise\"?"},
      {"accept", "[run]\nduration = 1\nstep = 1\naccept = [\"stabilty\"]\n", 4, 11, "run.accept", "\"stability\"?"},
      {"precision", "[run]\nduration = 1\nstep = 1\nprecision = \"doubel\"\n", 4, 13, "run.precision", "\"double\"?"},
      {"shape", with_body("mass = 1\nposition = [0, 0, 0]\nradius = 1\nshape = \"shere\"\n"), 9, 9, "bodies[0].shape",
       "expected \"sphere\"; did you mean \"sphere\"?"},
      {"frame", with_body("mass = 1\nposition = [0, 0, 0]\nangular_velocity_frame = \"bdy\"\n"), 8, 26,
       "bodies[0].angular_velocity_frame", "\"body\"?"},
      {"ids", with_body("mass = 1\nposition = [0, 0, 0]\nids = \"random\"\n"), 8, 7, "bodies[0].ids", "\"from order\""},
      {"generator", with_body("mass = 1\ngenerate = { kind = \"latice\", count = [1, 1, 1], spacing = 1 }\n"), 7, 21,
       "bodies[0].generate.kind", "\"lattice\"?"},
      {"effect", with_effect("kind = \"gravty\"\nunknown = 1\n"), 10, 8, "effects[0].kind", "\"gravity\"?"},
  });
}

TEST_CASE("Scene files: what must be there is missed at its table", "[files]") {
  require_each({
      {"empty", "", 1, 1, "run", "is missing"},
      {"duration", "\n[run]\nstep = 1\n", 2, 1, "run.duration", "is missing, expected a number >= 0 [s]"},
      {"step", "[run]\nduration = 1\n", 1, 1, "run.step", "is not given, expected a number > 0 [s], or run.tolerance"},
      {"mass", with_body("position = [0, 0, 0]\n"), 4, 1, "bodies[0].mass", "is missing"},
      {"radius of a sphere", with_body("mass = 1\nshape = \"sphere\"\nposition = [0, 0, 0]\n"), 4, 1,
       "bodies[0].radius", "is missing"},
      {"count", with_body("mass = 1\n[bodies.generate]\nkind = \"random\"\n"), 7, 1, "bodies[0].generate.count",
       "is missing"},
      {"kind of effect", with_effect("coefficient = 1\n"), 9, 1, "effects[0].kind", "is missing"},
      {"parameter", with_effect("kind = \"quadratic_drag\"\n"), 9, 1, "effects[0].coefficient", "is missing"},
      {"id", drifting + "[[impulse]]\nat = 0\nJ = [0, 0, 1]\n", 9, 1, "impulse[0].id", "is missing"},
      {"file", drifting + "[[output]]\nevery = 0.5\n", 9, 1, "output[0].file", "is missing"},
      {"quantity", with_expectation("min = 0\n"), 9, 1, "expect[0].quantity", "is missing"},
      {"tolerance", with_expectation("quantity = \"time\"\nvalue = 1\n"), 9, 1, "expect[0].tolerance", "is missing"},
  });
}
