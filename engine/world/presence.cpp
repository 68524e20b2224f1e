#include "engine/world/presence.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "engine/store/columns.h"
#include "engine/world/group.h"

namespace ballpark::BALLPARK_PRECISION {

void Presence::begin(Group& group, Columns& columns, Real* here, bool keep_start) {
  static_assert(block_rows == block_length);
  here_ = here;
  rows_ = group.live;
  std::fill(here_, here_ + rows_, Real(1));
  for (Column& column : columns.all()) {
    if (column.info.role != Role::state || !column.covers(group.first_row)) continue;
    for (int c = 0; c < column.info.components; ++c) {
      state_.push_back(column.at(c, group.first_row));
      if (keep_start) start_.emplace_back(state_.back(), state_.back() + rows_);
    }
  }
  recount();
}

void Presence::recount() {
  if (!here_) return;
  counts_.assign((rows_ + block_rows - 1) / block_rows, 0);
  for (std::size_t row = 0; row < rows_; ++row) counts_[row / block_rows] += here_[row] != 0;
}

std::size_t Presence::count() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::size_t{0});
}

void Presence::leave(std::size_t row) {
  counts_[row / block_rows] -= here_[row] != 0;
  here_[row] = 0;
  for (Real* values : state_) values[row] = std::numeric_limits<Real>::quiet_NaN();
}

/// position and velocity are the first arrays, see World::add_state_columns.
void Presence::enter(std::size_t row, double flight) {
  counts_[row / block_rows] += here_[row] == 0;
  here_[row] = 1;
  for (std::size_t i = 0; i < state_.size(); ++i) state_[i][row] = start_[i][row];
  for (std::size_t c = 0; c < 3; ++c) state_[c][row] += static_cast<Real>(flight) * state_[c + 3][row];
}

}  // namespace ballpark::BALLPARK_PRECISION
