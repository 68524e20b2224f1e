#include "scenarios/files/timetable.h"

#include <algorithm>
#include <cmath>

namespace ballpark::scenes {

Pace::Pace(const RunSettings& run) : step_(run.step), end_(run.duration) {
  if (!by_steps()) return;
  const double exact = run.duration / step_;
  const double nearest_whole = std::round(exact);
  const bool whole = std::abs(exact - nearest_whole) <= 1e-9 * std::max(1.0, exact);
  end_ = whole ? nearest_whole : std::floor(exact);
  remainder_ = whole ? 0 : run.duration - end_ * step_;
}

double Pace::at(double time) const {
  const double place = std::max(0.0, time);
  return std::min(by_steps() ? std::round(place / step_) : place, end_);
}

Occasions::Occasions(std::vector<double> list) : list_(std::move(list)) {
  std::sort(list_.begin(), list_.end());
  list_.erase(std::unique(list_.begin(), list_.end()), list_.end());
}

// More than one in a step are one.
Occasions::Occasions(double period, const Pace& pace)
    : period_(pace.by_steps() ? std::max(1.0, period) : period), end_(pace.end()), whole_(pace.by_steps()) {}

std::optional<double> Occasions::next() const {
  if (period_ == 0) return index_ < list_.size() ? std::optional(list_[index_]) : std::nullopt;
  const double exact = static_cast<double>(index_) * period_;
  const double place = whole_ ? std::round(exact) : exact;
  if (place <= end_) return place;
  return !whole_ && place <= end_ * (1 + 1e-12) ? std::optional(end_) : std::nullopt;
}

void Occasions::pass() {
  ++index_;
}

}  // namespace ballpark::scenes
