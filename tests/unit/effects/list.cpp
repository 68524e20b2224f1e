// The list of effects: descriptions that a stranger can use, and one row of a vector for an effect that has one row.
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "engine/effects/local_effects.h"
#include "engine/effects/pair_effects.h"
#include "engine/world/interface.h"
#include "engine/world/pair_neighbours.h"
#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;
using ballpark::Workers;

namespace {

/// What each effect offers beside its force. A new effect is a new line.
struct Abilities {
  bool energy, force_derivative, window_and_rows, stiffness;
};
const std::map<std::string, Abilities> abilities = {
    {"gravity", {true, true, false, false}},         {"linear_drag", {false, true, false, true}},
    {"quadratic_drag", {false, true, false, true}},  {"magnus", {false, true, false, false}},
    {"spring", {true, true, false, true}},           {"central_gravity", {true, true, false, false}},
    {"electric_field", {true, true, false, false}},  {"magnetic_field", {false, true, false, true}},
    {"rotating_frame", {true, true, false, true}},   {"force", {false, true, true, false}},
    {"torque", {false, true, true, false}},          {"pivot", {false, true, false, false}},
    {"mutual_gravity", {true, false, false, false}}, {"bonds", {true, false, false, true}},
    {"harmonic_trap", {true, true, false, true}},    {"buoyancy", {true, true, false, false}},
    {"reynolds_drag", {false, true, false, true}},   {"spin_decay", {false, true, false, true}},
    {"added_mass", {true, true, false, false}},      {"wind", {false, true, false, false}},
    {"gusts", {false, true, false, false}},          {"lennard_jones", {true, false, false, true}},
    {"thermostat", {false, false, false, false}},    {"reflecting_wall", {false, false, false, false}},
    {"soft_repulsion", {true, false, false, true}},  {"table", {false, false, false, true}},
    {"emitter", {false, false, false, false}},       {"absorbing_wall", {false, false, false, false}},
    {"outlet", {false, false, false, false}},
};

}  // namespace

TEST_CASE("Effect list: every effect tells its name, sentence, source, parameters and units", "[effects]") {
  std::set<std::string> names;
  for (const ballpark::EffectDescription& effect : describe_effects()) {
    CAPTURE(effect.name);
    CHECK(names.insert(effect.name).second);
    CHECK(effect.doc.size() > 10);
    CHECK_FALSE(effect.source.empty());
    CHECK_FALSE(effect.exerts.empty());
    CHECK(effect.flops >= (effect.name == "added_mass" ? 0 : 1));  // it is in a constant
    for (const ballpark::ParameterInfo& parameter : effect.parameters) {
      CAPTURE(parameter.name);
      CHECK(parameter.unit.empty() == (parameter.kind == ballpark::ParameterKind::word));
      CHECK(parameter.choices.empty() == !parameter.unit.empty());
      CHECK_FALSE(parameter.doc.empty());
    }
  }
  CHECK(names.size() == abilities.size());
  for (const auto& [name, offered] : abilities) CHECK(names.count(name) == 1);
}

TEST_CASE("Effect list: what an effect offers is found in its code", "[effects]") {
  for (const EffectInfo& info : local_effects()) {
    CAPTURE(info.description.name);
    const std::string& name = info.description.name;
    REQUIRE(abilities.count(name) == 1);
    const Abilities& owed = abilities.at(name);
    CHECK_FALSE(info.description.between_bodies);
    CHECK(info.description.has_energy == owed.energy);
    CHECK((info.energy != nullptr) == owed.energy);
    CHECK(info.description.has_force_derivative == owed.force_derivative);
    CHECK((info.window != nullptr) == owed.window_and_rows);
    CHECK((info.rows != nullptr) == owed.window_and_rows);
    CHECK((info.stiffness != nullptr) == owed.stiffness);
    CHECK(local_effects()[static_cast<std::size_t>(local_effect_index(name))].description.name == name);
  }
  CHECK(local_effect_index("pivot") == -1);
  CHECK(local_effect_index("gravty") == -1);
}

