// Axes: logarithmic ones, their ticks, and quantities as people read them.
#pragma once

#include <string>
#include <vector>

namespace ballpark::cost::draw {

struct Tick {
  double value = 0;
  std::string label, exponent;  ///< "10" and "-8"; a tick without label is small
};

/// Maps values to coordinates. What lies beyond an end, or is zero, is put on that end.
class LogAxis {
 public:
  /// `low` and `high`: decimal logarithms of the ends; `from` and `to`: where they are drawn.
  LogAxis(double low, double high, double from, double to) : low_(low), high_(high), from_(from), to_(to) {}
  double operator()(double value) const;
  double low() const { return low_; }
  double high() const { return high_; }
  /// Labels at least `room` apart; between decades too if there are few of them.
  std::vector<Tick> powers(double room) const;
  std::vector<Tick> times(double room) const;  ///< 10 us, 1 ms

 private:
  std::vector<Tick> ticks(double room, Tick (*label)(int decade, int factor)) const;
  double low_, high_, from_, to_;
};

/// Room around values (all above 0), as logarithms: `margin` decades on both sides and at least a decade in all.
struct Range {
  double low = 0, high = 0;
};
Range range_of(const std::vector<double>& values, double margin);

/// Round values within [low, high], at most `count` or so.
std::vector<double> round_values(double low, double high, int count);

std::string number(double x);   ///< three digits, 1e-6
std::string seconds(double s);  ///< 12.3 us

}  // namespace ballpark::cost::draw
