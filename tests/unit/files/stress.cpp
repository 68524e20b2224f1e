// Hard cases: what [stress] may say, and what comes of each way to run one.
#include "scenarios/files/stress.h"

#include <cmath>
#include <filesystem>

#include "scenarios/files/comparisons.h"
#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace ballpark::scenes;
using namespace scene_texts;

namespace {

/// The ball of `drifting`, which must be 1 m farther at the end.
const std::string expects_drift = "[[expect]]\nquantity = \"state.0.x\"\nvalue = 2.0\ntolerance = 1e-12\n";

std::string hard(const std::string& lines, const std::string& rest = expects_drift) {
  return drifting + "[stress]\nwhat = \"how far it goes\"\n" + lines + rest;
}

std::vector<CellResult> results_of(const std::string& text) {
  const ScratchFolder folder;
  const StressCase hard_case(written(folder, "hard.toml", text));
  std::vector<CellResult> results;
  for (std::size_t cell = 0; cell < hard_case.cells(); ++cell) results.push_back(hard_case.run(cell, {}));
  return results;
}

/// The verdict on a measure of comparisons, in a scene of two bodies: one at the origin, one at (1, 2, 3) and 1 m/s.
double measured(const std::string& compare, const std::string& measure, const std::string& rest) {
  const std::string text = run_table +
                           "[[bodies]]\nname = \"pair\"\nmass = 1.0\nposition = [[0, 0, 0], [1, 2, 3]]\n"
                           "velocity = [[0, 0, 0], [1, 0, 0]]\n[stress]\nwhat = \"x\"\nowed = [{}]\ncompare = [\"" +
                           compare + "\"]\n" + rest + "[[expect]]\nquantity = \"stress." + measure + "\"\nmin = 0\n";
  const std::vector<CellResult> results = results_of(text);
  REQUIRE(results.size() == 1);
  INFO(results[0].said);
  REQUIRE(results[0].verdicts.size() == 1);
  CHECK(results[0].measures.at(measure) == results[0].verdicts[0].measured);
  return results[0].verdicts[0].measured;
}

void check_problem(const std::string& text, std::size_t line, const std::string& key, const std::string& message) {
  INFO(text);
  const std::vector<LocatedProblem> problems = problems_of(text);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].location.line == line);
  CHECK(problems[0].key == key);
  INFO(problems[0].message);
  CHECK(contains(problems[0].message, message));
}

}  // namespace

TEST_CASE("Hard cases: what is wrong with [stress] is named with its place", "[files]") {
  REQUIRE(problems_of(hard("owed = [{}]\n")).empty());
  check_problem(hard("owed = [{}]\nclas = \"quick\"\n"), 12, "stress.clas", "did you mean \"class\"?");
  check_problem(hard("owed = [{}]\nclass = \"quik\"\n"), 12, "stress.class", "did you mean \"quick\"?");
  check_problem(hard("owed = [{}]\ncompare = [\"thread\"]\n"), 12, "stress.compare", "did you mean \"threads\"?");
  check_problem(hard("owed = [{ ste = [\"run.step=1\"] }]\n"), 11, "stress.owed[0].ste", "did you mean \"set\"?");
  check_problem(hard("owed = [{ set = [\"run.step\"] }]\n"), 11, "stress.owed[0].set", "not key=value");
  check_problem(hard("owed = [{ refused = \"a\", reported = \"b\" }]\n"), 11, "stress.owed[0].reported",
                "one of the two");
  check_problem(hard("shown = [{}]\n"), 9, "stress.owed", "is missing");
  check_problem(hard("owed = [{}]\nshift = [1, 0, 0]\n"), 12, "stress.shift", "without compare");
  check_problem(hard("owed = [{}]\ncompare = [\"shift\"]\n"), 9, "stress.shift", "is missing");
  check_problem(hard("owed = [{}]\nfrom = 2\n"), 12, "stress.from", "run.duration");
  check_problem(hard("owed = [{}]\nframes = [0.1, 0]\n"), 12, "stress.frames", "> 0");
  check_problem(hard("owed = [{}]\n", ""), 11, "stress.owed[0]", "nothing to hold");
  check_problem(hard("waits_for = \"impulse\"\n"), 11, "stress.waits_for", "which exists");
  REQUIRE(problems_of(hard("waits_for = \"what will be\"\n")).empty());
}

