// nanoflann's k-d tree as a finder of near pairs: built over the points, then asked for each one's neighbours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ballpark::perf {

using RowPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Each pair of points at most `reach` apart, once, into `pairs`. False if built without nanoflann.
bool nanoflann_pairs(const std::vector<double> (&points)[3], double reach, RowPairs& pairs);
bool has_nanoflann();

}  // namespace ballpark::perf
