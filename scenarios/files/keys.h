// Every key of a scene file, once: the parser, the help and the JSON Schema all come from this table.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "scenarios/files/draft.h"

namespace ballpark::scenes {

/// numbers, vectors, quaternions: one for all bodies of the group, or a list with one for each. times: a list.
/// pairs: a list of [a, b], ids of bodies. numbers_of_pairs: one for all pairs, or a list with one for each.
enum class KeyType {
  text,
  word,
  words,
  flag,
  whole,
  wholes,
  number,
  numbers,
  times,
  vector,
  vectors,
  quaternions,
  numbers_of_pairs,
  pairs,
  table,
  tables,
  named  ///< tables by name: [materials.ball]
};

struct Range {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool above_minimum = false;  ///< the minimum itself is outside
};

struct Key {
  using Store = std::function<void(const Owner&, Parsed&&)>;  ///< of a value
  /// Of a table: what its keys fill. With the table's name, where the scene chooses it.
  using Open = std::function<Owner(const Owner&, const std::string& name)>;

  std::string table;  ///< "" at the top; "bodies.generate" inside it
  std::string name;
  KeyType type = KeyType::text;
  std::string unit;
  std::string help;
  Range range;
  std::vector<std::string> choices;  ///< of a word, or of each of the words
  std::string fallback;              ///< the default, as TOML; "" if there is none
  std::string effect;                ///< only in [[effects]] of this kind; "" in all
  bool required = false;
  Store store;
  Open open;

  std::string path() const { return table.empty() ? name : table + "." + name; }
  bool is_table() const { return type >= KeyType::table; }
};

const std::vector<Key>& keys();
/// The keys of one table, in order; of [[effects]]: the common ones and those of that kind.
std::vector<const Key*> keys_of(const std::string& table, const std::string& effect_kind = "");
/// Throws std::out_of_range.
const Key& key(const std::string& table, const std::string& name);

/// What a key takes, in words: "a number > 0 [kg], or a list with one for each body".
std::string expected(const Key& key);
/// "> 0", ">= 0", "0 to 1"; "" if any number will do.
std::string range_text(const Range& range);

}  // namespace ballpark::scenes
