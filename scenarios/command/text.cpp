#include "scenarios/command/text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "ballpark/catalogue.h"

namespace ballpark::command {
namespace {

using Step = std::pair<double, const char*>;

/// `x` in the largest unit that it reaches, to three digits; plain in the last one.
template <std::size_t n>
std::string in_units(double x, const std::array<Step, n>& units) {
  for (const auto& [size, unit] : units) {
    if (x >= size * 0.9995) return fmt::format("{:.3g} {}", x / size, unit);
  }
  return fmt::format("{:.3g} {}", x / units.back().first, units.back().second);
}

std::size_t bytes_of_character(unsigned char lead) {
  if (lead < 0xC0) return 1;
  if (lead < 0xE0) return 2;
  return lead < 0xF0 ? 3 : 4;
}

/// Cuts the first `limit` characters off `word`.
std::string cut(std::string& word, std::size_t limit) {
  std::size_t end = 0;
  for (std::size_t i = 0; i < limit && end < word.size(); ++i) end += bytes_of_character(word[end]);
  std::string head = word.substr(0, end);
  word.erase(0, head.size());
  return head;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (char c : text + " ") {
    if (c != ' ' && c != '\n' && c != '\t') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, ""));
    }
  }
  return words;
}

}  // namespace

std::string grouped(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

std::string number(double x, int digits) {
  return std::isnan(x) ? "nan" : fmt::format("{:.{}g}", x, digits);  // never "-nan"
}

std::string seconds(double s) {
  if (s == 0) return "0 s";
  if (s >= 120) return fmt::format("{:.0f} min {:.0f} s", std::floor(s / 60), std::floor(std::fmod(s, 60)));
  return in_units(s, std::array<Step, 4>{{{1, "s"}, {1e-3, "ms"}, {1e-6, "us"}, {1e-9, "ns"}}});
}

std::string bytes(double n) {
  return in_units(n, std::array<Step, 5>{{{1e12, "TB"}, {1e9, "GB"}, {1e6, "MB"}, {1e3, "kB"}, {1, "B"}}});
}

std::string rate(double per_second) {
  if (per_second < 9995) return fmt::format("{:.3g}", per_second);
  return in_units(per_second, std::array<Step, 3>{{{1e9, "billion"}, {1e6, "million"}, {1e3, "thousand"}}});
}

std::string counted(std::uint64_t n, const std::string& one, const std::string& many) {
  return grouped(n) + " " + (n == 1 ? one : many);
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  return fmt::format("{}", fmt::join(words, separator));
}

std::string pace_text(const RunSettings& run) {
  const std::string pace =
      run.tolerance > 0 ? "at a tolerance of " + number(run.tolerance) : "in steps of " + number(run.step) + " s";
  return fmt::format("{} s {}, {}", number(run.duration), pace, run.integrator);
}

std::size_t width(const std::string& text) {
  std::size_t n = 0;
  for (unsigned char c : text) n += (c & 0xC0) != 0x80;
  return n;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t limit) {
  if (limit == 0) limit = 1;
  std::vector<std::string> lines(1);
  for (std::string word : words_of(text)) {
    const std::size_t used = width(lines.back());
    if (used > 0 && used + 1 + width(word) > limit) lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    while (width(word) > limit) {
      lines.back() += cut(word, limit);
      lines.emplace_back();
    }
    lines.back() += word;
  }
  return lines;
}

std::string no_such(const std::string& what, const std::string& word, const std::vector<std::string>& names) {
  const std::string near = nearest(word, names);
  const std::string hint = near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
  return fmt::format("no {} '{}'{} ({})", what, word, hint, joined(names));
}

}  // namespace ballpark::command
