// Linear systems whose pattern stays while their values change. A face of plain numbers: what solves them is compiled
// apart (CMakeLists.txt says how), so that no symbol of Eigen's meets those of a user's program.
#pragma once

#include <memory>
#include <vector>

#include "engine/core/real.h"

namespace ballpark::BALLPARK_PRECISION {

class LinearSolver {
 public:
  /// Compressed columns: those of column c are rows[starts[c]], ..., rows[starts[c + 1] - 1], ascending. All rows in
  /// all columns: solved as a dense system, without asking for memory later on.
  LinearSolver(std::vector<int> starts, std::vector<int> rows);
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  int size() const;
  Real* values();  ///< in the order of rows
  /// Replaces b by the solution; false if there is none.
  bool solve(Real* b);

 private:
  struct Matrix;
  std::unique_ptr<Matrix> matrix_;
};

}  // namespace ballpark::BALLPARK_PRECISION
