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
    {"euler", 0x6df02028980eee2b, 0xf82bf1e8f3f7b288},
    {"midpoint", 0xc6856622317276ea, 0x942e71d2e6f05692},
    {"heun", 0x5befd078a739fafc, 0x89b2443cacbcc5a9},
    {"ralston", 0xfe4a1d85f07a8d55, 0x635696c80f7c998},
    {"rk3", 0xb414ec4ec0e8f274, 0x6d81606d43f889fd},
    {"rk4", 0xbfcc1e9482141dc3, 0xa83b97923c910904},
    {"rk4_38", 0x2b879343df233572, 0xa937570b85a7296d},
    {"taylor2", 0x8752d566dc196dff, 0x8716b872b861994b},
    {"bogacki_shampine3", 0xc6d054ba415cde7f, 0xa73cf5d79a1db051},
    {"dormand_prince5", 0x9efec769337e9093, 0x78800dfe4d73e72f},
    {"tsitouras5", 0x65e1c534cfd20e0d, 0x5c79589c15c6e64},
    {"dormand_prince8", 0xe7831da6ad439e38, 0xc481c94ff685a547},
    {"gragg_bulirsch_stoer10", 0x59ba3230acef88af, 0x4e2fa3d159d5a03f},
    {"semi_implicit_euler", 0x9ca6deb86084c137, 0x6912387b47d204c5},
    {"velocity_verlet", 0x62bf5bfb6cdab31a, 0x1c5d77641706b816},
    {"ruth3", 0x916259f638aa6eea, 0xfbfc0e5577976e16},
    {"forest_ruth", 0xd62d7223b621f75a, 0x393a52bbaa441a58},
    {"yoshida4", 0x670deb660828e47c, 0xdf4733143a4c3875},
    {"pefrl", 0xa6140e339268e3d, 0x1bcac907a0f3c943},
    {"yoshida6", 0x7180d261e34b6deb, 0x3597cd8939dcc7},
    {"boris", 0xb6a89bc8376813df, 0x8c84796c4a401692},
    {"backward_euler", 0xba68aa4c9d0be859, 0x1619f64963dd0360},
    {"implicit_midpoint", 0x2264a15bd8c0d7dc, 0xec5f543112e0f149},
    {"gauss4", 0xde5393a8b40fb080, 0xa42d82882ae1d7ea},
    {"ab2", 0x5c72a8fdd1d5763d, 0x2a4a0dc39ce10d35},
    {"ab3", 0x4105a0a483d00bf6, 0x28a01eddd309d4ff},
    {"ab4", 0x2279df16e339c37e, 0x1a9cfb4e049279f3},
    {"ab5", 0x42b8aa6c6d3e410c, 0x24017ab20693d7c1},
    {"abm4", 0xefbf190a680a0e5, 0x59f5e851ec211201},
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
