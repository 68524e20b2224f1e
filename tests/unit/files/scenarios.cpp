// The scenarios that come with the project: all load, say what they show, and meet their expectations.
#include <filesystem>

#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace scene_texts;

namespace {

std::vector<std::filesystem::path> scenario_paths() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(BALLPARK_SCENARIOS_FOLDER)) {
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  }
  return paths;
}

/// Sanitizers take many times as long: a thousand balls rain then.
#ifdef BALLPARK_SANITIZE
constexpr bool slow = true;
#else
constexpr bool slow = false;
#endif
std::vector<ballpark::scenes::Override> overrides_of(const std::filesystem::path& path) {
  if (slow && path.stem() == "ball_rain") return {{"bodies.balls.generate.count", "[10, 10, 10]"}};
  return {};
}

}  // namespace

TEST_CASE("Scenarios: each has a leading comment, its file's name, a doc and expectations", "[files]") {
  CHECK(scenario_paths().size() >= 8);
  for (const std::filesystem::path& path : scenario_paths()) {
    INFO(path);
    const auto file = ballpark::scenes::load(path.string());
    CHECK(file.scene.name == path.stem());
    CHECK_FALSE(file.scene.doc.empty());
    CHECK_FALSE(file.expectations.empty());
    CHECK(contents(path.string()).starts_with("# "));
  }
}

TEST_CASE("Scenarios: each meets its expectations", "[files]") {
  for (const std::filesystem::path& path : scenario_paths()) {
    const auto report = ballpark::scenes::run(ballpark::scenes::load(path.string(), overrides_of(path)));
    CHECK(report.status.code == ballpark::Status::Code::ok);
    for (const auto& verdict : report.verdicts) {
      INFO(path.stem() << ": " << verdict.sentence);
      CHECK(verdict.met);
    }
  }
}
