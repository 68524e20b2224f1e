// An octree over the bodies of a copy, so that far ones pull together: by their mass and its second moments about their
// common centre. (Barnes & Hut 1986, Nature 324, 446; groups of near bodies that share one walk: Barnes 1990, J.
// Comput. Phys. 87, 161.) The order of bodies is that of their places, then of ids, so that no order of rows reaches a
// bit.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/aligned_array.h"
#include "engine/effects/pair_effect.h"

namespace ballpark::BALLPARK_PRECISION {

class GravityTree {
 public:
  static constexpr std::size_t group_size = 32;  ///< bodies that share a walk, at most
  /// Below, all pairs are summed: faster there, and Newton's method, which knows pairs alone, takes no more than 200.
  static constexpr std::size_t fewest = 256;

  /// opening_angle: of a cell that is seen as one, its size over its distance, at most.
  explicit GravityTree(Real opening_angle) : opening_angle_(opening_angle) {}

  /// Of bodies that begin at these; those that are not numbers may be anywhere.
  void build(const Real* const (&position)[3], const Real* mass, std::size_t count);

  struct Group {
    std::uint32_t first, last;  ///< bodies, in the order of the tree
  };
  const std::vector<Group>& groups() const { return groups_; }
  std::uint32_t slot(std::size_t body) const { return order_[body].slot; }
  const Real* place(int component, std::size_t body) const { return place_[component].data() + body; }

  /// What pulls at a group: bodies by position and mass, cells by second moments too.
  struct Sources {
    std::vector<Real> points[4], cells[10];  ///< x, y, z, mass; then xx, yy, zz, xy, xz, yz
    void clear();
    std::size_t count() const { return points[0].size() + cells[0].size(); }
  };
  void find_sources(const Group& group, Sources& sources) const;

 private:
  struct Place {
    std::uint64_t key;  ///< of the smallest cell: 21 bits of each coordinate, z y x z y x ...
    std::uint32_t slot;
  };
  struct Box {
    Real low[3], high[3];
  };
  struct Cell {
    std::uint32_t first, last;
    std::uint32_t next = 0;  ///< the cell after all that it holds
    bool is_leaf;
    Real mass = 0, centre[3] = {};  ///< of mass
    Real second[6] = {};            ///< sum of m x x about it
    Real reach = 0;                 ///< from the centre, within which it must be opened
    Box box = {};                   ///< of its bodies
  };
  static constexpr std::size_t leaf_size = 16;
  static constexpr int levels = 21;

  void sort(const Real* const (&position)[3], std::size_t count);
  void add_cell(std::uint32_t first, std::uint32_t last, int level, bool grouped);
  void measure_leaf(Cell& cell) const;
  void measure_parts(std::size_t at);
  void add_groups(std::uint32_t first, std::uint32_t last);
  Box box_of(std::uint32_t first, std::uint32_t last) const;

  Real opening_angle_;
  std::vector<Place> order_;
  std::vector<Cell> cells_;  ///< each before what it holds
  std::vector<Group> groups_;
  AlignedArray<Real> place_[3], mass_;  ///< in the order of the tree, with room for a vector behind the last
};

}  // namespace ballpark::BALLPARK_PRECISION
