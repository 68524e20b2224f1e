// The list of effects: descriptions that a stranger can use, and one row of a vector for an effect that has one row.
#include <set>

#include "engine/effects/local_effects.h"
#include "engine/world/interface.h"
#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;

TEST_CASE("Effect list: every effect tells its name, sentence, source, parameters and units", "[effects]") {
  std::set<std::string> names;
  for (const ballpark::EffectDescription& effect : describe_effects()) {
    CAPTURE(effect.name);
    CHECK(names.insert(effect.name).second);
    CHECK(effect.doc.size() > 10);
    CHECK_FALSE(effect.source.empty());
    CHECK_FALSE(effect.exerts.empty());
    CHECK(effect.flops > 0);
    for (const ballpark::ParameterInfo& parameter : effect.parameters) {
      CAPTURE(parameter.name);
      CHECK_FALSE(parameter.unit.empty());
      CHECK_FALSE(parameter.doc.empty());
    }
  }
  CHECK(names == std::set<std::string>{"gravity", "linear_drag", "quadratic_drag", "magnus", "spring",
                                       "central_gravity", "force", "torque", "pivot"});
}

TEST_CASE("Effect list: what an effect offers is found in its code", "[effects]") {
  for (const EffectInfo& info : local_effects()) {
    CAPTURE(info.description.name);
    const std::string& name = info.description.name;
    const bool conserves = name == "gravity" || name == "spring" || name == "central_gravity";
    const bool applied = name == "force" || name == "torque";
    CHECK(info.description.has_energy == conserves);
    CHECK((info.energy != nullptr) == conserves);
    CHECK(info.description.has_force_derivative);
    CHECK((info.window != nullptr) == applied);
    CHECK((info.rows != nullptr) == applied);
    CHECK((info.stiffness != nullptr) == (name == "spring" || name.ends_with("_drag")));
    CHECK(local_effects()[static_cast<std::size_t>(local_effect_index(name))].description.name == name);
  }
  CHECK(local_effect_index("pivot") == -1);
  CHECK(local_effect_index("gravty") == -1);
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
