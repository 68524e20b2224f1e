#include "perf/timing.h"

#include <algorithm>
#include <chrono>

namespace ballpark::perf {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

double seconds_now() {
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

Samples::Samples(std::vector<double> seconds) : sorted_(std::move(seconds)) {
  std::sort(sorted_.begin(), sorted_.end());
}

double Samples::median() const {
  const std::size_t middle = sorted_.size() / 2;
  return sorted_.size() % 2 == 1 ? sorted_[middle] : (sorted_[middle - 1] + sorted_[middle]) / 2;
}

std::vector<Samples> time_interleaved(std::span<const Task> tasks, const Effort& effort) {
  for (const Task& task : tasks) task();
  std::vector<std::vector<double>> seconds(tasks.size());
  const Clock::time_point start = Clock::now();
  for (int round = 0; round < effort.rounds || seconds_since(start) < effort.seconds; ++round) {
    for (std::size_t turn = 0; turn < tasks.size(); ++turn) {
      const std::size_t task = (turn + static_cast<std::size_t>(round)) % tasks.size();
      const Clock::time_point begin = Clock::now();
      tasks[task]();
      seconds[task].push_back(seconds_since(begin));
    }
  }
  return {std::make_move_iterator(seconds.begin()), std::make_move_iterator(seconds.end())};
}

}  // namespace ballpark::perf
