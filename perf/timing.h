// Timing side by side: what is compared runs in turns, so that a busy or throttled machine slows all alike.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace ballpark::perf {

/// Of a steady clock.
double seconds_now();

/// Wall times of one task, one per round [s].
class Samples {
 public:
  explicit Samples(std::vector<double> seconds);  ///< not empty
  double minimum() const { return sorted_.front(); }
  double median() const;
  double maximum() const { return sorted_.back(); }
  std::size_t count() const { return sorted_.size(); }

 private:
  std::vector<double> sorted_;
};

using Task = std::function<void()>;

/// How long to measure: whole rounds until `seconds` have passed, but at least `rounds`.
struct Effort {
  double seconds = 1;
  int rounds = 9;
};

/// One untimed round, then timed ones. Every round runs each task once, each round starting one task later.
std::vector<Samples> time_interleaved(std::span<const Task> tasks, const Effort& effort);

}  // namespace ballpark::perf
