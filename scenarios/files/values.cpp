#include "scenarios/files/values.h"

#include <fmt/format.h>

#include <algorithm>

#include "ballpark/catalogue.h"

namespace ballpark::scenes {

namespace {

/// Thrown inside this file only: the node that is not what the key takes.
struct Unfit {
  const Node& node;
  std::string row;  ///< "row 3 is ", where the value is a list
  std::string hint;
};

const Array& array_of(const Node& node) {
  const auto* array = std::get_if<Array>(&node.value);
  if (!array) throw Unfit{node, {}, {}};
  return *array;
}

double number_of(const Node& node) {
  if (const auto* whole = std::get_if<std::int64_t>(&node.value)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&node.value)) return *number;
  throw Unfit{node, {}, {}};
}

std::uint64_t whole_of(const Node& node) {
  const auto* whole = std::get_if<std::int64_t>(&node.value);
  if (!whole || *whole < 0) throw Unfit{node, {}, {}};
  return static_cast<std::uint64_t>(*whole);
}

std::string text_of(const Node& node) {
  const auto* text = std::get_if<std::string>(&node.value);
  if (!text) throw Unfit{node, {}, {}};
  return *text;
}

bool flag_of(const Node& node) {
  const auto* flag = std::get_if<bool>(&node.value);
  if (!flag) throw Unfit{node, {}, {}};
  return *flag;
}

template <std::size_t n>
const Array& row_of(const Node& node) {
  const Array& row = array_of(node);
  if (row.size() != n) throw Unfit{node, {}, {}};
  return row;
}

Vector3d vector_of(const Node& node) {
  const Array& row = row_of<3>(node);
  return {number_of(row[0]), number_of(row[1]), number_of(row[2])};
}

Quaternion quaternion_of(const Node& node) {
  const Array& row = row_of<4>(node);
  return {number_of(row[0]), number_of(row[1]), number_of(row[2]), number_of(row[3])};
}

IdPair pair_of(const Node& node) {
  const Array& row = row_of<2>(node);
  return {whole_of(row[0]), whole_of(row[1])};
}

template <class Read>
auto list_of(const Node& node, Read read) {
  std::vector<decltype(read(node))> list;
  const Array& array = array_of(node);
  list.reserve(array.size());
  for (std::size_t i = 0; i < array.size(); ++i) {
    try {
      list.push_back(read(array[i]));
    } catch (const Unfit& unfit) {
      const char* verb = &unfit.node == &array[i] ? "is" : "holds";
      throw Unfit{unfit.node, fmt::format("row {} {} ", i, verb), unfit.hint};
    }
  }
  return list;
}

/// One for all bodies, or one for each: it is a list if it is an array, and of vectors if its first element is one.
template <class Read>
auto one_or_list_of(const Node& node, Read read, bool is_list) {
  if (is_list) return list_of(node, read);
  return std::vector{read(node)};
}

bool is_array(const Node& node) {
  return std::holds_alternative<Array>(node.value);
}

bool is_array_of_arrays(const Node& node) {
  const auto* array = std::get_if<Array>(&node.value);
  return array && (array->empty() || is_array(array->front()));
}

std::string word_of(const Node& node, const Key& key) {
  const std::string word = text_of(node);
  const bool known =
      key.choices.empty() || std::find(key.choices.begin(), key.choices.end(), word) != key.choices.end();
  if (!known) throw Unfit{node, {}, hint(word, key.choices)};
  return word;
}

Parsed parsed(const Key& key, const Node& node) {
  switch (key.type) {
    case KeyType::text:
      return text_of(node);
    case KeyType::word:
      return word_of(node, key);
    case KeyType::words:
      return list_of(node, [&](const Node& element) { return word_of(element, key); });
    case KeyType::flag:
      return flag_of(node);
    case KeyType::whole:
      return whole_of(node);
    case KeyType::wholes:
      return one_or_list_of(node, whole_of, is_array(node));
    case KeyType::number:
      if (!key.choices.empty() && std::holds_alternative<std::string>(node.value)) return word_of(node, key);
      return number_of(node);
    case KeyType::numbers:
    case KeyType::numbers_of_pairs:
      return one_or_list_of(node, number_of, is_array(node));
    case KeyType::times:
      return list_of(node, number_of);
    case KeyType::vector:
      return vector_of(node);
    case KeyType::vectors:
      return one_or_list_of(node, vector_of, is_array_of_arrays(node));
    case KeyType::pairs:
      return list_of(node, pair_of);
    case KeyType::quaternions:
      return one_or_list_of(node, quaternion_of, is_array_of_arrays(node));
    case KeyType::table:
    case KeyType::tables:
    case KeyType::named:
      break;
  }
  throw Unfit{node, {}, {}};
}

}  // namespace

std::variant<Parsed, Mismatch> parsed_value(const Key& key, const Node& node) {
  try {
    return parsed(key, node);
  } catch (const Unfit& unfit) {
    const std::string subject = !unfit.row.empty() ? unfit.row : &unfit.node == &node ? "is " : "holds ";
    return Mismatch{unfit.node.place, subject + describe(unfit.node) + ", expected " + expected(key) + unfit.hint};
  }
}

std::string hint(const std::string& word, const std::vector<std::string>& names) {
  const std::string near = nearest(word, names);
  return near.empty() ? "" : "; did you mean \"" + near + "\"?";
}

}  // namespace ballpark::scenes
