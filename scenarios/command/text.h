// Numbers and words as people read them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ballpark/scene.h"

namespace ballpark::command {

std::string grouped(std::uint64_t n);                                                   ///< 1,000,000
std::string number(double x, int digits = 6);                                           ///< as %g
std::string seconds(double s);                                                          ///< 12.3 ms
std::string bytes(double n);                                                            ///< 48 MB (powers of 1000)
std::string rate(double per_second);                                                    ///< 12.3 million
std::string counted(std::uint64_t n, const std::string& one, const std::string& many);  ///< 1 body, 2 bodies
std::string joined(const std::vector<std::string>& words, const std::string& separator = ", ");

/// "10 s in steps of 0.001 s, rk4"
std::string pace_text(const RunSettings& run);

/// Characters on a terminal: UTF-8 code points.
std::size_t width(const std::string& text);
/// Lines of at most `limit` characters, broken between words (inside a word only if it is longer than a line).
std::vector<std::string> wrapped(const std::string& text, std::size_t limit);

/// "no integrator 'rk5'; did you mean 'rk4'? (euler, midpoint, rk4)"
std::string no_such(const std::string& what, const std::string& word, const std::vector<std::string>& names);

}  // namespace ballpark::command
