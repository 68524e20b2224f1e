// The key table as help text.
#include <fmt/format.h>

#include "ballpark/catalogue.h"
#include "scenarios/files/keys.h"

namespace ballpark::scenes {

namespace {

std::string facts_of(const Key& key) {
  std::string facts = expected(key);
  if (!key.fallback.empty()) facts += "; default " + key.fallback;
  if (key.required) facts += "; required";
  return facts;
}

/// As the key's table stands in a file: [run], [[bodies]], generate = { ... }.
std::string heading(const Key& key) {
  if (key.type == KeyType::tables) return "[[" + key.path() + "]]";
  if (key.type == KeyType::named) return "[" + key.path() + ".NAME]";
  return key.table.empty() ? "[" + key.name + "]" : key.name + " = { ... } in [[" + key.table + "]]";
}

std::string rows_of(const std::vector<const Key*>& rows) {
  std::string text;
  for (const Key* key : rows) {
    if (key->is_table()) continue;
    text += fmt::format("  {:<24} {}\n  {:<24} ({})\n", key->name, key->help, "", facts_of(*key));
  }
  return text;
}

std::string effect_sections() {
  std::string text;
  for (const EffectDescription& effect : effects()) {
    std::vector<const Key*> parameters;
    for (const Key* key : keys_of("effects", effect.name)) {
      if (!key->effect.empty()) parameters.push_back(key);
    }
    text += fmt::format("\nkind = \"{}\" in [[effects]]: {}\n{}", effect.name, effect.doc, rows_of(parameters));
  }
  return text;
}

std::string section(const Key& key) {
  std::string text = fmt::format("\n{}: {}\n{}", heading(key), key.help, rows_of(keys_of(key.path())));
  if (key.name == "effects") text += effect_sections();
  for (const Key* inner : keys_of(key.path())) {
    if (inner->is_table()) text += section(*inner);
  }
  return text;
}

}  // namespace

std::string key_help() {
  std::string text = "A scene file is TOML; units are SI.\n\nAt the top\n" + rows_of(keys_of(""));
  for (const Key* key : keys_of("")) {
    if (key->is_table()) text += section(*key);
  }
  return text;
}

}  // namespace ballpark::scenes