TEST_CASE("Hard cases: an expectation names what is compared", "[files]") {
  const auto expecting = [](const std::string& measure) {
    return "[[expect]]\nquantity = \"stress." + measure + "\"\nmin = 1\n";
  };
  const std::string threads = "owed = [{}]\ncompare = [\"threads\"]\n";
  REQUIRE(problems_of(hard(threads, expecting("hash_equal"))).empty());
  check_problem(hard(threads, expecting("hash_equl")), 14, "expect[0].quantity", "did you mean \"hash_equal\"?");
  check_problem(hard(threads, expecting("difference")), 14, "expect[0].quantity",
                "expected \"shift\" in stress.compare");
  check_problem(drifting + expecting("hash_equal"), 10, "expect[0].quantity", "expected a [stress] table");
  const auto alone = run(parse(hard(threads, expecting("hash_equal")), "test.toml"));
  CHECK_FALSE(alone.verdicts.at(0).met);
  CHECK(contains(alone.verdicts.at(0).sentence, "only `ballpark stress` measures it"));
}

TEST_CASE("Hard cases: owed and shown ways hold or fail by what the scene expects", "[files]") {
  const auto results =
      results_of(hard("owed = [{}, { set = [\"run.duration=0.5\"] }]\nshown = [{ name = \"half\", set = "
                      "[\"expect.0.value=1.5\", \"run.duration=0.5\"] }]\n"));
  REQUIRE(results.size() == 3);
  CHECK(results[0].held);
  CHECK(results[0].name == "rk4, double");
  CHECK_FALSE(results[1].held);
  CHECK(results[1].name == "rk4, double, duration=0.5");
  CHECK(results[1].owed);
  CHECK(results[2].held);
  CHECK(results[2].name == "half");
  CHECK_FALSE(results[2].owed);
  CHECK_FALSE(holds({"", "", "", "", results}));
  CHECK(holds({"", "", "", "", {results[0], results[2]}}));
}

TEST_CASE("Hard cases: a refusal counts where it is owed, and there alone", "[files]") {
  const std::string spring = "[[effects]]\nkind = \"spring\"\nanchor = [0, 0, 0]\nstiffness = 1e4\n";
  const auto results =
      results_of(hard("owed = [{ set = [\"bodies.ball.mass=0\"], refused = \"bodies[0].mass\" },"
                      " { set = [\"bodies.ball.mass=0\"], refused = \"bodies[0].radius\" },"
                      " { refused = \"mass\" }]\n"));
  CHECK(results[0].held);
  CHECK(contains(results[0].said, "bodies[0].mass"));
  CHECK_FALSE(results[1].held);  // another refusal than the one that is owed
  CHECK_FALSE(results[2].held);  // none
  const auto reports =
      results_of(hard("owed = [{ refused = \"exceeds\" }, {}, { reported = \"exceeds\" }]\n", spring + expects_drift));
  CHECK(reports[0].held);
  CHECK_FALSE(reports[1].held);
  CHECK_FALSE(reports[2].held);  // it is reported, but the ball is elsewhere
  CHECK(contains(reports[1].said, "exceeds"));
}

TEST_CASE("Hard cases: a setting that is wrong is found before anything is run", "[files]") {
  const ScratchFolder folder;
  const std::string path = written(folder, "hard.toml", hard("owed = [{}, { set = [\"run.integrator=rk44\"] }]\n"));
  try {
    StressCase hard_case(path);
    FAIL("it was taken");
  } catch (const SceneFileError& error) {
    REQUIRE(error.problems().size() == 1);
    const LocatedProblem& problem = error.problems()[0];
    CHECK(problem.location.file == path);
    CHECK(problem.location.line == 11);
    CHECK(problem.key == "stress.owed[1].set: run.integrator");
    CHECK(contains(problem.message, "did you mean \"rk4\"?"));
  }
  CHECK_THROWS_AS(StressCase(written(folder, "plain.toml", drifting)), SceneFileError);
}

