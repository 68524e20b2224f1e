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
    {"ball_rain", 0x49c5c56cb88d25c1, 0xae562b01f67cb75},   {"bounce", 0xf5a41a433bf9cd63, 0x7166db590d0f29bb},
    {"break", 0x7ca3b65b1c024d4b, 0xa3c6a62ac21e2b06},      {"dice", 0x71f4ec80280e3e37, 0x9eb139c46818ddb5},
    {"dust", 0x2f8e5cd459de4774, 0x4ef89d678f17d05b},       {"figure_eight", 0x71a9dec48ea4cb31, 0xef685bf4d7d4debf},
    {"gas", 0xd8c0dfa33efaf71d, 0x913e75a981bf72e4},        {"incline", 0x2047add4ad3fb515, 0x451575590fd82201},
    {"kepler", 0x73978e3d3c7f362a, 0x4477d9b5814c7a60},     {"newton_cradle", 0xb9c2a58a2c13f85, 0xc95439777ca477d6},
    {"oscillator", 0xe7a7f42286f60abc, 0x9b1744f86ce822ef}, {"pendulum", 0x4165e83bf79c055, 0x1a7e04db86f96a5e},
    {"projectile", 0xbaab5138ebd9555e, 0xeff334dabdcea01a}, {"shaken_bed", 0x36c694e1ed261513, 0x1e6099c2a2308c8c},
    {"slingshot", 0x18dcefb236c1cdda, 0x6b072766e195b6c0},  {"spinning_top", 0xedc6d71584fd9030, 0xe166e91cb47dfbbf},
    {"stack", 0xd379e1fa61942df7, 0x59d9719bdc8401d8},      {"tumbling", 0x695f6e1be060c2d, 0x8abbf4973233c7fa},
};

/// Each integrator: the hashes of all scenarios one after the other, plain and compensated.
const Golden by_integrator[] = {
    {"euler", 0xb3c3d8abea5cf267, 0xb3b1686cc71a827},
    {"midpoint", 0xaff6a045f259e846, 0x90709f140f47d294},
    {"heun", 0x2cab2af8f69f0965, 0x6a6ab97e06a872d4},
    {"ralston", 0x9320145f84804d01, 0x126a578b9a15d5c2},
    {"rk3", 0x1580a4ab25f97401, 0xb6da419ccd715deb},
    {"rk4", 0x981f4b05e862cdab, 0xcb54bb583943abfe},
    {"rk4_38", 0xa747ed0dc8cd6378, 0xe282905e7999681f},
    {"taylor2", 0x71c8e9a99ad80891, 0x38608e674a41efaf},
    {"bogacki_shampine3", 0x2bc452f9e6e2f676, 0xa7cd9034cbc910dd},
    {"dormand_prince5", 0x9d3af561360d209d, 0x6f1f7a36799fb542},
    {"tsitouras5", 0xc1b0aaee6bb55c3b, 0xdc2c6023a5e1b505},
    {"dormand_prince8", 0xc35d08665f14a33c, 0x3e0ab74ae0d6b2d3},
    {"gragg_bulirsch_stoer10", 0x6957770ae0d1fd57, 0x4a4b99026750f471},
    {"semi_implicit_euler", 0x9d4b90f461977b4b, 0xe84aa7a67da286b8},
    {"velocity_verlet", 0xfbb91983deb92f39, 0x96a1566788b4651e},
    {"ruth3", 0xf86ab111bf63e6b9, 0xf2f1521ab349e592},
    {"forest_ruth", 0x6f33327f6e5769c0, 0xb11a5adfa4a0cbc1},
    {"yoshida4", 0xa36382c9dacf9301, 0x38d7c955d8e68c7e},
    {"pefrl", 0xe37f46285f6da42e, 0x596275fb564b4f2},
    {"yoshida6", 0xdc57746e72db7cd5, 0xda6587f055a642de},
    {"ab2", 0x103745a930ee4394, 0x4b0986555bec3bfb},
    {"ab3", 0xb798f3ec4e450909, 0x28b394e0b8f4c87e},
    {"ab4", 0xe746f037b575463f, 0x2784c6541aa825cd},
    {"ab5", 0x881134fcb7396dcc, 0x1d1fd7ffbb991678},
    {"abm4", 0x7a8cbc94037c9654, 0xafc2c00613319bc4},
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
