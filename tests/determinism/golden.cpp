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
    {"ball_rain", 0x49c5c56cb88d25c1, 0xae562b01f67cb75},
    {"bounce", 0xf5a41a433bf9cd63, 0x7166db590d0f29bb},
    {"break", 0x7ca3b65b1c024d4b, 0xa3c6a62ac21e2b06},
    {"charged_particle", 0x35456f4fbc95dd3, 0x39536eab7afd08a8},
    {"comet", 0x615fb364fa61f065, 0x9c124f28ebfc925},
    {"crystal", 0xa705212484aacaf0, 0x4f4433bec4deac72},
    {"curveball", 0xcc8e93b1ed322e16, 0x88014ccc70fd3b0f},
    {"dice", 0x71f4ec80280e3e37, 0x9eb139c46818ddb5},
    {"dust", 0x2f8e5cd459de4774, 0x4ef89d678f17d05b},
    {"figure_eight", 0x71a9dec48ea4cb31, 0xef685bf4d7d4debf},
    {"foucault", 0xd6247b9d4fdc48d8, 0x25cd8cbf9179e9c1},
    {"free_kick", 0x854d49904bf63adb, 0x604fb5fb1c72c21f},
    {"free_top", 0xa238c7e32b2fceb8, 0xea7e5d28f9ffc315},
    {"gas", 0xd8c0dfa33efaf71d, 0x913e75a981bf72e4},
    {"incline", 0x2047add4ad3fb515, 0x451575590fd82201},
    {"kepler", 0x73978e3d3c7f362a, 0x4477d9b5814c7a60},
    {"newton_cradle", 0xb9c2a58a2c13f85, 0xc95439777ca477d6},
    {"oscillator", 0xe7a7f42286f60abc, 0x9b1744f86ce822ef},
    {"overdamped", 0x5ab73f423e1f16d3, 0xda0ea8e3806ef6d2},
    {"pendulum", 0x4165e83bf79c055, 0x1a7e04db86f96a5e},
    {"pleiades", 0x318543b27b7ab2d3, 0xbd1264d878bb42f7},
    {"projectile", 0xbaab5138ebd9555e, 0xeff334dabdcea01a},
    {"shaken_bed", 0x36c694e1ed261513, 0x1e6099c2a2308c8c},
    {"sinking_beads", 0xfd25f24f6a7144ac, 0xe01d898d34eaa9f4},
    {"slingshot", 0x18dcefb236c1cdda, 0x6b072766e195b6c0},
    {"spinning_top", 0xedc6d71584fd9030, 0xe166e91cb47dfbbf},
    {"stack", 0xd379e1fa61942df7, 0x59d9719bdc8401d8},
    {"swing", 0x780a311a98d1db8, 0xde0b816907cdaf99},
    {"terminal_velocity", 0xdde19bb03a7869dd, 0x1479a403a392c09d},
    {"tumbling", 0x695f6e1be060c2d, 0x8abbf4973233c7fa},
};

/// Each integrator: the hashes of all scenarios one after the other, plain and compensated.
const Golden by_integrator[] = {
    {"euler", 0x5225a566ab90ceed, 0x7d4765fb61e0d72b},
    {"midpoint", 0x30995204abc4df9, 0x9b87c6e2e8413cf3},
    {"heun", 0x45e8353db35319af, 0xeca1570cd61e9057},
    {"ralston", 0x3537ad8ab8c0df7e, 0x6ef22a8c804817f9},
    {"rk3", 0xdf21a09a61fde27f, 0x1c2ac0b397d0d61a},
    {"rk4", 0xeed38e56a17c0ca9, 0x83370b7b3cbf40d6},
    {"rk4_38", 0xbc35ab7a2def83eb, 0xb64f7f4c97af6804},
    {"taylor2", 0x5ac01dc708f09b57, 0xf0515835f136b055},
    {"bogacki_shampine3", 0x30880906c641f731, 0x9af2eb01c927c52c},
    {"dormand_prince5", 0xeca36c4f04ebc995, 0x6e352307ebe95cb9},
    {"tsitouras5", 0x5199b0e487c8cb18, 0x257e1f822bea90d6},
    {"dormand_prince8", 0xdc7413605e2ffe20, 0x8825bdeb60ebcaeb},
    {"gragg_bulirsch_stoer10", 0xdd7198fda6bd5be6, 0x3ad6e3e0c55c173d},
    {"semi_implicit_euler", 0x53148ef84a810773, 0x5684d43716040462},
    {"velocity_verlet", 0xecdb410e43335eb3, 0xcebe54f7efb6d678},
    {"ruth3", 0x42a22ad83757e93a, 0x66f2d665c11ca6ac},
    {"forest_ruth", 0xc24495fbe07399e5, 0x9db62364fa6a9788},
    {"yoshida4", 0x3b7af1d23c94a88c, 0xbabbb1033cd95c63},
    {"pefrl", 0x1a5daf0cc911d818, 0x2a6c6f4d280a364d},
    {"yoshida6", 0x92440659e371e83b, 0xb66b309977458d58},
    {"boris", 0x4f31e928193e4494, 0x7386617a9e392c7e},
    {"backward_euler", 0x9b446277b7acaed7, 0xa362fe2b38c99e00},
    {"implicit_midpoint", 0xca7478dc8cdcea59, 0x1ea37571bbd38485},
    {"gauss4", 0x46bed559fc871047, 0x4bf63ab14da4d24c},
    {"ab2", 0x1e3cbd2503c738af, 0x58a011ee5a6f1212},
    {"ab3", 0x1bc37658a1af782d, 0x43c46f651c1d522d},
    {"ab4", 0x815c19aa9ee54f88, 0x889feff440c3527},
    {"ab5", 0x420ececad0da5f1f, 0x5b2128b1cef16fc6},
    {"abm4", 0x678589776234aec5, 0x2f0671141796ef52},
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
    if (!ballpark::tests::accepts(scene, integrator)) continue;
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
