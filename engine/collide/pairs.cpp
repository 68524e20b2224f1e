// Near pairs from rows sorted by cell. A pair is found from its ball that comes first in the order of cells.
#include <algorithm>

#include "engine/collide/grid.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {
constexpr int most_ranges = 27;
}

/// Pairs of the sorted rows [first, last) with rows that come after them.
void Grid::search(std::size_t first, std::size_t last, Found& found) const {
  Range list[most_ranges];
  for (std::size_t at = first; at < last;) {
    const std::uint32_t key = key_[at];
    const std::size_t end = std::min<std::size_t>(begin_[key + 1], last);
    bool images = false;
    const int count = ranges(key, images, list);
    std::size_t candidates = 0;
    for (int r = 0; r < count; ++r) candidates += list[r].end - list[r].begin + stride;
    for (; at < end; ++at) {
      list[0].begin = static_cast<std::uint32_t>(at) + 1;
      if (found.count + candidates > found.room.size()) {
        found.room.resize(std::max(found.room.size() * 5 / 4, found.count + candidates));
      }
      if (images) {
        collect<true>(static_cast<std::uint32_t>(at), list, count, found);
      } else {
        collect<false>(static_cast<std::uint32_t>(at), list, count, found);
      }
    }
  }
}

/// Where candidates of a cell's balls stand, all at or after the cell; the first range begins with its own balls.
/// `images`: distances may be shorter through the border of a period.
int Grid::ranges(std::uint32_t key, bool& images, Range* list) const {
  const Cell cell{key % axis_[0].cells, key / axis_[0].cells % axis_[1].cells, key / axis_[0].cells / axis_[1].cells};
  const auto at_border = [&](const Axis& axis, std::uint32_t i) {
    return axis.period > 0 && (i == 0 || i + 1 >= axis.cells);
  };
  images = outside_ || at_border(axis_[0], cell.x) || at_border(axis_[1], cell.y) || at_border(axis_[2], cell.z);
  return images ? image_ranges(cell, list) : plain_ranges(cell, list);
}

/// The rest of the row of cells, and four rows of three cells: half of the 27 around.
int Grid::plain_ranges(const Cell& cell, Range* list) const {
  const std::uint32_t nx = axis_[0].cells, ny = axis_[1].cells, nz = axis_[2].cells;
  const std::uint32_t left = cell.x > 0 ? cell.x - 1 : 0, right = std::min(cell.x + 1, nx - 1);
  const auto row = [&](std::uint32_t y, std::uint32_t z) { return (z * ny + y) * nx; };
  const std::uint32_t own = row(cell.y, cell.z);
  int count = 0;
  list[count++] = {begin_[own + cell.x], begin_[own + right + 1]};
  const auto add = [&](std::uint32_t start) { list[count++] = {begin_[start + left], begin_[start + right + 1]}; };
  if (cell.y + 1 < ny) add(row(cell.y + 1, cell.z));
  if (cell.z + 1 == nz) return count;
  if (cell.y > 0) add(row(cell.y - 1, cell.z + 1));
  add(row(cell.y, cell.z + 1));
  if (cell.y + 1 < ny) add(row(cell.y + 1, cell.z + 1));
  return count;
}

/// Cell by cell, each once, through the borders of periods.
int Grid::image_ranges(const Cell& cell, Range* list) const {
  const std::uint32_t centre[3] = {cell.x, cell.y, cell.z};
  std::uint32_t near[3][3];
  int nears[3] = {};
  for (int c = 0; c < 3; ++c) {
    const std::uint32_t n = axis_[c].cells, here = centre[c];
    const auto add = [&](std::uint32_t i) {
      if (std::find(near[c], near[c] + nears[c], i) == near[c] + nears[c]) near[c][nears[c]++] = i;
    };
    const bool repeats = axis_[c].period > 0;
    add(here);
    if (repeats || here + 1 < n) add((here + 1) % n);
    if (repeats || here > 0) add((here + n - 1) % n);
  }
  const auto key_of = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return (z * axis_[1].cells + y) * axis_[0].cells + x;
  };
  const std::uint32_t own = key_of(cell.x, cell.y, cell.z);
  int count = 0;
  for (int z = 0; z < nears[2]; ++z) {
    for (int y = 0; y < nears[1]; ++y) {
      for (int x = 0; x < nears[0]; ++x) {
        const std::uint32_t key = key_of(near[0][x], near[1][y], near[2][z]);
        if (key >= own) list[count++] = {begin_[key], begin_[key + 1]};
      }
    }
  }
  return count;
}

/// Appends every candidate and keeps those that are near: no branch to mispredict. Most ranges hold two or three balls,
/// so they are taken in strides, the last of which may look at rows behind the range.
template <bool images>
void Grid::collect(std::uint32_t ball, const Range* list, int count, Found& found) const {
  const Real x = x_[ball], y = y_[ball], z = z_[ball], radius = radius_[ball];
  const std::uint32_t row = row_[ball];
  Pair* out = found.room.data() + found.count;
  for (int r = 0; r < count; ++r) {
    for (std::uint32_t first = list[r].begin; first < list[r].end; first += stride) {
      for (std::uint32_t j = first; j < first + stride; ++j) {
        Real dx = x_[j] - x, dy = y_[j] - y, dz = z_[j] - z;
        if constexpr (images) {
          dx = nearest_image(dx, period_.length[0]);
          dy = nearest_image(dy, period_.length[1]);
          dz = nearest_image(dz, period_.length[2]);
        }
        *out = {row, row_[j]};
        out += within(dx, dy, dz, radius + radius_[j] + margin_) & (j < list[r].end);
      }
    }
  }
  found.count = static_cast<std::size_t>(out - found.room.data());
}

}  // namespace ballpark::BALLPARK_PRECISION
