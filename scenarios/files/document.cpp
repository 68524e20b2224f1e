#include "scenarios/files/document.h"

#include <fmt/format.h>

#include <algorithm>

// The library asserts on some malformed texts ("[=]") that it then reports properly; and it maps TOML_ASSERT to assert
// or, under NDEBUG, to an assumption, which would be undefined behaviour here.
#undef NDEBUG
#define TOML_ASSERT(condition) static_assert(true)
#include <toml++/toml.h>

namespace ballpark::scenes {

namespace {

Place place_of(const toml::source_region& region) {
  return {region.begin.line, region.begin.column, -1};
}

Node converted(const toml::node& source);

Node converted_table(const toml::table& source) {
  Table table;
  for (const auto& [key, value] : source) {
    table.push_back({std::string(key.str()), place_of(key.source()), converted(value)});
  }
  return {std::move(table), place_of(source.source())};
}

Node converted_array(const toml::array& source) {
  Array array;
  array.reserve(source.size());
  for (const toml::node& element : source) array.push_back(converted(element));
  return {std::move(array), place_of(source.source())};
}

Node converted(const toml::node& source) {
  const Place place = place_of(source.source());
  switch (source.type()) {
    case toml::node_type::table:
      return converted_table(*source.as_table());
    case toml::node_type::array:
      return converted_array(*source.as_array());
    case toml::node_type::string:
      return {source.as_string()->get(), place};
    case toml::node_type::integer:
      return {source.as_integer()->get(), place};
    case toml::node_type::floating_point:
      return {source.as_floating_point()->get(), place};
    case toml::node_type::boolean:
      return {source.as_boolean()->get(), place};
    default:
      return {DateOrTime{}, place};
  }
}

struct Describe {
  std::string operator()(const Table&) const { return "a table"; }
  std::string operator()(const Array& array) const {
    if (array.size() > 4) return fmt::format("a list of {}", array.size());
    std::string text;
    for (const Node& node : array) text += (text.empty() ? "" : ", ") + describe(node);
    return "[" + text + "]";
  }
  std::string operator()(const std::string& text) const {
    constexpr std::size_t longest = 60;
    return "\"" + printable(text.size() > longest ? text.substr(0, longest) + "..." : text) + "\"";
  }
  std::string operator()(std::int64_t number) const { return fmt::format("{}", number); }
  std::string operator()(double number) const { return fmt::format("{}", number); }
  std::string operator()(bool flag) const { return flag ? "true" : "false"; }
  std::string operator()(DateOrTime) const { return "a date or time"; }
};

}  // namespace

Node parse_document(std::string_view text) {
  try {
    return converted_table(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw SyntaxError(std::string(error.description()), place_of(error.source()));
  }
}

std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char letter) { return letter < ' ' || letter == 127; }, '?');
  return text;
}

std::string describe(const Node& node) {
  return std::visit(Describe{}, node.value);
}

const Entry* find(const Table& table, std::string_view key) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Entry& entry) { return entry.key == key; });
  return found == table.end() ? nullptr : &*found;
}

Entry* find(Table& table, std::string_view key) {
  return const_cast<Entry*>(find(std::as_const(table), key));
}

const std::string* text_of(const Table& table, std::string_view key) {
  const Entry* entry = find(table, key);
  return entry ? std::get_if<std::string>(&entry->node.value) : nullptr;
}

}  // namespace ballpark::scenes
