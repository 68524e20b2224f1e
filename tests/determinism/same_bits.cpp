// One state hash for each scene and precision, however it is run.
#include "tests/catch.h"
#include "tests/determinism/scenarios.h"

using namespace scenarios;

namespace {

bool is_implicit(const Scene& scene) {
  const auto& rows = ballpark::integrators();
  return std::any_of(rows.begin(), rows.end(),
                     [&](const auto& row) { return row.implicit && row.name == scene.run.integrator; });
}

void check_all_ways(const Scene& scene, Precision precision, std::uint64_t steps) {
  std::vector<Options> all = ways(scene, precision);
  if (is_implicit(scene)) {  // slow, and without paths and targets
    steps = 2;
    all = {all[0], {.threads = 1, .precision = precision}, {.threads = 5, .precision = precision}};
  }
  const std::uint64_t expected = hash_after(scene, all[0], steps);
  CHECK(expected != hash_after(scene, all[0], 0));
  for (const Options& way : all) {
    CAPTURE(scene.name, scene.run.integrator, scene.run.compensated, text(way));
    CHECK(hash_after(scene, way, steps) == expected);
  }
}

/// Every scenario under every integrator.
void check_scenarios(Precision precision, bool compensated) {
  REQUIRE(files().size() >= 8);
  for (const std::string& file : files()) {
    Scene scene = small(file);
    scene.run.compensated = compensated;
    for (const std::string& integrator : integrators_for(scene)) {
      scene.run.integrator = integrator;
      check_all_ways(scene, precision, steps_of_many_runs(scene));
    }
  }
}

}  // namespace

TEST_CASE("Same bits: threads, targets, paths and runs, in double", "[bits]") {
  check_scenarios(Precision::double_, false);
}

TEST_CASE("Same bits: threads, targets, paths and runs, in single", "[bits]") {
  check_scenarios(Precision::single_, false);
}

TEST_CASE("Same bits: compensated, in double", "[bits]") {
  check_scenarios(Precision::double_, true);
}

TEST_CASE("Same bits: compensated, in single", "[bits]") {
  check_scenarios(Precision::single_, true);
}

TEST_CASE("Same bits: extended precision keeps them for threads and paths", "[bits]") {
  for (const std::string& file : files()) check_all_ways(small(file), Precision::extended, 3);
}

TEST_CASE("Same bits: the two precisions are not each other's", "[bits]") {
  for (const std::string& file : files()) {
    const Scene scene = small(file);
    CHECK(hash_after(scene, {.precision = Precision::single_}, 3) !=
          hash_after(scene, {.precision = Precision::double_}, 3));
  }
}

TEST_CASE("Same bits: whole runs of all scenarios", "[bits][long]") {
  for (const std::string& file : files()) {
    const Scene scene = whole(file);
    const auto steps = static_cast<std::uint64_t>(scene.run.duration / scene.run.step + 0.5);
    for (const Precision precision : {Precision::double_, Precision::single_}) {
      const std::uint64_t expected = hash_after(scene, {.threads = 1, .target = "base", .precision = precision}, steps);
      for (const int threads : {1, 2, 3, 5, 8}) {
        CAPTURE(file, threads);
        CHECK(hash_after(scene, {.threads = threads, .precision = precision}, steps) == expected);
      }
      for (const std::string& target : available_targets()) {
        CAPTURE(file, target);
        CHECK(hash_after(scene, {.threads = 2, .target = target, .precision = precision}, steps) == expected);
      }
    }
  }
}
