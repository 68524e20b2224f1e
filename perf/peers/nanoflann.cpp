#include "perf/peers/nanoflann.h"

#if __has_include(<nanoflann.hpp>)
#include <nanoflann.hpp>

namespace ballpark::perf {

namespace {

struct Points {
  const std::vector<double> (&columns)[3];
  std::size_t kdtree_get_point_count() const { return columns[0].size(); }
  double kdtree_get_pt(std::size_t i, std::size_t c) const { return columns[c][i]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points, double>, Points, 3, std::uint32_t>;

/// Collects points with a larger row than the one that asks: no list of all neighbours in between.
struct LaterPoints {
  using DistanceType = double;
  double square;
  std::uint32_t row;
  RowPairs& pairs;
  bool full() const { return true; }
  bool addPoint(double distance, std::uint32_t other) {
    if (distance <= square && other > row) pairs.emplace_back(row, other);
    return true;
  }
  double worstDist() const { return square; }
};

}  // namespace

bool has_nanoflann() {
  return true;
}

bool nanoflann_pairs(const std::vector<double> (&points)[3], double reach, RowPairs& pairs) {
  const Points source{points};
  const Tree tree(3, source, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  pairs.clear();
  for (std::uint32_t row = 0; row < points[0].size(); ++row) {
    const double point[3] = {points[0][row], points[1][row], points[2][row]};
    LaterPoints found{std::nextafter(reach * reach, 2 * reach * reach), row, pairs};
    tree.findNeighbors(found, point, nanoflann::SearchParams());
  }
  return true;
}

}  // namespace ballpark::perf

#else

namespace ballpark::perf {

bool has_nanoflann() {
  return false;
}
bool nanoflann_pairs(const std::vector<double> (&)[3], double, RowPairs&) {
  return false;
}

}  // namespace ballpark::perf

#endif
