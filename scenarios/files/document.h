// A TOML text as a plain tree that knows where each key and value stands. document.cpp is the only door to the TOML
// library.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ballpark::scenes {

/// Line and column in the scene file, or the override (its index) that brought the value.
struct Place {
  std::size_t line = 0, column = 0;
  int override_index = -1;
};

struct Node;
struct Entry;
using Table = std::vector<Entry>;
using Array = std::vector<Node>;

struct DateOrTime {};

struct Node {
  std::variant<Table, Array, std::string, std::int64_t, double, bool, DateOrTime> value;
  Place place;
};

struct Entry {
  std::string key;
  Place place;
  Node node;
};

class SyntaxError : public std::runtime_error {
 public:
  SyntaxError(const std::string& message, Place place) : std::runtime_error(message), place_(place) {}
  const Place& place() const { return place_; }

 private:
  Place place_;
};

/// The whole document as a table. Throws SyntaxError.
Node parse_document(std::string_view text);

/// What a value is, in a few words, for messages: `"heavy"`, `3 values`, `a table`.
std::string describe(const Node& node);

/// Without control codes: a message is one line, and no file may command a terminal.
std::string printable(std::string text);

/// The entry of that name, or null.
Entry* find(Table& table, std::string_view key);
const Entry* find(const Table& table, std::string_view key);
/// The text under that key, or null if there is none.
const std::string* text_of(const Table& table, std::string_view key);

}  // namespace ballpark::scenes
