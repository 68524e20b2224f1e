// run(): what it reports, when it writes, what it warns of; and its JSON.
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "scenarios/files/timetable.h"
#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace scene_texts;
using namespace ballpark::scenes;
using ballpark::World;

namespace {

bool close(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max({1.0, std::abs(a), std::abs(b)});
}

RunReport run_text(const std::string& text, const RunHooks& hooks = {}) {
  return run(parse(text, "test.toml"), {}, hooks);
}

std::vector<double> all_of(Occasions occasions) {
  std::vector<double> places;
  for (; occasions.next(); occasions.pass()) places.push_back(*occasions.next());
  return places;
}

Pace in_steps(double duration, double step) {
  return Pace({.duration = duration, .step = step});
}

}  // namespace

TEST_CASE("Runs: the report has the run's numbers", "[files]") {
  const RunReport report = run_text("name = \"drift\"\n" + drifting);
  CHECK(report.scenario == "drift");
  CHECK(report.status.code == ballpark::Status::Code::ok);
  CHECK(report.bodies == 1);
  CHECK(close(report.time, 1.0));
  CHECK(report.counters.steps == 10);
  CHECK(report.counters.force_evaluations == 40);
  CHECK(report.integrator == "rk4");
  CHECK(report.step == 0.1);
  CHECK(report.precision == "double");
  CHECK(report.path == "fused");
  CHECK(report.state_hash.size() == 16);
  CHECK(close(report.initial.kinetic, 1.0));
  CHECK(report.energy_drift_relative == 0);
  CHECK(report.momentum_drift == 0);
  CHECK(report.wall_seconds > 0);
  CHECK(close(report.body_steps_per_second * report.wall_seconds, 10));
  CHECK(report.warnings.empty());
  CHECK_FALSE(report.interrupted);
}

TEST_CASE("Runs: drifts are relative to what there is", "[files]") {
  const std::string falling = drifting + "[[effects]]\nkind = \"gravity\"\nacceleration = [0.0, 0.0, -10.0]\n";
  const RunReport fall = run_text(falling);
  CHECK(close(fall.momentum_drift, 20.0 / std::hypot(2.0, 20.0)));
  CHECK(std::abs(fall.energy_drift_relative) < 1e-14);
  const RunReport slowed = run_text(drifting + "[[effects]]\nkind = \"linear_drag\"\ncoefficient = 2.0\n");
  CHECK(std::abs(slowed.energy_drift_relative - (std::exp(-2.0) - 1)) < 1e-5);
  const RunReport nothing = run_text(run_table);
  CHECK(nothing.bodies == 0);
  CHECK(nothing.energy_drift_relative == 0);
  CHECK(nothing.angular_momentum_drift == 0);
  CHECK(nothing.body_steps_per_second == 0);
}

TEST_CASE("Runs: outputs are written at the steps nearest to their times", "[files]") {
  std::vector<double> periodic, listed;
  const RunHooks hooks{.progress = {},
                       .writers = {[&](const World& world) { periodic.push_back(world.body(0).position.x()); },
                                   [&](const World& world) { listed.push_back(world.time()); }}};
  run_text(
      drifting +
          "[[output]]\nevery = 0.25\nfile = \"a.csv\"\n[[output]]\nat = [0.84, 0.0, 1.0, 0.79]\nfile = \"b.npz\"\n",
      hooks);
  REQUIRE(periodic.size() == 5);
  const double expected_x[] = {1.0, 1.3, 1.5, 1.8, 2.0};
  for (std::size_t i = 0; i < 5; ++i) CHECK(close(periodic[i], expected_x[i]));
  REQUIRE(listed.size() == 3);
  const double expected_times[] = {0.0, 0.8, 1.0};
  for (std::size_t i = 0; i < 3; ++i) CHECK(close(listed[i], expected_times[i]));
}

TEST_CASE("Runs: what is not as asked is warned of", "[files]") {
  const std::string text = "[run]\nduration = 1.0\nstep = 0.3\n[[output]]\nevery = 0.1\nfile = \"a.csv\"\n";
  int frames = 0;
  const RunReport report = run_text(text, {.progress = {}, .writers = {[&](const World&) { ++frames; }}});
  CHECK(report.counters.steps == 3);
  REQUIRE(report.warnings.size() == 2);
  CHECK(contains(report.warnings[0], "not a whole number of steps"));
  CHECK(contains(report.warnings[0], "the last 0.1 s"));
  CHECK(contains(report.warnings[1], "output[0].every"));
  CHECK(frames == 4);
}

