// When something is due: at whole steps, or with a tolerance at times.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ballpark/scene.h"

namespace ballpark::scenes {

/// A run's axis: step numbers if the step is given, seconds with a tolerance.
class Pace {
 public:
  explicit Pace(const RunSettings& run);
  bool by_steps() const { return step_ > 0; }
  double step() const { return step_; }  ///< [s]
  double end() const { return end_; }
  /// Time that no whole step covers [s]; 0 if the duration is a whole number of steps to 1e-9.
  double remainder() const { return remainder_; }
  /// A time on the axis: the nearest step, or the time; not beyond the end.
  double at(double time) const;
  /// A period on the axis.
  double length(double seconds) const { return by_steps() ? seconds / step_ : seconds; }

 private:
  double step_;
  double end_ = 0;
  double remainder_ = 0;
};

/// Ascending places on the axis without repeats: from a list, or periodic from 0.
class Occasions {
 public:
  explicit Occasions(std::vector<double> list);
  /// The k-th at k `period`, on the axis of steps at the nearest, up to its end.
  Occasions(double period, const Pace& pace);

  std::optional<double> next() const;
  void pass();

 private:
  std::vector<double> list_;
  double period_ = 0;
  double end_ = 0;
  bool whole_ = false;
  std::uint64_t index_ = 0;
};

}  // namespace ballpark::scenes
