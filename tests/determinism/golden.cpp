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
    {"euler", 0xd19f24fa12508144, 0x88038f336a3a892d},
    {"midpoint", 0x3889875d5bafe0f1, 0x58f9a2e0e7d4e1cb},
    {"heun", 0x80809d5ca1d4a7d6, 0xac5422bfc1e61e3a},
    {"ralston", 0xf655e27b6d6d1052, 0xedea3749ca096f63},
    {"rk3", 0xbd0cc8cf0980e09f, 0x3cd27de9be669602},
    {"rk4", 0xb7b1c220368f9911, 0x8625d7045d5b6dc9},
    {"rk4_38", 0xe0ae2a29f54f464, 0xf74516598b5c2e5d},
    {"taylor2", 0x5ac01dc708f09b57, 0xf0515835f136b055},
    {"bogacki_shampine3", 0x6d299ae430b25dbe, 0xb711e96a3906acd7},
    {"dormand_prince5", 0x72c45161bef279d9, 0xabbde15c3b03ba2c},
    {"tsitouras5", 0x9a1446155d248727, 0x9b391569527e6e7d},
    {"dormand_prince8", 0xf79a5d9835939869, 0xfe4481c00ada4c0c},
    {"gragg_bulirsch_stoer10", 0x2ce9dda99f8c87d8, 0x1b9d6480736b6ca1},
    {"semi_implicit_euler", 0x39e6992adb6e4a00, 0xe4530d53355df9db},
    {"velocity_verlet", 0x9a1fc6ad7011c537, 0x57b1eccf36275381},
    {"ruth3", 0xe125ac82ec871ea2, 0x377d0124e72ee5d4},
    {"forest_ruth", 0x99f0afee5bbf45d7, 0xa72a3e329a650bed},
    {"yoshida4", 0x29ad8d466f46dd7, 0x49654e12d88f30fa},
    {"pefrl", 0x89e8766a05c8c6f2, 0x6ce9fd9e6111a7f2},
    {"yoshida6", 0x508dc8b6a0d038d2, 0x708f49030af2bb42},
    {"boris", 0xc3f0fadf7af44838, 0xd12551b1be863220},
    {"backward_euler", 0x4a63ddf8afb3600, 0x8bdb8879c2696f0},
    {"implicit_midpoint", 0x5dd08636e68204d1, 0x5c764019ff49855a},
    {"gauss4", 0x8899fb7ae9c3fe36, 0x92b91037e008277b},
    {"ab2", 0x1f70615dc27f15ba, 0x9cee7eeccc50417f},
    {"ab3", 0x4a26c5190a7c72d7, 0xe4234810503bb05c},
    {"ab4", 0xfaeab785f1b5e0ab, 0x6f0a1fccb0306352},
    {"ab5", 0x2fb5d582dccb7b2b, 0x1ea5913050bc81f0},
    {"abm4", 0x2383ebd2fa1d88a, 0xce6a7abf2572b706},
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
