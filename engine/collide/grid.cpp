// The grid's cells, and the counting sort of rows into them.
#include "engine/collide/grid.h"

#include <algorithm>
#include <limits>

#include "engine/core/maths.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// Cells are this much wider than the largest reach, so that rounding never puts near balls two cells apart.
constexpr double slack = 1e-5;
/// More cells than this for each ball would cost more to empty than they save.
constexpr std::size_t cells_per_ball = 4;

}  // namespace

std::uint32_t Grid::Axis::cell(Wide x) const {
  if (cells == 1) return 0;
  Wide u = (x - lower) * cells_per_metre;
  if (period > 0) u -= static_cast<Wide>(cells) * std::floor(u / static_cast<Wide>(cells));
  return std::min(static_cast<std::uint32_t>(std::max(u, Wide(0))), cells - 1);
}

void Grid::sort(const Balls& balls, const Period& period, Workers& workers) {
  period_ = period;
  margin_ = balls.margin;
  lay_out(balls, measure(balls, workers), period);
  assign(balls, period, workers);
  sort_rows(balls, workers);
  found_.resize(std::max(blocks_of(sorted_), found_.size()));
  for (Found& found : found_) found.count = found.candidates = 0;
}

std::size_t Grid::pair_count() const {
  std::size_t sum = 0;
  for (const Found& found : found_) sum += found.count;
  return sum;
}

std::size_t Grid::candidate_count() const {
  std::size_t sum = 0;
  for (const Found& found : found_) sum += found.candidates;
  return sum;
}

std::size_t Grid::bytes() const {
  std::size_t words =
      key_of_row_.capacity() + counts_.capacity() + begin_.capacity() + row_.capacity() + key_.capacity();
  for (const Found& found : found_) words += 2 * found.room.capacity();
  return words * sizeof(std::uint32_t) +
         (x_.capacity() + y_.capacity() + z_.capacity() + radius_.capacity()) * sizeof(Real);
}

/// Bounds of the finite positions, and the largest radius.
Grid::Extent Grid::measure(const Balls& balls, Workers& workers) {
  constexpr Real infinite = std::numeric_limits<Real>::infinity();
  constexpr Extent nothing{{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}, 0};
  const auto join = [](Extent& a, const Extent& b) {
    for (int c = 0; c < 3; ++c) {
      a.lower[c] = std::min(a.lower[c], b.lower[c]);
      a.upper[c] = std::max(a.upper[c], b.upper[c]);
    }
    a.radius = std::max(a.radius, b.radius);
  };
  extents_.assign(blocks_of(balls.count), nothing);
  workers.for_each(extents_.size(), [&](std::size_t b) {
    Extent extent = nothing;
    for (std::size_t i = b * block_length; i < std::min((b + 1) * block_length, balls.count); ++i) {
      const Real x = balls.position[0][i], y = balls.position[1][i], z = balls.position[2][i];
      if (!((x - x) + (y - y) + (z - z) == 0)) continue;
      join(extent, {{x, y, z}, {x, y, z}, balls.radius.at<Real>(i)});
    }
    extents_[b] = extent;
  });
  Extent all = nothing;
  for (const Extent& extent : extents_) join(all, extent);
  return all;
}

/// Cells at least as wide as the largest reach, and not too many.
void Grid::lay_out(const Balls& balls, const Extent& extent, const Period& period) {
  const double limit = static_cast<double>(cells_per_ball * balls.count + 64);
  Wide width = (2 * static_cast<Wide>(extent.radius) + balls.margin) * Wide(1 + slack), length[3];
  for (int c = 0; c < 3; ++c) {
    const Wide span = static_cast<Wide>(extent.upper[c]) - extent.lower[c];
    axis_[c].lower = extent.lower[c];
    axis_[c].period = period.length[c];
    length[c] = period.length[c] > 0 ? period.length[c] : span;
    if (!(length[c] > 0 && length[c] < std::numeric_limits<Wide>::max()))
      length[c] = 0;  // no extent, or beyond numbers
  }
  const auto along = [&](int c) {
    const Wide n = length[c] / width;  // open axes end inside their last cell
    return length[c] > 0 ? std::max(std::floor(n) + (axis_[c].period > 0 ? 0 : 1), Wide(1)) : Wide(1);
  };
  if (!(width > 0)) width = std::max({length[0], length[1], length[2], Wide(1)}) / Wide(limit);
  for (Wide all = along(0) * along(1) * along(2); all > limit; all = along(0) * along(1) * along(2)) {
    width *= std::max(maths::cbrt(all / Wide(limit)), Wide(1.01));
  }
  cells_ = 1;
  for (int c = 0; c < 3; ++c) {
    Axis& axis = axis_[c];
    axis.cells = static_cast<std::uint32_t>(along(c));
    axis.cells_per_metre = axis.period > 0 ? static_cast<Wide>(axis.cells) / axis.period : 1 / width;
    cells_ *= axis.cells;
  }
}

