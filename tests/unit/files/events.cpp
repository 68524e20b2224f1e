// [[event]]: how a scene file asks for the times at which something happens, and what the run tells of them.
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace scene_texts;
using namespace ballpark::scenes;

namespace {

/// Thrown up at 20 m/s from 0 where g = 10 m/s^2: at the top after 2 s, back after 4 s.
std::string thrown(const std::string& pace) {
  return "[run]\nduration = 5\n" + pace +
         "[[bodies]]\nname = \"ball\"\nmass = 1\nposition = [0, 0, 0]\nvelocity = [1, 0, 20]\n"
         "[[effects]]\nkind = \"gravity\"\nacceleration = [0, 0, -10]\n";
}
const std::string fixed = "step = 0.03\n", adaptive = "tolerance = 1e-9\nintegrator = \"dormand_prince5\"\n";

std::string event(const std::string& name, const std::string& rest) {
  return "[[event]]\nname = \"" + name + "\"\n" + rest;
}
const std::string apex_and_landing = event("apex", "quantity = \"state.0.vz\"\ncrossing = \"falling\"\n") +
                                     event("landing", "quantity = \"state.0.z\"\ncrossing = \"falling\"\n");

RunReport run_text(const std::string& text, const RunHooks& hooks = {}) {
  return run(parse(text, "test.toml"), {}, hooks);
}

LocatedProblem problem_of(const std::string& lines) {
  const std::vector<LocatedProblem> problems = problems_of(drifting + lines);
  REQUIRE(problems.size() == 1);
  return problems.front();
}

LocatedProblem refused_by_run(const std::string& lines) {
  try {
    run_text(drifting + lines);
  } catch (const SceneFileError& error) {
    REQUIRE(error.problems().size() == 1);
    return error.problems().front();
  }
  FAIL("accepted: " + lines);
  return {};
}

}  // namespace

TEST_CASE("Events: what is left out, and what is wrong, with its place", "[files]") {
  const SceneFile file = parse(drifting + event("far-1", "quantity = \"state.0.x\"\n"), "test.toml");
  REQUIRE(file.events.size() == 1);
  CHECK(file.events[0].value == 0);
  CHECK(file.events[0].crossing == "any");
  const std::string x = "quantity = \"state.0.x\"\n";
  const LocatedProblem unknown = problem_of(event("a", x + "crosing = \"any\"\n"));
  CHECK(unknown.key == "event[0].crosing");
  CHECK(unknown.location.line == 12);
  CHECK(contains(unknown.message, "did you mean \"crossing\"?"));
  CHECK(contains(problem_of(event("a", x + "crossing = \"fallin\"\n")).message, "did you mean \"falling\"?"));
  CHECK(contains(problem_of(event("a b", x)).message, "expected a word"));
  CHECK(contains(problem_of(event("", x)).message, "expected a word"));
  CHECK(contains(problem_of(event("a", x + "value = inf\n")).message, "finite number"));
  CHECK(contains(problem_of("[[event]]\n" + x).message, "is missing"));
  const LocatedProblem twice = problem_of(event("a", x) + event("b", x) + event("a", x));
  CHECK(twice.key == "event[2].name");
  CHECK(twice.location.line == 16);
  CHECK(contains(twice.message, "\"a\" is the name of an earlier event"));
}

TEST_CASE("Events: quantities that are not of a body's state are refused before anything is run", "[files]") {
  const LocatedProblem problem = refused_by_run(event("a", "quantity = \"state.0.zz\"\n"));
  CHECK(problem.key == "event[0].quantity");
  CHECK(problem.location.line == 11);
  CHECK(contains(problem.message, "body 0 carries no zz, expected one of x, y, z, vx, vy, vz"));
  CHECK(contains(refused_by_run(event("a", "quantity = \"state.7.z\"\n")).message, "there is no body 7"));
  CHECK(contains(refused_by_run(event("a", "quantity = \"energy.final\"\n")).message, "expected state.ID.COLUMN"));
  const auto expecting = [](const std::string& quantity) {
    return refused_by_run(event("a", "quantity = \"state.0.x\"\n") + "[[expect]]\nquantity = \"" + quantity +
                          "\"\nmin = 0\n");
  };
  CHECK(contains(expecting("events.b.count").message, "there is no \"b\" in events, expected one of a"));
  CHECK(contains(expecting("events.a.times.1000").message, "expected a whole number below 1000"));
  CHECK(contains(expecting("events.a.times.first").message, "expected a whole number"));
  CHECK(contains(expecting("events.a.times").message, "is not a number"));
}

