// The key table as a JSON Schema, for editors.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ballpark/catalogue.h"
#include "scenarios/files/keys.h"

namespace ballpark::scenes {

namespace {

using Json = nlohmann::ordered_json;

Json number_schema(const Key& key) {
  Json schema = {{"type", "number"}};
  if (std::isfinite(key.range.minimum)) {
    schema[key.range.above_minimum ? "exclusiveMinimum" : "minimum"] = key.range.minimum;
  }
  if (std::isfinite(key.range.maximum)) schema["maximum"] = key.range.maximum;
  return schema;
}

Json list_of(const Json& items) {
  return {{"type", "array"}, {"items", items}};
}

Json one_or_list_of(const Json& item) {
  Json either;
  either["anyOf"] = Json::array({item, list_of(item)});
  return either;
}

Json row_of(int size, const Json& number) {
  Json row = list_of(number);
  row["minItems"] = row["maxItems"] = size;
  return row;
}

Json word_schema(const Key& key) {
  Json schema = {{"type", "string"}};
  if (!key.choices.empty()) schema["enum"] = key.choices;
  return schema;
}

Json table_schema(const std::string& table, const std::string& effect_kind);

Json value_schema(const Key& key) {
  const Json whole = {{"type", "integer"}, {"minimum", 0}};
  switch (key.type) {
    case KeyType::text:
    case KeyType::word:
      return word_schema(key);
    case KeyType::words:
      return list_of(word_schema(key));
    case KeyType::flag:
      return {{"type", "boolean"}};
    case KeyType::whole:
      return whole;
    case KeyType::wholes:
      return one_or_list_of(whole);
    case KeyType::number:
      return key.choices.empty() ? number_schema(key) : Json{{"anyOf", {number_schema(key), {{"enum", key.choices}}}}};
    case KeyType::numbers:
    case KeyType::numbers_of_pairs:
      return one_or_list_of(number_schema(key));
    case KeyType::times:
      return list_of(number_schema(key));
    case KeyType::vector:
      return row_of(3, number_schema(key));
    case KeyType::vectors:
      return one_or_list_of(row_of(3, number_schema(key)));
    case KeyType::quaternions:
      return one_or_list_of(row_of(4, {{"type", "number"}}));
    case KeyType::pairs:
      return list_of(row_of(2, whole));
    case KeyType::table:
      return table_schema(key.path(), "");
    case KeyType::named:
      return {{"type", "object"}, {"additionalProperties", table_schema(key.path(), "")}};
    case KeyType::tables:
      break;
  }
  if (key.name != "effects") return list_of(table_schema(key.path(), ""));
  Json kinds = Json::array();
  for (const EffectDescription& effect : effects()) kinds.push_back(table_schema("effects", effect.name));
  Json any;
  any["anyOf"] = kinds;
  return list_of(any);
}

Json table_schema(const std::string& table, const std::string& effect_kind) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const Key* key : keys_of(table, effect_kind)) {
    Json schema = value_schema(*key);
    schema["description"] = key->help + (key->unit.empty() ? "" : " [" + key->unit + "]") +
                            (key->fallback.empty() ? "" : " Default: " + key->fallback + ".");
    if (key->path() == "effects.kind") schema["enum"] = Json::array({effect_kind});
    properties[key->name] = std::move(schema);
    if (key->required) required.push_back(key->name);
  }
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

}  // namespace

std::string json_schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Ballpark scene"}};
  schema.update(table_schema("", ""));
  return schema.dump(2);
}

}  // namespace ballpark::scenes
