// The steps at which something is due.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace ballpark::scenes {

/// Whole steps for times: the nearest.
class Steps {
 public:
  Steps(double duration, double step);
  std::uint64_t count() const { return count_; }
  /// Time that no whole step covers [s]; 0 if the duration is a whole number of steps to 1e-9.
  double remainder() const { return remainder_; }
  std::uint64_t nearest(double time) const;

 private:
  double step_;
  std::uint64_t count_ = 0;
  double remainder_ = 0;
};

/// Ascending steps without repeats: from a list, or periodic from step 0.
class Occasions {
 public:
  explicit Occasions(std::vector<std::uint64_t> steps);
  /// The k-th at the step nearest to k period, up to `last`.
  Occasions(double period_in_steps, std::uint64_t last);

  std::optional<std::uint64_t> next() const;
  void pass();

 private:
  std::vector<std::uint64_t> list_;
  double period_ = 0;
  std::uint64_t last_ = 0;
  std::uint64_t index_ = 0;
};

}  // namespace ballpark::scenes