TEST_CASE("Events: the report has their times, to rounding where the method is exact", "[files]") {
  for (const std::string& pace : {fixed, adaptive}) {
    const RunReport report = run_text(thrown(pace) + apex_and_landing);
    REQUIRE(report.events.size() == 2);
    for (const EventTimes& one : report.events) {
      INFO(pace << one.name);
      CHECK(one.count == 1);  // z = 0 at the start is no landing
      REQUIRE(one.times.size() == 1);
      CHECK(std::abs(one.times[0] - (one.name == "apex" ? 2 : 4)) < 1e-13);
    }
    const nlohmann::json json = nlohmann::json::parse(to_json(report));
    CHECK(json.at("events").at("landing").at("count") == 1);
    CHECK(json.at("events").at("landing").at("times").at(0).get<double>() == report.events[1].times[0]);
  }
  CHECK(nlohmann::json::parse(to_json(run_text(drifting))).at("events").empty());
}

TEST_CASE("Events: either way of passing, at any value", "[files]") {
  const auto passing = [](const std::string& crossing) {
    return run_text(thrown(fixed) +
                    event("a", "quantity = \"state.0.z\"\nvalue = 15\ncrossing = \"" + crossing + "\"\n"))
        .events.at(0);
  };
  CHECK(passing("any").count == 2);
  REQUIRE(passing("rising").count == 1);
  REQUIRE(passing("falling").count == 1);
  CHECK(std::abs(passing("rising").times[0] - 1) < 1e-12);
  CHECK(std::abs(passing("falling").times[0] - 3) < 1e-12);
}

TEST_CASE("Events: they change no bit, nor when frames are written", "[files]") {
  for (const std::string& pace : {fixed, adaptive}) {
    const std::string text = thrown(pace) +
                             "[[effects]]\nkind = \"quadratic_drag\"\ncoefficient = 0.01\n"
                             "[[output]]\nevery = 0.27\nfile = \"a.csv\"\n";
    const auto run_noting = [&](const std::string& scene) {
      std::vector<double> seen;
      RunHooks hooks;
      hooks.progress = [](double) { return true; };
      hooks.writers = {[&](const ballpark::World& world) {
        seen.push_back(world.time());
        seen.push_back(world.body(0).position.z());
      }};
      const RunReport report = run_text(scene, hooks);
      return std::tuple(report.state_hash, report.counters.steps, report.counters.force_evaluations, seen);
    };
    CHECK(run_noting(text) == run_noting(text + apex_and_landing));
  }
}

TEST_CASE("Events: expectations read what happened until their time", "[files]") {
  const auto expect = [](const std::string& quantity, const std::string& at, const std::string& value) {
    return "[[expect]]\nquantity = \"" + quantity + "\"\nat = " + at + "\nvalue = " + value + "\ntolerance = 1e-13\n";
  };
  for (const std::string& pace : {fixed, adaptive}) {
    const RunReport report =
        run_text(thrown(pace) + apex_and_landing + expect("events.apex.count", "1.9", "0") +
                 expect("events.apex.count", "2.1", "1") + expect("events.apex.times.0", "2.1", "2") +
                 expect("events.landing.count", "3.99", "0") + expect("events.landing.times.0", "5", "4"));
    REQUIRE(report.verdicts.size() == 5);
    for (const Verdict& verdict : report.verdicts) {
      INFO(pace << verdict.sentence);
      CHECK(verdict.met);
    }
    const RunReport early = run_text(thrown(pace) + apex_and_landing + expect("events.apex.times.0", "1.9", "2"));
    CHECK_FALSE(early.verdicts.at(0).met);
  }
}

TEST_CASE("Events: all are counted, the first thousand are kept", "[files]") {
  const std::string swing =
      "[run]\nduration = 400\nstep = 0.05\nintegrator = \"velocity_verlet\"\n"
      "[[bodies]]\nname = \"a\"\nmass = 1\nposition = [1, 0, 0]\n"
      "[[effects]]\nkind = \"spring\"\nanchor = [0, 0, 0]\nstiffness = 100\n";
  const EventTimes passing = run_text(swing + event("pass", "quantity = \"state.0.x\"\n")).events.at(0);
  // omega' = (2/h) asin(omega h/2) for this method
  CHECK(passing.count == static_cast<std::uint64_t>(400 * (2 / 0.05 * std::asin(0.25)) / 3.14159265358979324 + 0.5));
  CHECK(passing.times.size() == most_event_times);
  CHECK(passing.last > passing.times.back());
}

TEST_CASE("Events: a run that is interrupted tells those until then", "[files]") {
  const std::string text = thrown("step = 1e-7\n") + event("early", "quantity = \"state.0.x\"\nvalue = 1e-6\n");
  RunHooks hooks;
  hooks.progress = [](double) { return false; };
  const RunReport report = run_text(text, hooks);
  CHECK(report.interrupted);
  CHECK(report.events.at(0).count == 1);
}
