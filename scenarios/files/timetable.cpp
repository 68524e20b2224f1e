#include "scenarios/files/timetable.h"

#include <algorithm>
#include <cmath>

namespace ballpark::scenes {

Steps::Steps(double duration, double step) : step_(step) {
  const double exact = duration / step;
  const double nearest_whole = std::round(exact);
  const bool whole = std::abs(exact - nearest_whole) <= 1e-9 * std::max(1.0, exact);
  const double count = whole ? nearest_whole : std::floor(exact);
  count_ = static_cast<std::uint64_t>(count);
  remainder_ = whole ? 0 : duration - count * step;
}

std::uint64_t Steps::nearest(double time) const {
  return std::min(static_cast<std::uint64_t>(std::llround(std::max(0.0, time) / step_)), count_);
}

Occasions::Occasions(std::vector<std::uint64_t> steps) : list_(std::move(steps)) {
  std::sort(list_.begin(), list_.end());
  list_.erase(std::unique(list_.begin(), list_.end()), list_.end());
}

// More than one in a step are one.
Occasions::Occasions(double period_in_steps, std::uint64_t last)
    : period_(std::max(1.0, period_in_steps)), last_(last) {}

std::optional<std::uint64_t> Occasions::next() const {
  if (period_ == 0) return index_ < list_.size() ? std::optional(list_[index_]) : std::nullopt;
  const double step = std::round(static_cast<double>(index_) * period_);
  if (step > static_cast<double>(last_)) return std::nullopt;
  return static_cast<std::uint64_t>(step);
}

void Occasions::pass() {
  ++index_;
}

}  // namespace ballpark::scenes
