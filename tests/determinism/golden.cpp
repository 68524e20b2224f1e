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
    {"comet", 0x615fb364fa61f065, 0x9c124f28ebfc925},
    {"curveball", 0xcc8e93b1ed322e16, 0x88014ccc70fd3b0f},
    {"dice", 0x71f4ec80280e3e37, 0x9eb139c46818ddb5},
    {"dust", 0x2f8e5cd459de4774, 0x4ef89d678f17d05b},
    {"figure_eight", 0x71a9dec48ea4cb31, 0xef685bf4d7d4debf},
    {"free_top", 0xa238c7e32b2fceb8, 0xea7e5d28f9ffc315},
    {"gas", 0xd8c0dfa33efaf71d, 0x913e75a981bf72e4},
    {"incline", 0x2047add4ad3fb515, 0x451575590fd82201},
    {"kepler", 0x73978e3d3c7f362a, 0x4477d9b5814c7a60},
    {"newton_cradle", 0xb9c2a58a2c13f85, 0xc95439777ca477d6},
    {"oscillator", 0xe7a7f42286f60abc, 0x9b1744f86ce822ef},
    {"overdamped", 0x5ab73f423e1f16d3, 0xda0ea8e3806ef6d2},
    {"pendulum", 0x4165e83bf79c055, 0x1a7e04db86f96a5e},
    {"pleiades", 0x8b7a05cea67106dc, 0xc753e1c561d1e5a0},
    {"projectile", 0xbaab5138ebd9555e, 0xeff334dabdcea01a},
    {"shaken_bed", 0x36c694e1ed261513, 0x1e6099c2a2308c8c},
    {"slingshot", 0x18dcefb236c1cdda, 0x6b072766e195b6c0},
    {"spinning_top", 0xedc6d71584fd9030, 0xe166e91cb47dfbbf},
    {"stack", 0xd379e1fa61942df7, 0x59d9719bdc8401d8},
    {"swing", 0x780a311a98d1db8, 0xde0b816907cdaf99},
    {"terminal_velocity", 0xdde19bb03a7869dd, 0x1479a403a392c09d},
    {"tumbling", 0x695f6e1be060c2d, 0x8abbf4973233c7fa},
};

/// Each integrator: the hashes of all scenarios one after the other, plain and compensated.
const Golden by_integrator[] = {
    {"euler", 0xaaac0f82a7c34fa6, 0x88c37194606ef7c5},
    {"midpoint", 0xba4e19d8f379d2bb, 0x1e187d96bcaf2c10},
    {"heun", 0x5473f4bec5b1bbd9, 0x5bbecb23082b8337},
    {"ralston", 0x1bf7936a8e2966ef, 0xea03695ba9a3625e},
    {"rk3", 0x29fdd371c635f0f8, 0x2f7bb0204b3284b6},
    {"rk4", 0xf0c8a97ddbdcb2fe, 0xecc38ccc3c06fa31},
    {"rk4_38", 0x712a1a79990ff2b, 0xcd5a9ab3188cceb2},
    {"taylor2", 0xe139cd7f7f6013b1, 0x3ada15986446e4fa},
    {"bogacki_shampine3", 0x55940a1706d8e1fe, 0x1c94656079b49214},
    {"dormand_prince5", 0x4040e2a8f5210328, 0x6632429fc9f510a5},
    {"tsitouras5", 0x129189b9681db740, 0xddaa01d52aae1e2e},
    {"dormand_prince8", 0x47f39963a05c65b9, 0x60f5d58979c9a081},
    {"gragg_bulirsch_stoer10", 0xdc5f57b825a0429a, 0x9da877f038ae4023},
    {"semi_implicit_euler", 0x3f050a6f9dd061a3, 0xd1355d2f95a2324c},
    {"velocity_verlet", 0x872aeed594c45355, 0x6f2b21ffc5c57976},
    {"ruth3", 0x916259f638aa6eea, 0xfbfc0e5577976e16},
    {"forest_ruth", 0xd62d7223b621f75a, 0x393a52bbaa441a58},
    {"yoshida4", 0x670deb660828e47c, 0xdf4733143a4c3875},
    {"pefrl", 0xa6140e339268e3d, 0x1bcac907a0f3c943},
    {"yoshida6", 0x7180d261e34b6deb, 0x3597cd8939dcc7},
    {"ab2", 0x501a57b7ef2ca094, 0x9f8239f9757aa648},
    {"ab3", 0x569db0d48178e594, 0x5ff88b0f1e4c0ef6},
    {"ab4", 0x2e2f132b95cdbf8d, 0xff54c94d58454115},
    {"ab5", 0xb6342f551c8aef21, 0x74bf4e932ce373b3},
    {"abm4", 0xdf469a037d9de255, 0xa192da5d9b83bdc4},
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
