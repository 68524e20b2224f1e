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
    {"fountain", 0x621bd2abfdee492a, 0xb5ab7681d49c7b49},
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
    {"euler", 0x729d745886bb3af2, 0x7813f354877849c3},
    {"midpoint", 0xb8d0823ee671124c, 0x576c364e25ff753a},
    {"heun", 0x80566648445b404c, 0x9e0429dbebbb7d26},
    {"ralston", 0xf514950a40293827, 0x718a302dfdc6ec5d},
    {"rk3", 0xfe3537aba9f3301c, 0xb2032db88386b8b9},
    {"rk4", 0xa27b5044358a1c9a, 0xb758ba04ea8341d7},
    {"rk4_38", 0xd02e909e70348f5c, 0x2a812e2b3c0261ba},
    {"taylor2", 0xd3be446c4834444a, 0x5beebcaf64935168},
    {"bogacki_shampine3", 0xa6efe3717072990b, 0xbaed22cef5b4ee2},
    {"dormand_prince5", 0xd00d2b3499bea651, 0xe8ae75d621e8d3ac},
    {"tsitouras5", 0x55c7093e38335025, 0x7650c4c751a1fde6},
    {"dormand_prince8", 0x3d07810838d2166b, 0xf62069d494ad7921},
    {"gragg_bulirsch_stoer10", 0xc8a429aa9c361cc9, 0xcab27c74ddcadc17},
    {"semi_implicit_euler", 0x6753ade3bb3bd7f5, 0x81c376c2a5855127},
    {"velocity_verlet", 0x2c232cf25daf0de, 0xa3d8a6c5b83e0b10},
    {"ruth3", 0x5ebff120b88fa432, 0x35b8def88589631a},
    {"forest_ruth", 0x9380c28aad95afc5, 0xa4bd820f92939b9},
    {"yoshida4", 0xce5bfebc9a571bf9, 0x7d087b9d9ca60ac0},
    {"pefrl", 0x46d4c41e54b35c9f, 0x9e9e36d5358b3375},
    {"yoshida6", 0x51bd7634e840fbc9, 0x5054e9ef35fe23ba},
    {"boris", 0x5d45c0a4ac74a21e, 0x794ed8ea670eb707},
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