TEST_CASE("Runs: a body that leaves the numbers is told of, and the run ends as planned", "[files]") {
  const std::string text =
      "[run]\nduration = 400.0\nstep = 1.0\nintegrator = \"euler\"\naccept = [\"stability\"]\n[[bodies]]\nname = "
      "\"a\"\nmass = 1.0\nposition = [[1e-300, 0, 0], [1e300, 0, 0]]\n[[effects]]\nkind = \"spring\"\nanchor = [0, 0, "
      "0]\nstiffness = 100.0\n[[expect]]\nquantity = \"state.1.x\"\nmin = -1e308\n";
  const RunReport report = run_text(text);
  CHECK(report.status.code == ballpark::Status::Code::non_finite);
  CHECK(report.status.body == 1);
  CHECK(report.counters.steps == 400);
  CHECK(report.final.non_finite_bodies >= 1);
  CHECK_FALSE(report.verdicts.at(0).met);
  CHECK(contains(report.warnings.back(), "not finite"));
  const nlohmann::json json = nlohmann::json::parse(to_json(report));
  CHECK(json.at("expectations").at(0).at("measured").is_null());
  CHECK(json.at("status").at("code") == "non_finite");
  CHECK(json.at("status").at("body") == 1);
}

TEST_CASE("Runs: progress can interrupt", "[files]") {
  const std::string text =
      "[run]\nduration = 1e9\nstep = 1e-3\n[[bodies]]\nname = \"a\"\nmass = 1.0\nposition = [0, 0, 0]\n"
      "[[expect]]\nquantity = \"state.0.x\"\nmin = 0\n";
  int calls = 0;
  std::vector<double> fractions;
  const RunHooks hooks{.progress =
                           [&](double fraction) {
                             fractions.push_back(fraction);
                             return ++calls < 2;
                           },
                       .writers = {}};
  const RunReport report = run_text(text, hooks);
  CHECK(report.interrupted);
  CHECK(calls == 2);
  CHECK(fractions[0] > 0);
  CHECK(fractions[1] > fractions[0]);
  CHECK(fractions[1] < 1);
  CHECK(report.wall_seconds >= 0.2);
  CHECK_FALSE(report.verdicts.at(0).met);
  CHECK(contains(report.verdicts.at(0).sentence, "ended before"));
}

TEST_CASE("Runs: progress and occasions change no bit", "[files]") {
  const std::string text = drifting + "[[effects]]\nkind = \"gravity\"\n";
  const RunHooks hooks{.progress = [](double) { return true; }, .writers = {[](const World&) {}}};
  CHECK(run_text(text).state_hash == run_text(text + "[[output]]\nevery = 0.3\nfile = \"a.csv\"\n", hooks).state_hash);
}

TEST_CASE("Runs: the JSON has every key, and numbers that can be read back", "[files]") {
  const RunReport report = run_text(drifting + "[[expect]]\nquantity = \"time\"\nmin = 0.5\n");
  const nlohmann::json json = nlohmann::json::parse(to_json(report));
  for (const char* key : {"format",
                          "scenario",
                          "status",
                          "bodies",
                          "time",
                          "steps",
                          "rejected_steps",
                          "force_evaluations",
                          "pairs",
                          "contacts",
                          "peak_pairs",
                          "peak_contacts",
                          "max_penetration",
                          "impacts",
                          "solver",
                          "contact",
                          "integrator",
                          "step",
                          "wall_seconds",
                          "body_steps_per_second",
                          "threads",
                          "precision",
                          "target",
                          "path",
                          "state_hash",
                          "energy",
                          "momentum",
                          "angular_momentum",
                          "present_bodies",
                          "entered_bodies",
                          "left_bodies",
                          "non_finite_bodies",
                          "bodies_outside",
                          "newton_iterations",
                          "newton_residual",
                          "events",
                          "warnings",
                          "expectations"}) {
    CHECK(json.contains(key));
  }
  CHECK(json.size() == 40);
  CHECK(json["ledger"].is_null());
  CHECK(json.at("status").at("code") == "ok");
  CHECK(json.at("status").at("body").is_null());
  CHECK(json.at("time").get<double>() == report.time);
  CHECK(json.at("energy").at("initial").get<double>() == report.initial.energy());
  CHECK(json.at("energy").contains("drift_relative"));
  CHECK(json.at("momentum").at("drift") == 0);
  CHECK(json.at("expectations").at(0).at("met") == true);
  CHECK(json.at("expectations").at(0).at("max").is_null());
}

