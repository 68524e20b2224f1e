#include "scenarios/files/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

#include "scenarios/files/values.h"

namespace ballpark::scenes {

namespace {

/// Thrown inside this file only: what is wrong with an override.
struct Refused {
  std::string message;
};

/// The names between the dots; a name with a dot in it stands in quotes.
std::vector<std::string> segments_of(const std::string& key) {
  std::vector<std::string> segments(1);
  bool quoted = false;
  for (const char letter : key) {
    if (letter == '"') {
      quoted = !quoted;
    } else if (letter == '.' && !quoted) {
      segments.emplace_back();
    } else {
      segments.back() += letter;
    }
  }
  const bool empty = std::any_of(segments.begin(), segments.end(), [](const auto& name) { return name.empty(); });
  if (empty || quoted) throw Refused{"expected a path such as run.step or bodies.NAME.mass"};
  return segments;
}

void move_to(const Place& place, Node& node) {
  node.place = place;
  if (auto* table = std::get_if<Table>(&node.value)) {
    for (Entry& entry : *table) {
      entry.place = place;
      move_to(place, entry.node);
    }
  } else if (auto* array = std::get_if<Array>(&node.value)) {
    for (Node& element : *array) move_to(place, element);
  }
}

bool is_bare_word(const std::string& text) {
  const auto fits = [](unsigned char letter) {
    return std::isalnum(letter) || std::string_view("_-+./").find(static_cast<char>(letter)) != std::string_view::npos;
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), fits);
}

Node value_of(const std::string& text, const Place& place) {
  try {
    Node document = parse_document("value = " + text);
    Table& table = std::get<Table>(document.value);
    if (table.size() != 1) throw Refused{"expected one TOML value"};
    Node value = std::move(table.front().node);
    move_to(place, value);
    return value;
  } catch (const SyntaxError& error) {
    if (is_bare_word(text)) return {text, place};
    throw Refused{fmt::format("\"{}\" is no TOML value: {}", printable(text), error.what())};
  }
}

std::optional<std::size_t> index_of(const std::string& segment, std::size_t size) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(segment.data(), segment.data() + segment.size(), index);
  if (error != std::errc{} || end != segment.data() + segment.size() || index >= size) return std::nullopt;
  return index;
}

Node* element_labelled(Array& array, const std::string& key, const std::string& segment) {
  Node* found = nullptr;
  for (Node& element : array) {
    const auto* table = std::get_if<Table>(&element.value);
    const std::string* text = table ? text_of(*table, key) : nullptr;
    if (!text || *text != segment) continue;
    if (found) throw Refused{fmt::format("several tables have {} \"{}\": address one by its index", key, segment)};
    found = &element;
  }
  return found;
}

/// An element of a list by its name, else its kind, else its index; or null.
Node* element_of(Array& array, const std::string& segment) {
  if (Node* by_name = element_labelled(array, "name", segment)) return by_name;
  if (Node* by_kind = element_labelled(array, "kind", segment)) return by_kind;
  const auto index = index_of(segment, array.size());
  return index ? &array[*index] : nullptr;
}

/// How an element of a list is addressed.
std::string label(const Array& array, std::size_t index) {
  const auto* table = std::get_if<Table>(&array[index].value);
  const std::string* word = table ? text_of(*table, "name") : nullptr;
  if (table && !word) word = text_of(*table, "kind");
  const auto has_it = [&](const Node& element) {
    const auto* other = std::get_if<Table>(&element.value);
    const std::string* kind = other ? text_of(*other, "kind") : nullptr;
    return kind && *kind == *word;
  };
  if (!word || std::count_if(array.begin(), array.end(), has_it) > 1) return std::to_string(index);
  return *word;
}

std::vector<std::string> choices_of(const Node& node) {
  std::vector<std::string> names;
  if (const auto* table = std::get_if<Table>(&node.value)) {
    for (const Entry& entry : *table) names.push_back(entry.key);
  } else if (const auto* array = std::get_if<Array>(&node.value)) {
    for (std::size_t i = 0; i < array->size(); ++i) names.push_back(label(*array, i));
  }
  return names;
}

Node* child_of(Node& node, const std::string& segment) {
  if (auto* array = std::get_if<Array>(&node.value)) return element_of(*array, segment);
  auto* table = std::get_if<Table>(&node.value);
  Entry* entry = table ? find(*table, segment) : nullptr;
  return entry ? &entry->node : nullptr;
}

[[noreturn]] void refuse(const Node& node, const std::string& segment, const std::string& reached) {
  const std::string where = reached.empty() ? "the scene" : reached;
  const std::vector<std::string> choices = choices_of(node);
  if (choices.empty())
    throw Refused{fmt::format("there is no \"{}\" in {}, which is {}", segment, where, describe(node))};
  throw Refused{fmt::format("there is no \"{}\" in {}, expected one of {}{}", segment, where, fmt::join(choices, ", "),
                            hint(segment, choices))};
}

/// A run has a step or a tolerance: to ask for one takes the other out of the scene.
void make_way(const std::string& key, Node& document) {
  const bool step = key == "run.step", tolerance = key == "run.tolerance";
  Node* run = child_of(document, "run");
  if (auto* table = run && (step || tolerance) ? std::get_if<Table>(&run->value) : nullptr) {
    std::erase_if(*table, [&](const Entry& entry) {
      return step ? entry.key == "tolerance" || entry.key == "absolute_tolerance" : entry.key == "step";
    });
  }
}

void apply(const Override& change, const Place& place, Node& document) {
  make_way(change.key, document);
  Node value = value_of(change.value, place);
  const std::vector<std::string> segments = segments_of(change.key);
  Node* node = &document;
  std::string reached;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Node* child = child_of(*node, segments[i]);
    if (!child) {
      auto* table = std::get_if<Table>(&node->value);
      if (!table || i + 1 < segments.size()) refuse(*node, segments[i], reached);
      table->push_back({segments[i], place, std::move(value)});
      return;
    }
    node = child;
    reached += (i ? "." : "") + segments[i];
  }
  *node = std::move(value);
}

}  // namespace

void apply(const std::vector<Override>& overrides, Node& document, Findings& findings) {
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    const Place place{0, 0, static_cast<int>(i)};
    try {
      apply(overrides[i], place, document);
    } catch (const Refused& refused) {
      findings.add(printable(overrides[i].key), place, refused.message);
    }
  }
}

}  // namespace ballpark::scenes
