// The broad phase: pairs of balls that are near, found in a uniform grid. Rows are sorted by cell with a counting sort,
// in streaming passes over blocks of rows; then each ball looks through its own cell and the neighbours that come after
// it. (Hockney & Eastwood, Computer Simulation Using Particles, 8.4: chaining mesh; Green 2010: sorted rather than
// chained.)
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/collide/near.h"
#include "engine/core/workers.h"

namespace ballpark::BALLPARK_PRECISION {

/// Rows of two near balls.
struct Pair {
  std::uint32_t a, b;
};

class Grid {
 public:
  /// Finds each near pair once. Rows whose position is not finite are in none. The set of pairs does not depend on the
  /// order of rows or the number of threads. No memory is allocated below earlier peaks.
  void find(const Balls& balls, const Period& period, Workers& workers) {
    sort(balls, period, workers);
    search(workers, [](std::size_t, const Pair&) { return true; });
  }

  // Or in two parts, where not every near pair is of use:
  /// Sorts rows into cells, and says in how many blocks pairs will come.
  void sort(const Balls& balls, const Period& period, Workers& workers);
  /// Keeps those near pairs for which keep(block, pair) is true. Blocks run side by side.
  template <class Keep>
  void search(Workers& workers, Keep keep) {
    workers.for_each(found_.size(), [&](std::size_t block) {
      const std::size_t begin = block * block_length, end = std::min(begin + block_length, sorted_);
      Found& found = found_[block];
      for (std::size_t first = begin; first < end; first += strip_length) {  // what is dropped makes room for the next
        std::size_t kept = found.count;
        const std::size_t before = kept;
        search(first, std::min(first + strip_length, end), found);
        found.candidates += found.count - before;
        for (std::size_t i = before; i < found.count; ++i) {
          if (keep(block, found.room[i])) found.room[kept++] = found.room[i];
        }
        found.count = kept;
      }
    });
  }

  /// The pairs, in blocks: those found from one block of sorted rows.
  std::size_t block_count() const { return found_.size(); }
  std::span<const Pair> pairs(std::size_t block) const { return {found_[block].room.data(), found_[block].count}; }
  std::size_t pair_count() const;       ///< kept
  std::size_t candidate_count() const;  ///< near

  /// Rows sorted by cell, those that are not finite last: the order that brings near balls near in memory.
  std::span<const std::uint32_t> order() const { return {row_.data(), key_of_row_.size()}; }
  std::size_t cell_count() const { return cells_; }
  std::size_t bytes() const;  ///< of all buffers

 private:
  using Wide = std::conditional_t<std::is_same_v<Real, float>, double, Real>;
  struct Axis {
    Wide lower = 0, cells_per_metre = 0, period = 0;
    std::uint32_t cells = 1;
    std::uint32_t cell(Wide x) const;
  };
  struct Extent {
    Real lower[3], upper[3], radius;
  };
  struct Found {
    std::vector<Pair> room;
    std::size_t count = 0, candidates = 0;
  };
  struct Range {
    std::uint32_t begin, end;  ///< sorted rows
  };
  static constexpr std::size_t block_length = 4096;  ///< rows of a task
  static constexpr std::size_t strip_length = 128;
  static std::size_t blocks_of(std::size_t rows) { return (rows + block_length - 1) / block_length; }
  static constexpr std::uint32_t stride = 3;  ///< columns of sorted rows are this much longer than the rows
  struct Cell {
    std::uint32_t x, y, z;
  };

  // grid.cpp
  Extent measure(const Balls& balls, Workers& workers);
  void lay_out(const Balls& balls, const Extent& extent, const Period& period);
  void assign(const Balls& balls, const Period& period, Workers& workers);
  void sort_rows(const Balls& balls, Workers& workers);
  // pairs.cpp
  void search(std::size_t first, std::size_t last, Found& found) const;
  int ranges(std::uint32_t key, bool& images, Range* list) const;
  int plain_ranges(const Cell& cell, Range* list) const;
  int image_ranges(const Cell& cell, Range* list) const;
  template <bool images>
  void collect(std::uint32_t ball, const Range* list, int count, Found& found) const;

  Axis axis_[3];
  Period period_;
  bool outside_ = false;  ///< some position lies outside its period: every distance needs its nearest image
  std::size_t cells_ = 1, chunk_ = 1, chunks_ = 1, sorted_ = 0;  ///< sorted_: rows in cells
  Real margin_ = 0;
  std::vector<Extent> extents_;               ///< of each block
  std::vector<std::uint8_t> outside_blocks_;  ///< is a position of the block outside its period?
  std::vector<std::uint32_t> key_of_row_;     ///< cell of each row; cells_: not finite
  std::vector<std::uint32_t> counts_;         ///< of each chunk and cell, then where the chunk writes
  std::vector<std::uint32_t> begin_;          ///< first sorted row of each cell
  std::vector<std::uint32_t> row_, key_;      ///< of each sorted row
  std::vector<Real> x_, y_, z_, radius_;      ///< of each sorted row
  std::vector<Found> found_;
};

}  // namespace ballpark::BALLPARK_PRECISION
