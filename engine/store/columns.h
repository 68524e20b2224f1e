// Every array of a world, in one list: build, hash, snapshot and explain go through it.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "engine/core/aligned_array.h"
#include "engine/core/real.h"

namespace ballpark::BALLPARK_PRECISION {

/// state: integrated. kept: what a step leaves to the next one. rate, sum: scratch of a step. constant: set at build.
enum class Role { state, kept, rate, sum, constant };

struct ColumnInfo {
  std::string name;
  std::string unit;
  int components = 1;
  Role role = Role::state;
  std::string why;  ///< who asked for it
};

/// Rows are padded to this many: the lanes of every target divide it.
inline constexpr std::size_t row_alignment = 32;
constexpr std::size_t padded(std::size_t rows) {
  return (rows + row_alignment - 1) / row_alignment * row_alignment;
}

/// One quantity for the rows [first_row, first_row + rows); its components are arrays of their own.
class Column {
 public:
  Column(ColumnInfo column_info, std::size_t first, std::size_t count)
      : info(std::move(column_info)), first_row(first), rows(count) {
    for (int c = 0; c < info.components; ++c) arrays_.emplace_back(count);
  }
  /// Component c at world row `row`.
  Real* at(int c, std::size_t row) { return arrays_[static_cast<std::size_t>(c)].data() + (row - first_row); }
  const Real* at(int c, std::size_t row) const {
    return arrays_[static_cast<std::size_t>(c)].data() + (row - first_row);
  }
  bool covers(std::size_t row) const { return row >= first_row && row < first_row + rows; }
  std::size_t bytes() const { return rows * sizeof(Real) * static_cast<std::size_t>(info.components); }

  const ColumnInfo info;
  const std::size_t first_row, rows;

 private:
  std::vector<AlignedArray<Real>> arrays_;
};

class Columns {
 public:
  /// Columns stay where they are for the life of the world.
  Column& add(ColumnInfo info, std::size_t first_row, std::size_t rows);
  /// The column of that name that covers the row, or nullptr.
  Column* find(const std::string& name, std::size_t row);
  const Column* find(const std::string& name, std::size_t row) const;
  const std::deque<Column>& all() const { return columns_; }
  std::deque<Column>& all() { return columns_; }
  std::size_t bytes() const;
  /// All columns of a role, one after the other.
  void save(Role role, std::vector<Real>& to) const;
  void restore(Role role, const std::vector<Real>& from);

 private:
  std::deque<Column> columns_;
};

const char* name(Role role);

}  // namespace ballpark::BALLPARK_PRECISION