TEST_CASE("Hard cases: what comparisons measure", "[files]") {
  const std::string pull = "[[effects]]\nkind = \"mutual_gravity\"\nstrength = 1.0\n";
  const std::string push = "[[impulse]]\nat = 0.5\nid = 0\nJ = [0, 1, 0]\n";
  for (const char* way : {"repeat", "threads", "targets", "resume", "frame_pattern"}) {
    INFO(way);
    CHECK(measured(way, "hash_equal", pull + push) == 1);
  }
  CHECK(measured("with_fault", "bodies_changed", push) == 0);
  CHECK(measured("with_fault", "bodies_changed", pull + push) == 1);  // it feels the one that was pushed
  CHECK(std::abs(measured("start", "displacement", "") - 1) < 1e-14);
  CHECK(std::abs(measured("start", "displacement", "from = 0.5\n") - 0.5) < 1e-14);
  CHECK(measured("mirror", "mirror_error", "") ==
        4);  // from (2, -2, 3) to (2, 2, 3), nearer than the origin's sqrt(17)
  CHECK(measured("unit", "norm_error", "") == 0);
  const double far = measured("shift", "difference", "shift = [1e6, 0, 0]\n" + pull);
  CHECK(far > 0);
  CHECK(far < 1e-9);
}

TEST_CASE("Hard cases: a shifted scene moves all that has a place", "[files]") {
  const auto scene =
      parse(drifting +
                "[[effects]]\nkind = \"spring\"\nanchor = [1, 0, 0]\nstiffness = 1\n[[effects]]\nkind = "
                "\"central_gravity\"\nstrength = 1\n[[effects]]\nkind = \"force\"\nforce = [0, 0, 1]\nat = 0\nuntil = "
                "1\n[contact]\nkind = \"impulse\"\n[[boundaries]]\nshape = \"plane\"\npoint = [0, 0, -5]\n",
            "test.toml")
          .scene;
  const auto moved = shifted(scene, {10, 0, 0});
  CHECK(moved.bodies[0].position[0] == ballpark::Vector3d(11, 2, 3));
  CHECK(moved.boundaries[0].point == ballpark::Vector3d(10, 0, -5));
  CHECK(std::get<ballpark::Vector3d>(moved.effects[0].parameters.at("anchor")) == ballpark::Vector3d(11, 0, 0));
  CHECK(std::get<ballpark::Vector3d>(moved.effects[1].parameters.at("centre")) == ballpark::Vector3d(10, 0, 0));
  CHECK(moved.effects[2].parameters == scene.effects[2].parameters);
}

TEST_CASE("Hard cases: contacts are held against all pairs", "[files]") {
  const std::string balls =
      "[run]\nduration = 0\nstep = 0.1\n[contact]\nkind = \"penalty\"\nstiffness = 1\n"
      "[[bodies]]\nname = \"balls\"\nshape = \"sphere\"\nmass = 1\nradius = [1, 1, 0.1]\n"
      "position = [[0, 0, 0], [1.5, 0, 0], [9, 0, 0]]\n[stress]\nwhat = \"x\"\nowed = [{}]\n"
      "compare = [\"brute_force\"]\n[[expect]]\nquantity = \"stress.pair_errors\"\nmax = 0\n";
  const auto results = results_of(balls);
  CHECK(results[0].held);
  // A wall that presses on one of them is a contact that no pair of bodies explains.
  const auto walled =
      results_of(balls + "[[boundaries]]\nshape = \"plane\"\npoint = [8.95, 0, 0]\nnormal = [1, 0, 0]\n");
  CHECK(walled[0].measures.at("pair_errors") > 0);
}

TEST_CASE("Hard cases: the verdict that decides is the first miss, else the one nearest its limit", "[files]") {
  const auto verdict = [](double measured, double most, bool met) {
    Verdict v;
    v.expectation.maximum = most;
    v.measured = measured;
    v.met = met;
    return v;
  };
  CHECK(decisive({}) == nullptr);
  CHECK(decisive({verdict(1, 10, true), verdict(9, 10, true), verdict(2, 10, true)})->measured == 9);
  CHECK(decisive({verdict(9, 10, true), verdict(11, 10, false), verdict(12, 10, false)})->measured == 11);
}

TEST_CASE("Hard cases: each of the catalogue has a leading comment, its file's name, a doc, and ways to run it",
          "[files]") {
  std::size_t cases = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BALLPARK_SCENARIOS_FOLDER "/stress")) {
    INFO(entry.path());
    const StressCase one(entry.path().string());
    CHECK(one.file().scene.name == entry.path().stem());
    CHECK_FALSE(one.file().scene.doc.empty());
    CHECK(contents(entry.path().string()).starts_with("# "));
    CHECK((one.cells() > 0) != !one.file().stress->waits_for.empty());
    ++cases;
  }
  CHECK(cases >= 20);
}
