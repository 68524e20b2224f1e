// What exists for a scene: columns, passes and bytes, with and without each effect.
#include <algorithm>
#include <random>
#include <utility>

#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::ColumnReport;
using ballpark::Explanation;
using ballpark::PassReport;
using ballpark::Path;
using ballpark::World;

namespace {

Explanation explained(const Scene& scene, const Options& options = {}) {
  return World(scene, options).explain();
}

/// "name components" of a group's columns, in order.
std::vector<std::string> columns_of(const Explanation& all, const std::string& group) {
  std::vector<std::string> names;
  for (const ColumnReport& column : all.columns) {
    if (column.group == group) names.push_back(column.name + " " + std::to_string(column.components));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> without(std::vector<std::string> names, const std::vector<std::string>& other) {
  names.erase(std::remove_if(names.begin(), names.end(), [&](const auto& name) { return contains(other, name); }),
              names.end());
  return names;
}

double column_bytes(const Explanation& all) {
  double sum = 0;
  for (const ColumnReport& column : all.columns) sum += column.bytes_per_body;
  return sum;
}

const ballpark::GroupReport& group_of(const Explanation& all, const std::string& name) {
  return *std::find_if(all.groups.begin(), all.groups.end(), [&](const auto& group) { return group.name == name; });
}

using Words = std::vector<std::string>;

/// What a group of two balls without spin gets for an effect.
struct Claim {
  Effect effect;
  std::string motion;
  Words columns;      ///< more than position and velocity
  double read_extra;  ///< values that the fused pass reads and writes beside them, for one body
};

Effect sample_of(const std::string& kind) {
  for (const ballpark::EffectDescription& description : ballpark::effects()) {
    if (description.name == kind) return sample(description);
  }
  return {};
}

Effect with(Effect made, const std::string& key, const Value& value) {
  made.parameters[key] = value;
  return made;
}

std::vector<Claim> claims() {
  const std::vector<Vector3d> two{{3, 4, 5}, {5, 4, 3}};
  const Words spin{"angular_momentum 3"};
  return {{sample_of("gravity"), "point", {}, 0},
          {sample_of("linear_drag"), "point", {}, 0},
          {sample_of("quadratic_drag"), "point", {}, 0},
          {sample_of("central_gravity"), "point", {}, 0},
          {sample_of("spring"), "point", {}, 0},
          {with(sample_of("spring"), "anchor", two), "point", {"spring.anchor 3"}, 3},
          {sample_of("electric_field"), "point", {}, 0},
          {sample_of("magnetic_field"), "point", {}, 0},
          {sample_of("rotating_frame"), "point", {}, 0},
          {sample_of("force"), "point", {}, 0},
          {with(sample_of("force"), "offset", Vector3d(0.1, 0, 0)), "spinning", spin, 6},
          {sample_of("torque"), "spinning", spin, 6},
          {sample_of("magnus"), "spinning", spin, 6},
          {sample_of("spin_decay"), "spinning", spin, 6},
          {sample_of("harmonic_trap"), "point", {}, 0},
          {sample_of("buoyancy"), "point", {}, 0},
          {sample_of("reynolds_drag"), "point", {}, 0},
          {sample_of("wind"), "point", {}, 0},
          {sample_of("gusts"), "point", {}, 0},
          {sample_of("added_mass"), "point", {}, 0},
          {sample_of("table"), "spinning", spin, 6},
          {sample_of("pivot"), "pivoted", {"angular_momentum 3", "arm 3", "inverse_inertia 6", "orientation 4"}, 0}};
}

}  // namespace

TEST_CASE("Structure: dust is position and velocity, moved by one fused pass", "[structure]") {
  const Explanation all = explained(
      scene_of({particles("grains", 5)}, {effect("gravity"), effect("quadratic_drag", {{"coefficient", 0.1}})}));
  CHECK(all.path == "fused");
  CHECK(columns_of(all, "grains") == Words{"position 3", "velocity 3"});
  REQUIRE(all.passes.size() == 1);
  CHECK(all.passes[0].name == "fused_step");
  CHECK(all.passes[0].calls_per_step == 1);
  CHECK(all.passes[0].bytes_per_body == 96);
  CHECK(all.bytes_per_body_step == 96);
  CHECK(all.flops_per_body_step > 0);
  REQUIRE(all.groups.size() == 1);
  CHECK(all.groups[0].motion == "point");
  CHECK(all.groups[0].effects == Words{"gravity", "quadratic_drag"});
  for (const char* absent : {"orientation", "torque", "angular momentum", "grid", "pairs", "contacts", "spring"}) {
    CAPTURE(absent);
    CHECK(contains(all.off, absent));
  }
  for (const char* present : {"gravity", "quadratic_drag"}) CHECK_FALSE(contains(all.off, present));
}

TEST_CASE("Structure: single precision is half the bytes", "[structure]") {
  const Scene scene = scene_of({bricks("b", 5)}, {effect("gravity")});
  const Explanation wide = explained(scene), narrow = explained(scene, {.precision = ballpark::Precision::single_});
  CHECK(narrow.bytes_per_body_step == wide.bytes_per_body_step / 2);
  CHECK(narrow.column_bytes == wide.column_bytes / 2);
  CHECK(narrow.flops_per_body_step == wide.flops_per_body_step);
}

TEST_CASE("Structure: each effect brings what its nature asks for, and nothing else", "[structure]") {
  const Explanation bare = explained(scene_of({balls("g", 2)}));
  CHECK(columns_of(bare, "g") == Words{"position 3", "velocity 3"});
  Words covered;
  for (const Claim& claim : claims()) {
    const Explanation all = explained(scene_of({balls("g", 2)}, {claim.effect}));
    CAPTURE(claim.effect.kind, claim.motion);
    covered.push_back(claim.effect.kind);
    CHECK(all.groups[0].motion == claim.motion);
    CHECK(all.groups[0].effects == Words{claim.effect.kind});
    CHECK(without(columns_of(all, "g"), columns_of(bare, "g")) == claim.columns);
    CHECK(columns_of(all, "g").size() == 2 + claim.columns.size());
    REQUIRE(all.passes.size() == 1);
    CHECK(contains(bare.off, claim.effect.kind));
    CHECK_FALSE(contains(all.off, claim.effect.kind));
    if (claim.motion != "pivoted") {
      CHECK(all.passes[0].bytes_per_body == bare.passes[0].bytes_per_body + 8 * claim.read_extra);
      const bool in_a_constant = claim.effect.kind == "added_mass";
      CHECK((all.passes[0].flops_per_body > bare.passes[0].flops_per_body) != in_a_constant);
    }
  }
  for (const std::string between : {"mutual_gravity", "bonds", "lennard_jones", "soft_repulsion"}) {
    const Explanation all = explained(scene_of({balls("g", 2)}, {sample_of(between)}));
    CAPTURE(between);
    covered.push_back(between);
    CHECK(all.path == "staged");
    CHECK(all.groups[0].motion == "point");
    CHECK(all.groups[0].effects == Words{between});
    CHECK(without(columns_of(all, "g"), columns_of(bare, "g")) ==
          Words{"force 3", "rates 24", "trial_position 3", "trial_velocity 3"});
    Words passes;
    for (const ballpark::PassReport& pass : all.passes) passes.push_back(pass.name);
    CHECK(passes == Words{"prepare", between, "evaluate", "finish"});
    CHECK(contains(bare.off, between));
    CHECK(contains(bare.off, "force sums"));
    CHECK_FALSE(contains(all.off, between));
    CHECK_FALSE(contains(all.off, "force sums"));
  }
  for (const std::string between : {"thermostat", "reflecting_wall"}) {
    const Explanation all = explained(scene_of({balls("g", 2)}, {sample_of(between)}));
    CAPTURE(between);
    covered.push_back(between);
    CHECK(all.path == "fused");
    CHECK(all.groups[0].motion == "point");
    CHECK(all.groups[0].effects == Words{between});
    CHECK(columns_of(all, "g") == columns_of(bare, "g"));
    REQUIRE(all.passes.size() == 2);
    CHECK(all.passes[0].bytes_per_body == bare.passes[0].bytes_per_body);
    CHECK(all.passes[0].flops_per_body == bare.passes[0].flops_per_body);
    CHECK(all.passes[1].name == between);
    CHECK(all.passes[1].bytes_per_body == (between == "thermostat" ? 48 : 96));
    CHECK(contains(bare.off, between));
    CHECK_FALSE(contains(all.off, between));
  }
  for (const std::string gate : {"emitter", "absorbing_wall", "outlet"}) {
    const Explanation all = explained(scene_of({balls("g", 2)}, {sample_of(gate)}));
    CAPTURE(gate);
    covered.push_back(gate);
    CHECK(without(columns_of(all, "g"), columns_of(bare, "g")) == Words{"present 1"});
    REQUIRE(all.passes.size() == 2);
    CHECK(all.passes[0].bytes_per_body == bare.passes[0].bytes_per_body);
    CHECK(all.passes[1].name == gate);
    CHECK(all.passes[1].bytes_per_body == (gate == "emitter" ? 0 : 24));
    CHECK(contains(bare.off, gate));
    CHECK_FALSE(contains(all.off, gate));
  }
  for (const ballpark::EffectDescription& description : ballpark::effects()) {
    CAPTURE(description.name);
    CHECK(contains(covered, description.name));
  }
}

TEST_CASE("Structure: in any company an effect adds its own columns, bytes and arithmetic", "[structure]") {
  constexpr int evaluations = 4;  // of rk4
  std::vector<Claim> all = claims();
  std::erase_if(all, [](const Claim& claim) {
    const bool has_column = claim.columns == Words{"spring.anchor 3"};
    return has_column || claim.motion == "pivoted" || claim.effect.kind == "added_mass";
  });
  std::mt19937 random(6);
  for (int round = 0; round < 300; ++round) {
    std::shuffle(all.begin(), all.end(), random);
    std::vector<Effect> company;
    bool spins = false, on_table = false;
    for (std::size_t i = 0; i < 1 + random() % 8; ++i) {
      if (all[i].effect.kind == "table" && std::exchange(on_table, true)) continue;
      company.push_back(all[i].effect);
      spins |= all[i].motion == "spinning";
    }
    const Effect last = company.back();
    const Explanation with = explained(scene_of({balls("g", 2)}, company));
    company.pop_back();
    if (spins) company.push_back(effect("torque", {{"torque", Vector3d(0, 0, 0)}}));
    const Explanation before = explained(scene_of({balls("g", 2)}, company));
    CAPTURE(round, last.kind, company.size());
    REQUIRE(with.passes.size() == 1);
    REQUIRE(before.passes.size() == 1);
    CHECK(with.groups[0].motion == (spins ? "spinning" : "point"));
    CHECK(columns_of(with, "g") == columns_of(before, "g"));
    CHECK(with.passes[0].bytes_per_body == before.passes[0].bytes_per_body);
    const auto flops_of = [](const std::string& kind) {
      for (const ballpark::EffectDescription& description : ballpark::effects()) {
        if (description.name == kind) return description.flops;
      }
      return 0;
    };
    const auto reads_position = [](const Effect& effect) {
      for (const ballpark::EffectDescription& description : ballpark::effects()) {
        if (description.name == effect.kind) return contains(description.reads, "position");
      }
      return false;
    };
    const bool first_to_read = reads_position(last) && std::none_of(company.begin(), company.end(), reads_position);
    const int replaced = spins ? flops_of("torque") : 0, of_stages = first_to_read ? 2 * 3 * (evaluations - 1) : 0;
    CHECK(with.passes[0].flops_per_body ==
          before.passes[0].flops_per_body + evaluations * (flops_of(last.kind) - replaced) + of_stages);
  }
}

TEST_CASE("Structure: forces that end at a cut-off bring a grid where bodies are many", "[structure]") {
  for (const std::size_t bodies : {64, 65}) {
    const Explanation all = explained(scene_of({balls("g", bodies)}, {sample_of("soft_repulsion")}));
    for (const char* part : {"grid", "pairs"}) CHECK(contains(all.off, part) == (bodies == 64));
    CHECK(contains(all.off, "contacts"));
  }
}

TEST_CASE("Structure: of bodies of different sizes fluids ask for one column of radii, added mass for one of masses",
          "[structure]") {
  BodyGroup group = particles("g", 2);
  group.radius = {0.1, 0.2};
  const Words bare{"position 3", "velocity 3"};
  CHECK(columns_of(explained(scene_of({group}, {effect("gravity")})), "g") == bare);
  const std::vector<Effect> fluid{sample_of("buoyancy"), sample_of("reynolds_drag")};
  const Explanation lifted = explained(scene_of({group}, fluid));
  CHECK(without(columns_of(lifted, "g"), bare) == Words{"radius 1"});
  CHECK(lifted.passes[0].bytes_per_body == 8 * (6 + 6 + 1));
  const Explanation heavier = explained(scene_of({group}, {sample_of("added_mass")}));
  CHECK(without(columns_of(heavier, "g"), bare) == Words{"effective_mass 1", "radius 1"});
  CHECK(heavier.passes[0].bytes_per_body == 8 * (6 + 6 + 1));
}

TEST_CASE("Structure: a pivot reads orientation and momentum, and writes where bodies are too", "[structure]") {
  BodyGroup alike = balls("g", 1);
  const Explanation all = explained(scene_of({alike}, {sample_of("pivot")}));
  CHECK(columns_of(all, "g") == Words{"angular_momentum 3", "orientation 4", "position 3", "velocity 3"});
  REQUIRE(all.passes.size() == 1);
  CHECK(all.passes[0].bytes_per_body == 8 * (7 + 13));
  CHECK(all.passes[0].reads == Words{"orientation", "angular_momentum"});
  CHECK(all.passes[0].writes == Words{"position", "velocity", "orientation", "angular_momentum"});
}

TEST_CASE("Structure: the fused path is one pass whatever the effects, the staged one a few for each phase",
          "[structure]") {
  for (const ballpark::IntegratorDescription& integrator : ballpark::integrators()) {
    Scene scene = scene_of({particles("p", 3)}, {effect("gravity")});
    scene.run.integrator = integrator.name;
    CHECK(explained(scene).passes.size() == 1);
    if (integrator.implicit) {  // of one path
      CHECK(explained(scene).path == "implicit");
      CHECK(explained(scene).passes[0].name == "implicit_step");
      continue;
    }
    const Explanation staged = explained(scene, {.path = Path::staged});
    CAPTURE(integrator.name);
    CHECK(staged.path == "staged");
    int calls = 0;
    for (const PassReport& pass : staged.passes) calls += pass.calls_per_step;
    CHECK(calls == 2 * integrator.evaluations + 1);
    // Methods that look back move rates on both paths.
    const double share = integrator.start_steps > 0 ? 1 : 2;
    CHECK(staged.bytes_per_body_step > share * explained(scene).bytes_per_body_step);
    World world(scene, {.path = Path::staged});
    world.profile(true);
    world.step(10);
    const int first = integrator.start_steps * 2 * (4 - integrator.evaluations);  // by rk4
    std::uint64_t counted = 0;
    for (const ballpark::PassTime& time : world.pass_times()) counted += time.calls;
    CHECK(counted == static_cast<std::uint64_t>(10 * calls + first));
  }
}

TEST_CASE("Structure: a tolerance and methods that look back ask for rates, and tell what they cost", "[structure]") {
  Scene scene = scene_of({particles("p", 3)}, {effect("gravity")});
  const auto columns = [&] { return columns_of(explained(scene), "p"); };
  scene.run.integrator = "tsitouras5";
  CHECK(columns() == Words{"position 3", "velocity 3"});
  scene.run.integrator = "ab3";
  CHECK(columns() == Words{"position 3", "rates 18", "velocity 3"});
  CHECK(explained(scene).passes[0].bytes_per_body == 8 * (6 + 6 + 2 * 6 + 6));
  scene.run.integrator = "tsitouras5";
  scene.run.tolerance = 1e-6;
  scene.run.step = 0;
  CHECK(columns() == Words{"position 3", "position_before 3", "rates 12", "velocity 3", "velocity_before 3"});
  CHECK(explained(scene).passes[0].bytes_per_body == 8 * (6 + 6 + 6 + 6 + 6));
  CHECK(explained(scene).passes[0].writes ==
        Words{"position", "velocity", "rates", "position_before", "velocity_before"});
}

TEST_CASE("Structure: particles carry no orientation beside spinning balls and bricks", "[structure]") {
  const Scene scene = scene_of({bricks("b", 20), particles("p", 33), spinning(balls("s", 17))},
                               {effect("gravity"), effect("magnus", {{"coefficient", 0.1}}, {"s", "b"})});
  const Explanation all = explained(scene);
  CHECK(columns_of(all, "p") == Words{"position 3", "velocity 3"});
  CHECK(columns_of(all, "s") == Words{"angular_momentum 3", "position 3", "velocity 3"});
  CHECK(columns_of(all, "b") == Words{"angular_momentum 3", "orientation 4", "position 3", "velocity 3"});
  const std::size_t rows = 32 + 64 + 32;  // each group padded to 32
  CHECK(all.column_bytes == 8 * (6 * rows + 3 * (32 + 32) + 4 * 32));
  CHECK(World(scene).view<double>("orientation")[0].size() == 20);
}

TEST_CASE("Structure: equal constants are no column, different ones are", "[structure]") {
  BodyGroup group = spinning(balls("g", 3));
  CHECK(columns_of(explained(scene_of({group})), "g") == Words{"angular_momentum 3", "position 3", "velocity 3"});
  group.mass = {2, 2, 2};
  CHECK(columns_of(explained(scene_of({group})), "g") == Words{"angular_momentum 3", "position 3", "velocity 3"});
  group.mass = {2, 2, 1};
  const Explanation all = explained(scene_of({group}, {effect("magnus", {{"coefficient", 0.1}})}));
  CHECK(columns_of(all, "g") == Words{"angular_momentum 3", "inverse_inertia 3", "mass 1", "position 3", "velocity 3"});
  CHECK(all.passes[0].bytes_per_body == 8 * (9 + 9 + 1 + 3));
}

TEST_CASE("Structure: a pass counts the constants that its motion reads", "[structure]") {
  BodyGroup group = spinning(balls("g", 3));
  group.radius = {0.1, 0.2, 0.3};  // inertia differs, but no force reads or changes spin
  const Explanation all = explained(scene_of({group}));
  CHECK(group_of(all, "g").motion == "point");
  CHECK(all.passes[0].bytes_per_body == 96);
  CHECK_FALSE(contains(all.passes[0].reads, "inverse_inertia"));
}

TEST_CASE("Structure: motions are as narrow as the scene allows", "[structure]") {
  const auto motion = [](const BodyGroup& group, std::vector<Effect> effects = {}) {
    return explained(scene_of({group}, std::move(effects))).groups[0].motion;
  };
  const Effect torque = effect("torque", {{"torque", Vector3d(0, 0, 1)}});
  BodyGroup oriented = spinning(balls("g", 1));
  oriented.orientation = {{}};
  BodyGroup still = particles("g", 1);
  still.inertia = {{1, 2, 2.5}};
  BodyGroup round = spinning(particles("g", 1));
  round.inertia = {{2, 2, 2}};
  CHECK(motion(balls("g", 1)) == "point");
  CHECK(motion(spinning(balls("g", 1))) == "point");
  CHECK(motion(spinning(balls("g", 1)), {torque}) == "spinning");
  CHECK(motion(oriented) == "oriented");
  CHECK(motion(still) == "point");
  CHECK(motion(still, {torque}) == "rigid");
  CHECK(motion(bricks("g", 1)) == "rigid");
  CHECK(motion(round, {torque}) == "spinning");
  CHECK(motion(particles("g", 1), {sample_of("pivot")}) == "pivoted");
}

TEST_CASE("Structure: compensation is one column, a carry for each value", "[structure]") {
  Scene scene = scene_of({particles("p", 3), bricks("b", 3)});
  const Explanation plain = explained(scene);
  scene.run.compensated = true;
  const Explanation all = explained(scene);
  CHECK(without(columns_of(all, "p"), columns_of(plain, "p")) == Words{"carry 6"});
  CHECK(without(columns_of(all, "b"), columns_of(plain, "b")) == Words{"carry 13"});
  CHECK(column_bytes(all) == column_bytes(plain) + 8 * (6 + 13));
  CHECK(all.passes[0].bytes_per_body == 2 * plain.passes[0].bytes_per_body);
}
