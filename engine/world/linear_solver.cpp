#include "engine/world/linear_solver.h"

#include <Eigen/LU>
#include <Eigen/SparseLU>

namespace ballpark::BALLPARK_PRECISION {

struct LinearSolver::Matrix {
  using Dense = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Sparse = Eigen::SparseMatrix<Real>;

  std::vector<int> starts, rows;
  std::vector<Real> values;
  int size = 0;
  Eigen::PartialPivLU<Dense> dense;
  Eigen::SparseLU<Sparse, Eigen::COLAMDOrdering<int>> sparse;
  Vector solution;

  bool is_full() const { return values.size() == static_cast<std::size_t>(size) * static_cast<std::size_t>(size); }
  Eigen::Map<const Sparse> as_sparse() const {
    return {size, size, static_cast<Eigen::Index>(values.size()), starts.data(), rows.data(), values.data()};
  }
};

LinearSolver::LinearSolver(std::vector<int> starts, std::vector<int> rows) : matrix_(std::make_unique<Matrix>()) {
  Matrix& m = *matrix_;
  m.size = static_cast<int>(starts.size()) - 1;
  m.starts = std::move(starts);
  m.rows = std::move(rows);
  m.values.resize(m.rows.size());
  m.solution.resize(m.size);
  if (m.is_full()) {
    m.dense = Eigen::PartialPivLU<Matrix::Dense>(m.size);
  } else {
    m.sparse.analyzePattern(m.as_sparse());
  }
}

LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

int LinearSolver::size() const {
  return matrix_->size;
}

Real* LinearSolver::values() {
  return matrix_->values.data();
}

bool LinearSolver::solve(Real* b) {
  Matrix& m = *matrix_;
  Eigen::Map<Matrix::Vector> right(b, m.size);
  if (m.is_full()) {
    m.dense.compute(Eigen::Map<const Matrix::Dense>(m.values.data(), m.size, m.size));
    m.solution.noalias() = m.dense.solve(right);
  } else {
    m.sparse.factorize(m.as_sparse());
    if (m.sparse.info() != Eigen::Success) return false;
    m.solution = m.sparse.solve(right);
  }
  right = m.solution;
  return true;
}

}  // namespace ballpark::BALLPARK_PRECISION
