// Bodies that come and go. Of one that is not there every value of the state is NaN: no comparison holds for it, no
// search finds it, and passes over rows need no branch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/real.h"

namespace ballpark::BALLPARK_PRECISION {

struct Group;
class Columns;

/// Of a group that bodies enter or leave.
class Presence {
 public:
  explicit operator bool() const { return here_ != nullptr; }
  bool has(std::size_t row) const { return !here_ || here_[row] != 0; }
  /// Is nobody in rows [first, last)? May say no though nobody is.
  bool empty(std::size_t first, std::size_t last) const {
    return here_ && first % block_rows == 0 && last - first <= block_rows && counts_[first / block_rows] == 0;
  }
  std::size_t count() const;

  /// `here`: the rows of a column. `keep_start`: bodies may enter, with the state that they have now.
  void begin(Group& group, Columns& columns, Real* here, bool keep_start);
  /// Rows of one block at a time.
  void leave(std::size_t row);
  void enter(std::size_t row, double flight);
  void wait(std::size_t row) { leave(row); }  ///< until it enters
  void recount();                             ///< after the column changed

 private:
  static constexpr std::size_t block_rows = 4096;
  Real* here_ = nullptr;  ///< 1 or 0; none: all are there all the time
  std::size_t rows_ = 0;
  std::vector<Real*> state_;              ///< arrays of the state, and carries of compensated summation
  std::vector<std::vector<Real>> start_;  ///< of each array
  std::vector<std::uint32_t> counts_;     ///< bodies of each block
};

}  // namespace ballpark::BALLPARK_PRECISION
