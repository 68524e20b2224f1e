#include "perf/cost/draw/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ballpark::cost::draw {

namespace {

Tick power(int decade, int factor) {
  Tick tick{factor * std::pow(10.0, decade), "10", ""};
  if (factor != 1) tick.label = fmt::format("{}\u00b710", factor);
  if (decade == 0 || decade == 1) {
    tick.label = fmt::format("{}", tick.value);
  } else {
    tick.exponent = fmt::format("{}{}", decade < 0 ? "\u2212" : "", std::abs(decade));
  }
  return tick;
}

Tick time(int decade, int factor) {
  const double value = factor * std::pow(10.0, decade);
  return {value, seconds(value), ""};
}

}  // namespace

double LogAxis::operator()(double value) const {
  const double at = value > 0 ? std::clamp(std::log10(value), low_, high_) : low_;
  return from_ + (to_ - from_) * (at - low_) / (high_ - low_);
}

std::vector<Tick> LogAxis::ticks(double room, Tick (*label)(int, int)) const {
  const double decade_length = std::abs(to_ - from_) / (high_ - low_);
  int every = 1;
  while (every * decade_length < room) every += every < 3 ? 1 : (every == 3 ? 2 : 5);  // 1, 2, 3, 5, 10, 15
  const std::array<int, 3> factors{1, 2, 5};
  const std::size_t used = decade_length * std::log10(2.0) < room ? 1 : factors.size();
  std::vector<Tick> found;
  for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade) {
    for (std::size_t i = 0; i < used; ++i) {
      const double at = decade + std::log10(factors[i]);
      if (at < low_ - 1e-9 || at > high_ + 1e-9) continue;
      Tick tick = label(decade, factors[i]);
      if (decade % every != 0) tick.label = tick.exponent = "";
      found.push_back(tick);
    }
  }
  return found;
}

std::vector<Tick> LogAxis::powers(double room) const {
  return ticks(room, power);
}

std::vector<Tick> LogAxis::times(double room) const {
  return ticks(room, time);
}

Range range_of(const std::vector<double>& values, double margin) {
  if (values.empty()) return {-1, 1};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  Range range{std::log10(*least) - margin, std::log10(*most) + margin};
  const double lack = 1 - (range.high - range.low);
  if (lack > 0) {
    range.low -= lack / 2;
    range.high += lack / 2;
  }
  return range;
}

std::vector<double> round_values(double low, double high, int count) {
  std::vector<double> found;
  const double least = (high - low) / count;
  if (!(least > 0) || !std::isfinite(least)) return found;
  double step = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    if (step * factor < least) continue;
    step *= factor;
    break;
  }
  if (!(step > 1e-12 * std::max(std::abs(low), std::abs(high)))) return found;
  for (double i = std::ceil(low / step); i * step <= high; ++i) found.push_back(i * step + 0.0);  // no -0
  return found;
}

std::string number(double x) {
  if (!std::isfinite(x)) return "?";
  std::string text = fmt::format("{:.3g}", x);
  // 1e-06 as 1e-6
  const std::size_t e = text.find('e');
  while (e != std::string::npos && e + 3 < text.size() && text[e + 2] == '0') text.erase(e + 2, 1);
  return text;
}

std::string seconds(double s) {
  struct Unit {
    double size;
    const char* name;
  };
  constexpr std::array<Unit, 4> units{{{1, "s"}, {1e-3, "ms"}, {1e-6, "us"}, {1e-9, "ns"}}};
  for (const Unit& unit : units) {
    if (s >= unit.size * 0.9995) return fmt::format("{} {}", number(s / unit.size), unit.name);
  }
  return fmt::format("{} ns", number(s / 1e-9));
}

}  // namespace ballpark::cost::draw
