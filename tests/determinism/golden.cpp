// The bits of each scenario, written down: every compiler, build type, machine and back end must give them. A change
// that is meant to change bits replaces the rows by those that the failing test prints.
#include <fmt/format.h>

#include "tests/catch.h"
#include "tests/determinism/scenarios.h"

using namespace scenarios;

namespace {

struct Golden {
  const char* name;
  std::uint64_t in_double, in_single;
};

/// Each scenario as it is (cut to some thousand bodies), after some steps of its own integrator.
const Golden by_scenario[] = {
    {"dice", 0x71f4ec80280e3e37, 0x9eb139c46818ddb5},         {"dust", 0x2f8e5cd459de4774, 0x4ef89d678f17d05b},
    {"kepler", 0x73978e3d3c7f362a, 0x4477d9b5814c7a60},       {"oscillator", 0xe7a7f42286f60abc, 0x9b1744f86ce822ef},
    {"pendulum", 0x4165e83bf79c055, 0x1a7e04db86f96a5e},      {"projectile", 0xbaab5138ebd9555e, 0xeff334dabdcea01a},
    {"spinning_top", 0xedc6d71584fd9030, 0xe166e91cb47dfbbf}, {"tumbling", 0x695f6e1be060c2d, 0x8abbf4973233c7fa},
};

/// Each integrator: the hashes of all scenarios one after the other, plain and compensated.
const Golden by_integrator[] = {
    {"euler", 0x6729b78eeb7956c8, 0x3fdfa0ee81b49252},
    {"midpoint", 0xdea645f45638b391, 0x7dbeab1f9f9117bd},
    {"heun", 0x9e01d3a7d5c57957, 0x76e4648ef1c09234},
    {"rk4", 0xe61bd06d9e830639, 0xb9e5efaec2d2cb9b},
    {"taylor2", 0x911c2ca82c51318b, 0x2b51ea1e267ca847},
    {"semi_implicit_euler", 0xa1adac0a9ad980e2, 0x2a783f78d5e3f04a},
    {"velocity_verlet", 0x16e5db931420af43, 0x3dc7d3c692156270},
};

std::string row(const Golden& golden) {
  return fmt::format("{{\"{}\", {:#x}, {:#x}}},", golden.name, golden.in_double, golden.in_single);
}

std::uint64_t scenario_hash(const Scene& scene, Precision precision) {
  return hash_after(scene, {.precision = precision}, some_steps(scene));
}

std::uint64_t integrator_hash(const std::string& integrator, Precision precision) {
  std::uint64_t sum = 0;
  for (const std::string& file : files()) {
    Scene scene = small(file);
    scene.run.integrator = integrator;
    for (const bool compensated : {false, true}) {
      scene.run.compensated = compensated;
      sum = sum * 0x9E3779B97F4A7C15 + scenario_hash(scene, precision);
    }
  }
  return sum;
}

/// The table must hold exactly this row under the name.
template <std::size_t n>
void check_row(const Golden (&table)[n], const Golden& found) {
  std::string expected = "no row of this name";
  for (const Golden& golden : table) {
    if (std::string(golden.name) == found.name) expected = row(golden);
  }
  CHECK(row(found) == expected);
}

}  // namespace

TEST_CASE("Golden bits: every scenario, in both precisions", "[bits]") {
  CHECK(files().size() == std::size(by_scenario));
  for (const std::string& file : files()) {
    const Scene scene = small(file);
    check_row(by_scenario,
              {scene.name.c_str(), scenario_hash(scene, Precision::double_), scenario_hash(scene, Precision::single_)});
  }
}

TEST_CASE("Golden bits: every integrator on all scenarios, plain and compensated", "[bits]") {
  CHECK(ballpark::integrators().size() == std::size(by_integrator));
  for (const ballpark::IntegratorDescription& integrator : ballpark::integrators()) {
    check_row(by_integrator, {integrator.name.c_str(), integrator_hash(integrator.name, Precision::double_),
                              integrator_hash(integrator.name, Precision::single_)});
  }
}
