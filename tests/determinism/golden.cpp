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
    {"euler", 0x511896ce8887c687, 0x29d8202ef11823ad},
    {"midpoint", 0x3b295795f8647dc7, 0xdbb6adb9bac43acd},
    {"heun", 0xadfdd934311d4c19, 0xcda92f7f57456341},
    {"ralston", 0xe26aca660bfcf37e, 0xdd66b1c9f4f7c773},
    {"rk3", 0x6e98f5927bac9d10, 0xbb0904bf47b29700},
    {"rk4", 0xae9ae2a25c6f84d1, 0x7e4d11b8995eacc8},
    {"rk4_38", 0xc664086a652e15a1, 0xe0b5e606f3ef654b},
    {"taylor2", 0x5ac01dc708f09b57, 0xf0515835f136b055},
    {"bogacki_shampine3", 0xa09e0050c8756ce, 0xd0246d3d2c63ec25},
    {"dormand_prince5", 0xe30b4549b2d309e6, 0xf865a523d0af11f8},
    {"tsitouras5", 0xb162a502979550, 0xe6eb7daeb1981de7},
    {"dormand_prince8", 0x3c2e774ce324100, 0x614906eee5d017e5},
    {"gragg_bulirsch_stoer10", 0x590c32ed0267e23e, 0x3fa2a7ea59323805},
    {"semi_implicit_euler", 0x2eadcd65610a50, 0xd0b2c002e4e3838c},
    {"velocity_verlet", 0x4629977fc8f4090c, 0x4a9c0e0b1390bda3},
    {"ruth3", 0xe125ac82ec871ea2, 0x377d0124e72ee5d4},
    {"forest_ruth", 0x99f0afee5bbf45d7, 0xa72a3e329a650bed},
    {"yoshida4", 0x29ad8d466f46dd7, 0x49654e12d88f30fa},
    {"pefrl", 0x89e8766a05c8c6f2, 0x6ce9fd9e6111a7f2},
    {"yoshida6", 0x508dc8b6a0d038d2, 0x708f49030af2bb42},
    {"boris", 0xc3f0fadf7af44838, 0xd12551b1be863220},
    {"backward_euler", 0x4a63ddf8afb3600, 0x8bdb8879c2696f0},
    {"implicit_midpoint", 0x5dd08636e68204d1, 0x5c764019ff49855a},
    {"gauss4", 0x8899fb7ae9c3fe36, 0x92b91037e008277b},
    {"ab2", 0x3b44bc2048c67e77, 0x58cd18152cd4d92a},
    {"ab3", 0xff956fdf35a33f0a, 0x92f2af0926588def},
    {"ab4", 0xc0ff5ab8783ed138, 0xf0a240197312d3e9},
    {"ab5", 0x308e6e04bc8a601f, 0x4f86275f10a659f8},
    {"abm4", 0x90418d32e31a3315, 0xc63e5ffbb6e63c5c},
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
