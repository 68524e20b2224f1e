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
    {"brownian", 0x1fbd1a9020b2496, 0x20712ae78ab5052},
    {"charged_particle", 0x35456f4fbc95dd3, 0x39536eab7afd08a8},
    {"cluster", 0x302bf705dc28b40d, 0x44d9b3c60fc639f7},
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
    {"masse", 0x657cf52261b76594, 0xf156c717406dc460},
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
    {"turntable", 0x17a126b91c1b1bdb, 0x79b92e1a21fe293a},
};

/// Each integrator: the hashes of all scenarios one after the other, plain and compensated.
const Golden by_integrator[] = {
    {"euler", 0x7568f222800099ac, 0x8eabc061f607faf7},
    {"midpoint", 0x17d45a7b92d202cd, 0xbf27d340d31f089e},
    {"heun", 0x15087844adf40519, 0xc20b1e34ef02ba1e},
    {"ralston", 0xfdfe640b0a4992ae, 0x473c34df6f27b176},
    {"rk3", 0x4ebb624356f8ebe7, 0x686b3c421937ccf1},
    {"rk4", 0xa63a43d60fb13acc, 0x8140ae8f457ab46d},
    {"rk4_38", 0xa2219cc16b8e6d2b, 0x80db2ee10abb2d67},
    {"taylor2", 0x4dc9b2ad3a7699eb, 0x9e8d8f11ed8b0f2a},
    {"bogacki_shampine3", 0xf396657bee43e58d, 0xd95934fadf8a4d58},
    {"dormand_prince5", 0x43a23b6431eb5cdc, 0x54885c9c47a3a77b},
    {"tsitouras5", 0x796acecf4eee44fe, 0xf1e5b3b8feff9732},
    {"dormand_prince8", 0xe93422a57276f1f2, 0x16f8385a8bc50f95},
    {"gragg_bulirsch_stoer10", 0x5189240037ded5e7, 0x7f6de5140b44979d},
    {"semi_implicit_euler", 0xb95d15ad5050beea, 0x7b1ca1eab5f3b94c},
    {"velocity_verlet", 0xd5c20e713cb6da27, 0x62640f59dfa2f479},
    {"ruth3", 0x323e211ebeab63f6, 0xe44d029ac4587980},
    {"forest_ruth", 0xefbd5779da645e86, 0x9de23b2601a117ef},
    {"yoshida4", 0x466137a7cd0872a4, 0xce1d11637f110dbf},
    {"pefrl", 0xc05b76d527f0c98e, 0x67c938b3ff0e3224},
    {"yoshida6", 0x53bec7d34882e4fd, 0x563201ce4e4596d6},
    {"boris", 0x8d740e67afb602e5, 0xa337ccdc9baff12b},
    {"backward_euler", 0x18b254da0147abbe, 0xbaacd6032a3e730f},
    {"implicit_midpoint", 0xc5f7b35e1efc3906, 0x243ef83b0d68972a},
    {"gauss4", 0x65d9bfa24c426e6e, 0xc840fd7fccc86c3},
    {"ab2", 0xe1a9e59c7073c90c, 0x554f7de1825dc7fe},
    {"ab3", 0x4d6751a7b2fd8138, 0xebbb38e4fa65b7b0},
    {"ab4", 0x9db79e0d96b48826, 0x28090832994539d4},
    {"ab5", 0x9bfd604811e24e12, 0x9e7c4728dd8961a1},
    {"abm4", 0x962a203e58bcf206, 0x40bca89ca60b0f28},
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
