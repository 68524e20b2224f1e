// Order conditions of every order, generated rather than listed.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "engine/integrators/rows.h"

namespace ballpark::tests {

/// A rooted tree: indices of its subtrees in the list of all trees. (Hairer, Norsett & Wanner, Solving ODEs I, II.2.)
struct Tree {
  std::vector<std::size_t> subtrees;
  int vertices = 1;
  long double density = 1;  ///< gamma(t), eq. II.2.17
};

/// All rooted trees of up to so many vertices, by their number of vertices: 1, 1, 2, 4, 9, 20, 48, 115, ...
inline std::vector<Tree> rooted_trees(int most) {
  std::vector<Tree> trees{{}};
  for (int vertices = 2; vertices <= most; ++vertices) {
    const std::size_t smaller = trees.size();
    std::vector<std::size_t> chosen;
    const auto choose = [&](const auto& self, std::size_t from, int left) -> void {
      if (left == 0) {
        Tree tree{chosen, vertices, static_cast<long double>(vertices)};
        for (const std::size_t s : chosen) tree.density *= trees[s].density;
        trees.push_back(tree);
        return;
      }
      for (std::size_t s = from; s < smaller; ++s) {
        if (trees[s].vertices > left) continue;
        const int rest = left - trees[s].vertices;
        chosen.push_back(s);
        self(self, s, rest);
        chosen.pop_back();
      }
    };
    choose(choose, 0, vertices - 1);
  }
  return trees;
}

/// The order that weights b of a tableau a with `stages` stages meet, up to `most`: sum b_i Phi_i(t) = 1 / gamma(t) for
/// every tree (theorem II.2.13). Coefficients are good to `precision`.
template <class A>
int order_met(const A& a, const long double* b, int stages, int most, long double precision) {
  const std::vector<Tree> trees = rooted_trees(most);
  const auto size = static_cast<std::size_t>(stages);
  std::vector<std::vector<long double>> inner;  // of each tree: sum_j a_ij Phi_j
  int met = most;
  for (const Tree& tree : trees) {
    std::vector<long double> phi(size, 1), row(size, 0);
    for (const std::size_t s : tree.subtrees) {
      for (std::size_t i = 0; i < size; ++i) phi[i] *= inner[s][i];
    }
    long double sum = 0;
    for (std::size_t i = 0; i < size; ++i) {
      sum += b[i] * phi[i];
      for (std::size_t j = 0; j < size; ++j) row[i] += a[i][j] * phi[j];
    }
    inner.push_back(row);
    if (std::abs(sum - 1 / tree.density) > precision) met = std::min(met, tree.vertices - 1);
  }
  return met;
}

/// R(w) of a Runge-Kutta row on y' = lambda y, w = h lambda: 1 + b^T k, (1 - w A) k = w 1. (HNW II, IV.2 and IV.3)
inline std::complex<long double> stability_function(const f64::Row& row, std::complex<long double> w) {
  const auto n = static_cast<std::size_t>(row.phases);
  using Complex = std::complex<long double>;
  std::vector<std::vector<Complex>> m(n, std::vector<Complex>(n + 1, w));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = (i == j ? 1.0L : 0.0L) - w * row.a[i][j];
  }
  for (std::size_t i = 0; i < n; ++i) {  // explicit rows are triangular already
    for (std::size_t j = 0; j < i; ++j) {
      const Complex factor = m[i][j] / m[j][j];
      for (std::size_t k = j; k <= n; ++k) m[i][k] -= factor * m[j][k];
    }
  }
  Complex next = 1;
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) m[i][n] -= m[i][j] * m[j][n];
    m[i][n] /= m[i][i];
    next += row.b[i] * m[i][n];
  }
  return next;
}

/// A series in two operators that do not commute, drift and kick: a coefficient for each word of up to `most` letters.
/// Word w of n letters is number 2^n - 1 + (its letters as bits).
class OperatorSeries {
 public:
  explicit OperatorSeries(int most) : most_(most), values_((std::size_t{2} << most) - 1, 0) { values_[0] = 1; }

  /// Times exp(c letter), on the right.
  void multiply(int letter, long double c) {
    std::vector<long double> product(values_.size(), 0);
    for (int n = 0; n <= most_; ++n) {
      for (std::size_t w = 0; w < (std::size_t{1} << n); ++w) {
        long double term = values_[index(n, w)];
        std::size_t longer = w;
        for (int m = n; m <= most_; ++m) {
          product[index(m, longer)] += term;
          longer = 2 * longer + static_cast<std::size_t>(letter);
          term *= c / static_cast<long double>(m - n + 1);
        }
      }
    }
    values_ = product;
  }

  /// Up to which length of words is it exp(drift + kick), whose coefficients are 1 / n!?
  int order(long double precision) const {
    long double expected = 1;
    for (int n = 1; n <= most_; ++n) {
      expected /= static_cast<long double>(n);
      for (std::size_t w = 0; w < (std::size_t{1} << n); ++w) {
        if (std::abs(values_[index(n, w)] - expected) > precision) return n - 1;
      }
    }
    return most_;
  }

 private:
  static std::size_t index(int n, std::size_t word) { return (std::size_t{1} << n) - 1 + word; }
  int most_;
  std::vector<long double> values_;
};

/// The order of a splitting, up to `most`, from the Baker-Campbell-Hausdorff conditions as equal words.
inline int splitting_order(const f64::Row& row, int most, long double precision) {
  OperatorSeries series(most);
  series.multiply(0, row.lead);
  for (int i = 0; i < row.phases; ++i) {
    series.multiply(1, row.kick[i]);
    series.multiply(0, row.drift[i]);
  }
  return series.order(precision);
}

}  // namespace ballpark::tests
