// The key table as schema and help: both tell of every key.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "ballpark/catalogue.h"
#include "scenarios/files/keys.h"
#include "tests/catch.h"
#include "tests/unit/files/scene_texts.h"

using namespace ballpark::scenes;
using nlohmann::json;
using scene_texts::contains;

namespace {

/// The schema of a table: through the properties, into lists, for effects the alternative of that kind.
json table_schema(const json& schema, const std::string& path, const std::string& effect) {
  json at = schema;
  std::string rest = path;
  while (!rest.empty()) {
    const std::size_t dot = rest.find('.');
    at = json(at.at("properties").at(rest.substr(0, dot)));
    if (at.contains("items")) at = json(at.at("items"));
    if (at.contains("additionalProperties") && at.at("additionalProperties").is_object()) {
      at = json(at.at("additionalProperties"));  // tables by name
    }
    rest = dot == std::string::npos ? "" : rest.substr(dot + 1);
  }
  if (!at.contains("anyOf")) return at;
  for (const json& alternative : at.at("anyOf")) {
    const std::string kind = alternative.at("properties").at("kind").at("enum").at(0).get<std::string>();
    if (effect.empty() || kind == effect) return alternative;
  }
  return {};
}

}  // namespace

TEST_CASE("Key table: the schema lists every key, with its help and whether it must be there", "[files]") {
  const json schema = json::parse(json_schema());
  CHECK(contains(schema.at("$schema").get<std::string>(), "json-schema.org"));
  CHECK(keys().size() > 60);
  for (const Key& key : keys()) {
    INFO(key.path() + " " + key.effect);
    const json table = table_schema(schema, key.table, key.effect);
    CHECK(table.at("additionalProperties") == false);
    REQUIRE(table.at("properties").contains(key.name));
    CHECK(contains(table.at("properties").at(key.name).at("description").get<std::string>(), key.help));
    const json& required = table.at("required");
    CHECK((std::find(required.begin(), required.end(), key.name) != required.end()) == key.required);
  }
}

TEST_CASE("Key table: the help names every key and what it takes", "[files]") {
  const std::string help = key_help();
  for (const Key& key : keys()) {
    INFO(key.path());
    CHECK(contains(help, key.is_table() ? key.help : "  " + key.name + " "));
    if (!key.is_table()) CHECK(contains(help, expected(key)));
  }
}

TEST_CASE("Key table: every effect's parameters are keys, with the catalogue's defaults", "[files]") {
  for (const ballpark::EffectDescription& effect : ballpark::effects()) {
    for (const ballpark::ParameterInfo& parameter : effect.parameters) {
      INFO(effect.name + "." + parameter.name);
      const std::vector<const Key*> known = keys_of("effects", effect.name);
      const auto found =
          std::find_if(known.begin(), known.end(), [&](const Key* k) { return k->name == parameter.name; });
      REQUIRE(found != known.end());
      CHECK((*found)->required == !parameter.fallback.has_value());
      CHECK((*found)->unit == parameter.unit);
    }
  }
}

TEST_CASE("Key table: defaults are values that the keys take", "[files]") {
  for (const Key& key : keys()) {
    if (key.fallback.empty() || key.table != "run") continue;
    INFO(key.path() << " = " << key.fallback);
    CHECK(scene_texts::problems_of(scene_texts::run_table + key.name + " = " + key.fallback + "\n").empty());
  }
}

TEST_CASE("Key table: ranges in words", "[files]") {
  CHECK(range_text({}).empty());
  CHECK(range_text({.minimum = 0}) == ">= 0");
  CHECK(range_text({.minimum = 0, .above_minimum = true}) == "> 0");
  CHECK(range_text({.minimum = 0, .maximum = 1}) == "0 to 1");
  CHECK(range_text({.maximum = 2}) == "<= 2");
}
