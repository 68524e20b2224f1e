// The nearest valid choice for a mistyped word.
#pragma once

#include <string>
#include <vector>

namespace ballpark {

/// The name at the least edit distance (at most a third of the word's length, at least 2), "" if none.
std::string nearest(const std::string& word, const std::vector<std::string>& names);
/// "; did you mean X?", or ", one of a, b, c" if nothing is near.
std::string suggestion(const std::string& word, const std::vector<std::string>& names);
std::string joined(const std::vector<std::string>& words, const char* separator = ", ");

}  // namespace ballpark