TEST_CASE("Effect list: effects between bodies have an energy, no force derivative, and stiffness if they say so",
          "[effects]") {
  const Real mass[2] = {1, 1}, apart[2] = {0, 0.5};
  PairBodies two{.count = 2, .copies = {}, .end = 2, .mass = mass};
  for (const Real*& column : two.position) column = apart;
  Workers workers(1);
  const auto neighbours = [](Real reach) -> std::unique_ptr<Neighbours> {
    return std::make_unique<PairNeighbours>(reach, 2, 1, Period{});
  };
  for (const PairEffectInfo& info : pair_effects()) {
    CAPTURE(info.description.name);
    REQUIRE(abilities.count(info.description.name) == 1);
    const Abilities& owed = abilities.at(info.description.name);
    CHECK(info.description.has_energy == owed.energy);
    CHECK(info.description.has_force_derivative == owed.force_derivative);
    CHECK(info.description.between_bodies);
    const std::map<std::string, ballpark::Value> parameters = {{"pairs", std::vector<ballpark::IdPair>{{0, 1}}},
                                                               {"stiffness", std::vector<double>{2.0}},
                                                               {"damping", std::vector<double>{1.0}},
                                                               {"rest_length", std::vector<double>{-1.0}},
                                                               {"strength", 1.0},
                                                               {"softening", 0.0},
                                                               {"epsilon", 1.0},
                                                               {"sigma", 1.0},
                                                               {"cutoff", 1.5},
                                                               {"opening_angle", 0.5}};
    const auto slot_of = [](std::size_t id) { return id; };
    const EffectInput input{parameters, 0, {}};
    const auto effect = info.make({input, two, slot_of, {}, {}, neighbours, workers});
    CHECK((effect->per_mass().spring > 0) == owed.stiffness);
    CHECK(effect->cost().flops > 0);
    CHECK(pair_effects()[static_cast<std::size_t>(pair_effect_index(info.description.name))].make == info.make);
    CHECK(local_effect_index(info.description.name) == -1);
  }
  CHECK(pair_effect_index("gravity") == -1);
}

TEST_CASE("Effect list: an effect reads what it says, and nothing else", "[effects]") {
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  const auto per_body = [](const std::string&, const std::vector<ballpark::Vector3d>& rows) {
    std::array<PerBody, 3> columns;
    for (Eigen::Index c = 0; c < 3; ++c) columns[static_cast<std::size_t>(c)].value = rows[0][c];
    return columns;
  };
  for (std::size_t e = 0; e < local_effects().size(); ++e) {
    const EffectInfo& info = local_effects()[e];
    std::map<std::string, ballpark::Value> parameters;
    for (const ballpark::ParameterInfo& p : info.description.parameters) {
      using ballpark::ParameterKind;
      const ballpark::Vector3d v(0.3, -0.2, 0.5);
      ballpark::Value made = 0.25;
      if (p.kind == ParameterKind::vector) made = v;
      if (p.kind == ParameterKind::vectors) made = std::vector<ballpark::Vector3d>{v};
      if (p.kind == ParameterKind::word) made = *p.fallback;
      parameters[p.name] = made;
    }
    if (info.window) parameters["until"] = 1.0;
    std::vector<std::byte> constants(info.constants_size);
    info.pack({parameters, 1, per_body, 2, {nullptr, 0.1}}, constants.data());
    const EffectInstance instance{static_cast<int>(e), constants.data()};
    LocalForces forces;
    (info.flows ? forces.flow_begin : forces.begin) = &instance;
    (info.flows ? forces.flow_end : forces.end) = &instance + 1;
    for (const std::string column : {"position", "velocity", "spin"}) {
      Body<Real> body{0, 2, {1, 2, 3}, {4, 5, -6}, {7, -8, 9}};
      if (column == "position") body.position = {nan, nan, nan};
      if (column == "velocity") body.velocity = {nan, nan, nan};
      if (column == "spin") body.spin = {nan, nan, nan};
      const Loads<Real> loads = forces.loads(body, 0);
      const bool finite = std::isfinite(length(loads.force) + length(loads.torque) + length(forces.flow(body, 0)));
      CAPTURE(info.description.name, column);
      CHECK(finite == !info.reads(column.c_str()));
    }
  }
}

TEST_CASE("Effect list: all precisions describe the same effects", "[effects]") {
  const auto wide = ballpark::f64::describe_effects();
  for (const auto& other : {ballpark::f32::describe_effects(), ballpark::extended::describe_effects()}) {
    REQUIRE(other.size() == wide.size());
    for (std::size_t i = 0; i < wide.size(); ++i) {
      CHECK(other[i].name == wide[i].name);
      CHECK(other[i].parameters.size() == wide[i].parameters.size());
    }
  }
}

TEST_CASE("Row choice: one lane of the vector that holds the row", "[effects]") {
  constexpr std::size_t lanes = lane_count<Lanes>;
  RowChoice choice;
  const Vector3<Lanes> ones{Lanes(Real(1)), Lanes(Real(2)), Lanes(Real(3))};
  CHECK_FALSE(choice.misses<Lanes>(0));
  choice.row = static_cast<std::ptrdiff_t>(2 * lanes + 1);
  CHECK(choice.misses<Lanes>(lanes));
  CHECK_FALSE(choice.misses<Lanes>(2 * lanes));
  CHECK(choice.misses<Lanes>(3 * lanes));
  const Vector3<Lanes> here = choice.only_here(ones, 2 * lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    CHECK(here.x[lane] == (lane == 1 ? 1 : 0));
    CHECK(here.z[lane] == (lane == 1 ? 3 : 0));
  }
}
