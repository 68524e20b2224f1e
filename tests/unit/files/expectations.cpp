// Verdicts on expectations, and quantities that do not exist.
#include <cmath>
#include <limits>

#include "scenarios/files/judge.h"
#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace scene_texts;
using ballpark::scenes::Expectation;
using ballpark::scenes::judged;
using ballpark::scenes::RunReport;

namespace {

Expectation between(std::optional<double> minimum, std::optional<double> maximum) {
  Expectation expectation;
  expectation.quantity = "time";
  expectation.minimum = minimum;
  expectation.maximum = maximum;
  return expectation;
}

Expectation about(double value, double tolerance) {
  Expectation expectation;
  expectation.quantity = "time";
  expectation.value = value;
  expectation.tolerance = tolerance;
  return expectation;
}

RunReport run_with(const std::string& expectation) {
  return ballpark::scenes::run(ballpark::scenes::parse(drifting + "[[expect]]\n" + expectation, "test.toml"));
}

LocatedProblem refused(const std::string& quantity) {
  try {
    run_with("quantity = \"" + quantity + "\"\nmin = 0\n");
  } catch (const ballpark::scenes::SceneFileError& error) {
    REQUIRE(error.problems().size() == 1);
    return error.problems().front();
  }
  FAIL("accepted: " + quantity);
  return {};
}

}  // namespace

TEST_CASE("Expectations: bounds are inclusive, tolerances absolute", "[files]") {
  CHECK(judged(between(1, 2), 1, 0).met);
  CHECK(judged(between(1, 2), 2, 0).met);
  CHECK_FALSE(judged(between(1, 2), 2.1, 0).met);
  CHECK_FALSE(judged(between(1, {}), 0.9, 0).met);
  CHECK(judged(between(1, {}), 1e9, 0).met);
  CHECK_FALSE(judged(between({}, 2), 2.1, 0).met);
  CHECK(judged(about(10, 0.5), 10.5, 0).met);
  CHECK(judged(about(-10, 0), -10, 0).met);
  CHECK_FALSE(judged(about(10, 0.5), 10.6, 0).met);
  CHECK_FALSE(judged(about(10, 0.5), 9.4, 0).met);
}

TEST_CASE("Expectations: what is not finite is never met", "[files]") {
  for (const double measured : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_FALSE(judged(between(0, {}), measured, 0).met);
    CHECK_FALSE(judged(between({}, 1), measured, 0).met);
    CHECK_FALSE(judged(about(0, 1e300), measured, 0).met);
  }
  CHECK_FALSE(judged(between({}, 1), -std::numeric_limits<double>::infinity(), 0).met);
}

TEST_CASE("Expectations: the sentence has the numbers", "[files]") {
  const std::string missed = judged(about(10, 0.5), 11, 2).sentence;
  for (const char* part : {"time = 11", "at 2 s", "10 within 0.5", "off by 1", "not met"})
    CHECK(contains(missed, part));
  CHECK(contains(judged(between(1, 2), 1.5, 0).sentence, "expected 1 to 2: met"));
  CHECK(contains(judged(between(1, {}), 1.5, 0).sentence, "expected at least 1: met"));
}

TEST_CASE("Expectations: states and numbers of the report are measured", "[files]") {
  const RunReport at_end = run_with("quantity = \"state.0.x\"\nvalue = 2.0\ntolerance = 1e-12\n");
  REQUIRE(at_end.verdicts.size() == 1);
  CHECK(at_end.verdicts[0].met);
  CHECK(at_end.verdicts[0].time == 1.0);
  const RunReport on_the_way = run_with("quantity = \"state.0.x\"\nat = 0.52\nvalue = 1.5\ntolerance = 1e-12\n");
  CHECK(on_the_way.verdicts[0].met);
  CHECK(std::abs(on_the_way.verdicts[0].time - 0.5) < 1e-12);
  const RunReport energy = run_with("quantity = \"energy.final\"\nat = 0.3\nvalue = 1.0\ntolerance = 1e-12\n");
  CHECK(energy.verdicts[0].met);
  CHECK(run_with("quantity = \"steps\"\nat = 0.3\nvalue = 3\ntolerance = 0\n").verdicts[0].met);
  CHECK(run_with("quantity = \"bodies\"\nvalue = 1\ntolerance = 0\n").verdicts[0].met);
  CHECK_FALSE(run_with("quantity = \"state.0.vx\"\nmin = 2\n").verdicts[0].met);
}

TEST_CASE("Expectations: no value is not a value in bounds", "[files]") {
  CHECK_FALSE(run_with("quantity = \"status.time\"\nmin = -1\n").verdicts[0].met);
}

TEST_CASE("Expectations: quantities that do not exist are refused before anything is run", "[files]") {
  const LocatedProblem problem = refused("energy.drift");
  CHECK(problem.key == "expect[0].quantity");
  CHECK(problem.location.line == 10);
  CHECK(problem.location.column == 12);
  CHECK(contains(problem.message, "there is no \"drift\" in energy, expected one of initial, final, drift_relative"));
  CHECK(contains(refused("enrgy.final").message, "did you mean \"energy\"?"));
  CHECK(contains(refused("energy").message, "has parts, expected one of initial"));
  CHECK(contains(refused("status.code").message, "is not a number"));
  CHECK(contains(refused("warnings").message, "is not a number"));
  CHECK(contains(refused("warnings.0").message, "there is no \"0\""));
  CHECK(contains(refused("state.1.x").message, "there is no body 1, expected an id below 1"));
  CHECK(contains(refused("state.0.q").message, "body 0 carries no q, expected one of x, y, z, vx, vy, vz"));
  CHECK(contains(refused("state.0.qw").message, "carries no qw"));
  CHECK(contains(refused("state.-1.x").message, "state.ID.COLUMN"));
  CHECK(contains(refused("state.0").message, "state.ID.COLUMN"));
  CHECK(contains(refused("").message, "there is no \"\""));
}
