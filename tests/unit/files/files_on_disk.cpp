// Files that are not there, are no text, or are too much; and what TOML itself refuses.
#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace scene_texts;

namespace {

LocatedProblem load_problem(const std::string& path) {
  try {
    ballpark::scenes::load(path);
  } catch (const ballpark::scenes::SceneFileError& error) {
    REQUIRE(error.problems().size() == 1);
    return error.problems().front();
  }
  FAIL("accepted: " + path);
  return {};
}

}  // namespace

TEST_CASE("Scene files: not there, a folder, empty, or binary", "[files]") {
  const ScratchFolder folder;
  const LocatedProblem absent = load_problem(folder.file("nowhere.toml"));
  CHECK(absent.location.file == folder.file("nowhere.toml"));
  CHECK(absent.location.line == 0);
  CHECK(absent.message == "no such file");
  CHECK(contains(load_problem(folder.file("")).message, "is a directory"));
  CHECK(load_problem(written(folder, "empty.toml", "")).key == "run");
  const LocatedProblem binary =
      load_problem(written(folder, "binary.toml", std::string("\x7f\x45LF\x02\x01\0\0\xff\xfe", 10)));
  CHECK(binary.location.line == 1);
  CHECK(contains(load_problem("/dev/zero").message, "larger than"));
}

TEST_CASE("Scene files: what TOML refuses has a line and a column", "[files]") {
  const auto at = [](const std::string& text) {
    const std::vector<LocatedProblem> problems = problems_of(text);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].key.empty());
    CHECK_FALSE(problems[0].message.empty());
    return std::to_string(problems[0].location.line) + ":" + std::to_string(problems[0].location.column);
  };
  CHECK(at("[run]\nduration = \n") == "2:12");
  CHECK(at("[=]") == "1:2");
  CHECK(at("[[=]]") == "1:3");
  CHECK(at("[run]\nstep = 1\nstep = 2\n").substr(0, 2) == "3:");
  CHECK(at("[run]\nstep = 1.2.3\n").substr(0, 2) == "2:");
  CHECK(at("a = \"open\n").substr(0, 2) == "1:");
  CHECK_FALSE(at("a = " + std::string(100000, '[')).empty());
}

TEST_CASE("Scene files: the message has a line for each problem", "[files]") {
  try {
    ballpark::scenes::parse("[run]\nduration = 1\nstp = 1\nx = 1\n", "a.toml");
    FAIL("accepted");
  } catch (const ballpark::scenes::SceneFileError& error) {
    const std::string text = error.what();
    CHECK(contains(text, "a.toml:1:1: run.step: is not given"));
    CHECK(contains(text, "\na.toml:3:1: run.stp: is an unknown key, expected one of duration, step,"));
    CHECK(contains(text, "did you mean \"step\"?\na.toml:4:1: run.x: "));
  }
}

TEST_CASE("Scene files: control codes of a file do not reach the message", "[files]") {
  const auto problems = problems_of("\"a\\u001b[31m\" = 1\n" + run_table);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].key == "a?[31m");
}

TEST_CASE("Scene files: every key and value has its place", "[files]") {
  const auto file = ballpark::scenes::parse(drifting + "[[expect]]\nquantity = \"time\"\n  min = 0.5\n", "test.toml");
  CHECK(file.locations.at("run.step").line == 3);
  CHECK(file.locations.at("run.step").column == 8);
  CHECK(file.locations.at("bodies[0]").line == 4);
  CHECK(file.locations.at("bodies[0].velocity").column == 12);
  CHECK(file.locations.at("expect[0].min").line == 11);
  CHECK(file.locations.at("expect[0].min").column == 9);
  CHECK(file.locations.at("expect[0].min").file == "test.toml");
}
