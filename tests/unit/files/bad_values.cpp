// Values of the right type that make no sense: the engine's checks, located in the file.
#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace scene_texts;

namespace {

struct Wrong {
  std::string line;  ///< replaces line 8 of the scene below
  std::size_t column;
  std::string key, message;
};

/// One sphere; line 8 is free.
std::string sphere_with(const std::string& line) {
  return run_table + "[[bodies]]\nname = \"a\"\nposition = [0.0, 0.0, 0.0]\nshape = \"sphere\"\n" + line + "\n";
}

void require_at_line_8(const std::string& text, const Wrong& wrong) {
  INFO(text);
  const std::vector<LocatedProblem> problems = problems_of(text);
  REQUIRE(problems.size() == 1);
  const LocatedProblem& problem = problems.front();
  CHECK(problem.location.line == 8);
  CHECK(problem.location.column == wrong.column);
  CHECK(problem.key == wrong.key);
  INFO(problem.message);
  CHECK(contains(problem.message, wrong.message));
}

}  // namespace

TEST_CASE("Scene files: impossible matter is refused where it stands", "[files]") {
  const std::vector<Wrong> list = {
      {"mass = -1.0\nradius = 1.0", 8, "bodies[0].mass", "-1"},
      {"mass = 0\nradius = 1.0", 8, "bodies[0].mass", "> 0"},
      {"mass = nan\nradius = 1.0", 8, "bodies[0].mass", "nan"},
      {"mass = inf\nradius = 1.0", 8, "bodies[0].mass", "inf"},
      {"radius = 0.0\nmass = 1.0", 10, "bodies[0].radius", "> 0"},
      {"density = -3.0\nradius = 1.0", 11, "bodies[0].density", "> 0"},
      {"inertia = [1.0, 1.0, 2.5]\nmass = 1.0\nradius = 1.0", 11, "bodies[0].inertia", "sum of the other two"},
      {"orientation = [1.0, 0.1, 0.0, 0.0]\nmass = 1.0\nradius = 1.0", 15, "bodies[0].orientation", "unit quaternion"},
      {"velocity = [0.0, nan, 0.0]\nmass = 1.0\nradius = 1.0", 12, "bodies[0].velocity", "nan"},
  };
  for (const Wrong& wrong : list) require_at_line_8(sphere_with(wrong.line), wrong);
}

TEST_CASE("Scene files: a bad row of a list is found in the list", "[files]") {
  const std::string head =
      run_table + "[[bodies]]\nname = \"a\"\nposition = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]\nmass = [\n";
  require_at_line_8(head + "  1.0, 1.0, -1.0]\n", {"", 13, "bodies[0].mass[2]", "> 0"});
  const std::string masses = run_table + "[[bodies]]\nname = \"a\"\nmass = 1\nposition = [ # three\n";
  require_at_line_8(masses + "[0, 0, 0], [0, 0, inf], [0, 0, 0]]\n", {"", 12, "bodies[0].position[1]", "inf"});
}

TEST_CASE("Scene files: bad times and lengths of time are refused where they stand", "[files]") {
  const auto at = [](const std::string& text) {
    const std::vector<LocatedProblem> problems = problems_of(text);
    REQUIRE(problems.size() == 1);
    return std::to_string(problems[0].location.line) + ":" + std::to_string(problems[0].location.column) + " " +
           problems[0].key;
  };
  CHECK(at("[run]\nduration = -1\nstep = 1\n") == "2:12 run.duration");
  CHECK(at("[run]\nduration = nan\nstep = 1\n") == "2:12 run.duration");
  CHECK(at("[run]\nduration = 1\nstep = 0\n") == "3:8 run.step");
  CHECK(at("[run]\nduration = 1\nstep = nan\n") == "3:8 run.step");
  CHECK(at(drifting + "[[impulse]]\nat = -1\nid = 0\nJ = [0, 0, 1]\n") == "10:6 impulse[0].at");
  CHECK(at(drifting + "[[impulse]]\nat = 0\nid = 1\nJ = [0, 0, 1]\n") == "11:6 impulse[0].id");
  CHECK(at(drifting + "[[output]]\nevery = 0\nfile = \"a.csv\"\n") == "10:9 output[0].every");
  CHECK(at(drifting + "[[output]]\nat = [0.0, 2.0]\nfile = \"a.csv\"\n") == "10:6 output[0].at");
  CHECK(at(drifting + "[[output]]\nevery = 1\nat = [0]\nfile = \"a.csv\"\n") == "11:6 output[0].at");
  CHECK(at(drifting + "[[output]]\nfile = \"a.csv\"\n") == "9:1 output[0]");
  CHECK(at(drifting + "[[output]]\nevery = 1\nfile = \"a.txt\"\n") == "11:8 output[0].file");
  CHECK(at(drifting + "[[expect]]\nquantity = \"time\"\nmin = 0\nat = 1.5\n") == "12:6 expect[0].at");
  CHECK(at(drifting + "[[expect]]\nquantity = \"time\"\nmin = nan\n") == "11:7 expect[0].min");
  CHECK(at(drifting + "[[expect]]\nquantity = \"time\"\nmin = 2\nmax = 1\n") == "12:7 expect[0].max");
  CHECK(at(drifting + "[[expect]]\nquantity = \"time\"\n") == "9:1 expect[0]");
  CHECK(at(drifting + "[[expect]]\nquantity = \"time\"\nmin = 1\nvalue = 1\ntolerance = 1\n") == "9:1 expect[0]");
}

TEST_CASE("Scene files: all problems are told, in the order of the file", "[files]") {
  const std::vector<LocatedProblem> problems = problems_of(
      "nme = \"x\"\n[run]\nduration = -1\nstp = 1\n[[bodies]]\nname = \"a\"\nmass = -1\nposition = [0, 0, 0]\n"
      "[[effects]]\nkind = \"spring\"\nstiffness = \"x\"\n");
  std::vector<std::string> keys;
  for (const LocatedProblem& problem : problems) keys.push_back(problem.key);
  const std::vector<std::string> expected = {
      "nme", "run.step", "run.duration", "run.stp", "bodies[0].mass", "effects[0].anchor", "effects[0].stiffness"};
  CHECK(keys == expected);
}

TEST_CASE("Scene files: groups without bodies and bodies that generate them", "[files]") {
  using ballpark::scenes::parse;
  CHECK(parse(run_table, "none.toml").scene.bodies.empty());
  CHECK(parse(run_table, "none.toml").scene.name == "none");
  const auto file = parse(run_table +
                              "[[bodies]]\nname = \"a\"\nmass = 1\ngenerate = { kind = \"lattice\", count = [2, "
                              "3, 4], spacing = 0.5, origin = [1, 2, 3] }\n",
                          "lattice.toml");
  const ballpark::Generate& generate = *file.scene.bodies.at(0).generate;
  CHECK(generate.kind == "lattice");
  CHECK(generate.count == std::vector<std::size_t>{2, 3, 4});
  CHECK(generate.spacing == 0.5);
  CHECK(generate.origin == ballpark::Vector3d(1, 2, 3));
}
