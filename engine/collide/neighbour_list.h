// Neighbours kept over many steps: pairs whose surfaces are no farther apart than a skin, found in the grid again only
// when a body has used up its share of the skin. (Verlet 1967, Phys. Rev. 159, 98.)
#pragma once

#include "engine/collide/grid.h"
#include "engine/collide/vector_column.h"

namespace ballpark::BALLPARK_PRECISION {

class NeighbourList {
 public:
  // Pairs lie in the order of their slots a < b.
  std::vector<std::uint32_t> first;               ///< of each slot: its first pair as a, and the end
  std::vector<std::uint32_t> other;               ///< b of each pair
  std::vector<std::uint32_t> first_lower, lower;  ///< of each slot: its pairs as b, in the order of a

  /// Does every body still have all its neighbours after it has moved by `ahead` more [m]?
  bool holds(const VectorColumn& position, const Period& period, const std::vector<Real>& ahead, Workers& workers);
  /// Lists pairs up to radius + allowance of both, for each `per_copy` slots on their own.
  void build(const VectorColumn& position, const std::vector<Real>& radius, const std::vector<Real>& allowance,
             std::size_t per_copy, const Period& period, Workers& workers);
  std::size_t candidates() const { return other.size(); }
  std::size_t bytes() const;

 private:
  void order(std::size_t slots);

  Grid grid_;
  VectorColumn built_;           ///< positions when the list was built [m]
  std::vector<Real> allowance_;  ///< how far each body may go until then [m]
  std::vector<Real> reach_;
  std::vector<Pair> found_;
  std::vector<std::uint8_t> block_holds_;
};

}  // namespace ballpark::BALLPARK_PRECISION