/// The cell of each row.
void Grid::assign(const Balls& balls, const Period& period, Workers& workers) {
  key_of_row_.resize(balls.count);
  outside_blocks_.assign(blocks_of(balls.count), 0);
  workers.for_each(outside_blocks_.size(), [&](std::size_t b) {
    bool outside = false;
    for (std::size_t i = b * block_length; i < std::min((b + 1) * block_length, balls.count); ++i) {
      const Real x[3] = {balls.position[0][i], balls.position[1][i], balls.position[2][i]};
      if (!((x[0] - x[0]) + (x[1] - x[1]) + (x[2] - x[2]) == 0)) {
        key_of_row_[i] = static_cast<std::uint32_t>(cells_);
        continue;
      }
      key_of_row_[i] =
          (axis_[2].cell(x[2]) * axis_[1].cells + axis_[1].cell(x[1])) * axis_[0].cells + axis_[0].cell(x[0]);
      for (int c = 0; c < 3; ++c) outside |= period.length[c] > 0 && !(x[c] - axis_[c].lower < period.length[c]);
    }
    outside_blocks_[b] = outside;
  });
  outside_ = std::find(outside_blocks_.begin(), outside_blocks_.end(), 1) != outside_blocks_.end();
}

/// Rows by cell, and by row within a cell. Each chunk of rows counts its own, and then knows where to write.
void Grid::sort_rows(const Balls& balls, Workers& workers) {
  const std::size_t bins = cells_ + 1;
  chunks_ = static_cast<std::size_t>(std::clamp(workers.threads(), 1, 16));
  chunk_ = (balls.count + chunks_ - 1) / chunks_;
  counts_.assign(chunks_ * bins, 0);
  const auto for_rows = [&](std::size_t chunk, auto act) {
    std::uint32_t* counts = counts_.data() + chunk * bins;
    for (std::size_t i = chunk * chunk_; i < std::min((chunk + 1) * chunk_, balls.count); ++i) act(i, counts);
  };
  workers.for_each(chunks_, [&](std::size_t chunk) {
    for_rows(chunk, [&](std::size_t i, std::uint32_t* counts) { ++counts[key_of_row_[i]]; });
  });
  begin_.resize(bins + 1);
  std::uint32_t before = 0;
  for (std::size_t cell = 0; cell < bins; ++cell) {
    begin_[cell] = before;
    for (std::size_t chunk = 0; chunk < chunks_; ++chunk) {
      const std::uint32_t here = counts_[chunk * bins + cell];
      counts_[chunk * bins + cell] = before;
      before += here;
    }
  }
  begin_[bins] = before;
  sorted_ = begin_[cells_];
  for (auto* column : {&row_, &key_}) column->resize(balls.count + stride);
  for (auto* column : {&x_, &y_, &z_, &radius_}) column->resize(balls.count + stride);
  workers.for_each(chunks_, [&](std::size_t chunk) {
    for_rows(chunk, [&](std::size_t i, std::uint32_t* counts) {
      const std::uint32_t at = counts[key_of_row_[i]]++;
      row_[at] = static_cast<std::uint32_t>(i);
      key_[at] = key_of_row_[i];
      x_[at] = balls.position[0][i];
      y_[at] = balls.position[1][i];
      z_[at] = balls.position[2][i];
      radius_[at] = balls.radius.at<Real>(i);
    });
  });
}

}  // namespace ballpark::BALLPARK_PRECISION
