// The key table in words, and looking keys up in it.
#include <fmt/format.h>

#include <stdexcept>

#include "scenarios/files/key_rows.h"

namespace ballpark::scenes {

namespace {

KeyType type_of(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number:
      return KeyType::number;
    case ParameterKind::vector:
      return KeyType::vector;
    case ParameterKind::vectors:
      return KeyType::vectors;
    case ParameterKind::numbers:
      return KeyType::numbers_of_pairs;
    case ParameterKind::pairs:
      return KeyType::pairs;
    case ParameterKind::word:
      break;
  }
  return KeyType::word;
}

/// As the scene's effects hold it: a lone row is a plain vector, equal for all bodies.
Value effect_value(Parsed parsed) {
  if (auto* number = std::get_if<double>(&parsed)) return *number;
  if (auto* vector = std::get_if<Vector3d>(&parsed)) return *vector;
  if (auto* text = std::get_if<std::string>(&parsed)) return std::move(*text);
  if (auto* pairs = std::get_if<std::vector<IdPair>>(&parsed)) return std::move(*pairs);
  if (auto* numbers = std::get_if<std::vector<double>>(&parsed)) {
    if (numbers->size() == 1) return numbers->front();
    return std::move(*numbers);
  }
  auto rows = std::get<std::vector<Vector3d>>(std::move(parsed));
  if (rows.size() == 1) return rows.front();
  return rows;
}

struct AsToml {
  std::string operator()(double number) const { return fmt::format("{}", number); }
  std::string operator()(const Vector3d& v) const { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); }
  std::string operator()(const IdPair& pair) const { return fmt::format("[{}, {}]", pair[0], pair[1]); }
  template <class T>
  std::string operator()(const std::vector<T>& rows) const {
    std::string text;
    for (const T& row : rows) text += (text.empty() ? "" : ", ") + (*this)(row);
    return "[" + text + "]";
  }
  std::string operator()(const std::string& word) const { return "\"" + word + "\""; }
};

std::string quoted_list(const std::vector<std::string>& words) {
  return fmt::format("\"{}\"", fmt::join(words, "\", \""));
}

}  // namespace

Key::Store on_draft(void (*action)(Draft&, std::string)) {
  return [action](const Owner& owner, Parsed&& value) {
    action(*std::get<Draft*>(owner), std::get<std::string>(std::move(value)));
  };
}

Row parameter_row(const std::string& effect, const ParameterInfo& parameter) {
  const auto store = [name = parameter.name](const Owner& owner, Parsed&& value) {
    std::get<Effect*>(owner)->parameters[name] = effect_value(std::move(value));
  };
  Row row(parameter.name, type_of(parameter.kind), parameter.unit, store, parameter.doc);
  row.of_effect(effect);
  const bool numbers = parameter.kind == ParameterKind::number || parameter.kind == ParameterKind::numbers;
  row.one_of(parameter.choices);
  if (numbers) row.in({.minimum = parameter.minimum, .maximum = parameter.maximum});
  if (!parameter.fallback) return row.must();
  return row.otherwise(std::visit(AsToml{}, *parameter.fallback));
}

std::vector<const Key*> keys_of(const std::string& table, const std::string& effect_kind) {
  std::vector<const Key*> found;
  for (const Key& key : keys()) {
    if (key.table == table && (key.effect.empty() || key.effect == effect_kind)) found.push_back(&key);
  }
  return found;
}

const Key& key(const std::string& table, const std::string& name) {
  for (const Key& candidate : keys()) {
    if (candidate.table == table && candidate.name == name) return candidate;
  }
  throw std::out_of_range("no key " + table + "." + name);
}

std::string range_text(const Range& range) {
  const bool below = range.minimum > -std::numeric_limits<double>::infinity();
  const bool above = range.maximum < std::numeric_limits<double>::infinity();
  if (below && above) return fmt::format("{} to {}", range.minimum, range.maximum);
  if (above) return fmt::format("<= {}", range.maximum);
  if (below) return fmt::format("{} {}", range.above_minimum ? ">" : ">=", range.minimum);
  return "";
}

std::string expected(const Key& key) {
  const std::string range = range_text(key.range);
  const std::string suffix =
      (range.empty() ? "" : " " + range) + (key.unit.empty() || key.unit == "1" ? "" : " [" + key.unit + "]");
  switch (key.type) {
    case KeyType::text:
      return "a text in quotes";
    case KeyType::word:
      return (key.choices.size() > 1 ? "one of " : "") + quoted_list(key.choices);
    case KeyType::words:
      return key.choices.empty() ? "a list of names in quotes" : "a list of " + quoted_list(key.choices);
    case KeyType::flag:
      return "true or false";
    case KeyType::whole:
      return "a whole number >= 0";
    case KeyType::wholes:
      return "a whole number >= 0, or a list of them";
    case KeyType::number:
      return "a number" + suffix + (key.choices.empty() ? "" : ", or " + quoted_list(key.choices));
    case KeyType::numbers:
      return "a number" + suffix + ", or a list with one for each body";
    case KeyType::numbers_of_pairs:
      return "a number" + suffix + ", or a list with one for each pair";
    case KeyType::pairs:
      return "a list of pairs of ids [a, b]";
    case KeyType::times:
      return "a list of numbers" + suffix;
    case KeyType::vector:
      return "[x, y, z]" + suffix;
    case KeyType::vectors:
      return "[x, y, z]" + suffix + ", or a list with one for each body";
    case KeyType::quaternions:
      return "[w, x, y, z], or a list with one for each body";
    case KeyType::table:
      return "a table [" + key.path() + "]";
    case KeyType::tables:
      return "tables, each under [[" + key.path() + "]]";
    case KeyType::named:
      return "tables, each under [" + key.path() + ".NAME]";
  }
  return "";
}

}  // namespace ballpark::scenes
