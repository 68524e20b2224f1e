// From a value of the file to the type its key asks for.
#pragma once

#include <string>
#include <variant>

#include "scenarios/files/document.h"
#include "scenarios/files/keys.h"

namespace ballpark::scenes {

/// A value that its key does not take: where, and what was given, expected and perhaps meant.
struct Mismatch {
  Place place;
  std::string message;
};

/// Not for keys that are tables.
std::variant<Parsed, Mismatch> parsed_value(const Key& key, const Node& node);

/// "; did you mean "euler"?", or "" if none of the names is near.
std::string hint(const std::string& word, const std::vector<std::string>& names);

}  // namespace ballpark::scenes