TEST_CASE("Timetable: whole steps of a duration", "[files]") {
  CHECK(in_steps(1.0, 0.1).end() == 10);
  CHECK(in_steps(0.3, 0.1).end() == 3);
  CHECK(in_steps(0.3, 0.1).remainder() == 0);
  CHECK(in_steps(1e6, 1e-3).end() == 1000000000);
  CHECK(in_steps(1.0, 0.3).end() == 3);
  CHECK(close(in_steps(1.0, 0.3).remainder(), 0.1));
  CHECK(in_steps(0.0, 0.1).end() == 0);
  CHECK(in_steps(0.05, 0.1).end() == 0);
  CHECK(in_steps(1.0, 0.1).at(0.26) == 3);
  CHECK(in_steps(1.0, 0.3).at(1.0) == 3);
}

TEST_CASE("Timetable: occasions ascend and do not repeat", "[files]") {
  CHECK(all_of(Occasions({5, 1, 5, 0})) == std::vector<double>{0, 1, 5});
  CHECK(all_of(Occasions(std::vector<double>{})).empty());
  CHECK(all_of(Occasions(2.5, in_steps(10, 1))) == std::vector<double>{0, 3, 5, 8, 10});
  CHECK(all_of(Occasions(0.25, in_steps(3, 1))) == std::vector<double>{0, 1, 2, 3});
  CHECK(all_of(Occasions(7.0, in_steps(3, 1))) == std::vector<double>{0});
}

TEST_CASE("Timetable: with a tolerance, times as they are given", "[files]") {
  const Pace pace({.duration = 1, .tolerance = 1e-6});
  CHECK_FALSE(pace.by_steps());
  CHECK(pace.end() == 1);
  CHECK(pace.at(0.26) == 0.26);
  CHECK(pace.at(3) == 1);
  CHECK(pace.remainder() == 0);
  CHECK(all_of(Occasions(0.25, pace)) == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
  CHECK(all_of(Occasions(0.1, pace)).size() == 11);  // 10 * 0.1 is the end, whatever rounding makes of it
}

TEST_CASE("Runs: with a tolerance, outputs and expectations have their very times", "[files]") {
  std::vector<double> times;
  RunHooks hooks;
  hooks.writers = {[&](const ballpark::World& world) { times.push_back(world.time()); }};
  const std::string text =
      "[run]\nduration = 2\ntolerance = 1e-9\nintegrator = \"tsitouras5\"\n"
      "[[bodies]]\nname = \"p\"\nmass = 1\nposition = [[1, 0, 0]]\n"
      "[[effects]]\nkind = \"spring\"\nanchor = [0, 0, 0]\nstiffness = 1\n"
      "[[output]]\nevery = 0.5\nfile = \"x.csv\"\n"
      "[[expect]]\nquantity = \"state.0.x\"\nat = 1.25\nvalue = 0.31532236239526867\ntolerance = 1e-7\n"
      "[[expect]]\nquantity = \"state.0.x\"\nvalue = -0.4161468365471424\ntolerance = 1e-7\n"
      "[[expect]]\nquantity = \"step\"\nmax = 0\n";
  const RunReport without_progress = run_text(text.substr(0, text.rfind("[[expect]]")), hooks);
  CHECK(times == std::vector<double>{0, 0.5, 1, 1.5, 2});
  for (const auto& verdict : without_progress.verdicts) {
    CAPTURE(verdict.sentence);
    CHECK(verdict.met);
  }
  CHECK(without_progress.tolerance == 1e-9);
  CHECK(without_progress.time == 2);
  hooks.progress = [](double) { return true; };
  CHECK(run_text(text.substr(0, text.rfind("[[expect]]")), hooks).state_hash == without_progress.state_hash);
  const RunReport unseen = run_text(text.substr(0, text.find("[[output]]")));
  CHECK(unseen.state_hash == without_progress.state_hash);
  CHECK(unseen.counters.steps == without_progress.counters.steps);
}
