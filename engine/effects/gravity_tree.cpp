#include "engine/effects/gravity_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// The lowest 21 bits, each followed by two zeros. (Warren & Salmon 1993, A parallel hashed oct-tree.)
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

bool is_number(Real x) {
  return std::abs(x) <= std::numeric_limits<Real>::max();
}

/// Adds m x x, x from `centre` to `point`, and what stands about that point already.
void add_moments(Real m, const Real* point, const Real* own, const Real* centre, Real* sum) {
  const Real x = point[0] - centre[0], y = point[1] - centre[1], z = point[2] - centre[2];
  const Real moments[6] = {x * x, y * y, z * z, x * y, x * z, y * z};
  for (int k = 0; k < 6; ++k) sum[k] += m * moments[k] + own[k];
}

}  // namespace

void GravityTree::Sources::clear() {
  for (std::vector<Real>& column : points) column.clear();
  for (std::vector<Real>& column : cells) column.clear();
}

void GravityTree::build(const Real* const (&position)[3], const Real* mass, std::size_t count) {
  sort(position, count);
  if (mass_.size() < count + cache_line) {
    for (AlignedArray<Real>& column : place_) column = AlignedArray<Real>(count + cache_line);
    mass_ = AlignedArray<Real>(count + cache_line);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t from = order_[i].slot;
    for (int c = 0; c < 3; ++c) place_[c].data()[i] = position[c][from];
    mass_.data()[i] = mass[from];
  }
  cells_.clear();
  groups_.clear();
  add_cell(0, static_cast<std::uint32_t>(count), 0, false);
}

/// Bodies by their cells, then by slot.
void GravityTree::sort(const Real* const (&position)[3], std::size_t count) {
  constexpr auto most = static_cast<Real>((1 << levels) - 1);
  Real low[3], largest = 0;
  for (int c = 0; c < 3; ++c) {
    Real high = -std::numeric_limits<Real>::max();
    low[c] = std::numeric_limits<Real>::max();
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_number(position[c][i])) continue;
      low[c] = std::min(low[c], position[c][i]);
      high = std::max(high, position[c][i]);
    }
    largest = std::max(largest, high - low[c]);
  }
  const Real scale = largest > 0 && is_number(largest) ? most / largest : 0;
  const auto part = [&](int c, std::size_t i) {
    const Real at = (position[c][i] - low[c]) * scale;  // no number fails the comparison
    return spread(static_cast<std::uint64_t>(at > 0 ? std::min(at, most) : 0));
  };
  order_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    order_[i] = {part(2, i) << 2 | part(1, i) << 1 | part(0, i), static_cast<std::uint32_t>(i)};
  }
  std::sort(order_.begin(), order_.end(),
            [](const Place& a, const Place& b) { return a.key != b.key ? a.key < b.key : a.slot < b.slot; });
}

/// `grouped`: what holds it is a group already.
void GravityTree::add_cell(std::uint32_t first, std::uint32_t last, int level, bool grouped) {
  const std::size_t at = cells_.size();
  const bool is_leaf = last - first <= leaf_size || level == levels;
  cells_.push_back({.first = first, .last = last, .is_leaf = is_leaf});
  if (is_leaf) measure_leaf(cells_[at]);
  if (!grouped && (is_leaf || last - first <= group_size)) {
    add_groups(first, last);
    grouped = true;
  }
  const int shift = 3 * (levels - 1 - level);
  for (std::uint32_t begin = first; !is_leaf && begin < last;) {
    const std::uint64_t child = order_[begin].key >> shift;
    const auto end = std::partition_point(order_.begin() + begin, order_.begin() + last,
                                          [&](const Place& place) { return place.key >> shift == child; });
    const auto after = static_cast<std::uint32_t>(end - order_.begin());
    add_cell(begin, after, level + 1, grouped);
    begin = after;
  }
  cells_[at].next = static_cast<std::uint32_t>(cells_.size());
  if (!is_leaf) measure_parts(at);
  // Opened nearer than its size over the opening angle, and the way from its middle to its centre of mass more: else a
  // cell with its mass in a corner were seen as one from beside it. (Barnes 1994, in Computational Astrophysics)
  Cell& cell = cells_[at];
  Real size = 0, off_middle = 0;
  for (int c = 0; c < 3; ++c) {
    const Real off = cell.centre[c] - Real(0.5) * (cell.box.high[c] + cell.box.low[c]);
    size = std::max(size, cell.box.high[c] - cell.box.low[c]);
    off_middle += off * off;
  }
  cell.reach = size / opening_angle_ + std::sqrt(off_middle);
}

void GravityTree::add_groups(std::uint32_t first, std::uint32_t last) {
  for (; first < last; first += group_size) {
    groups_.push_back({first, std::min<std::uint32_t>(last, first + group_size)});
  }
}

GravityTree::Box GravityTree::box_of(std::uint32_t first, std::uint32_t last) const {
  Box box;
  for (int c = 0; c < 3; ++c) {
    const auto [least, most] = std::minmax_element(place(c, first), place(c, last));
    box.low[c] = *least, box.high[c] = *most;
  }
  return box;
}

void GravityTree::measure_leaf(Cell& cell) const {
  const Real* mass = mass_.data();
  for (std::uint32_t i = cell.first; i < cell.last; ++i) {
    for (int c = 0; c < 3; ++c) cell.centre[c] += mass[i] * *place(c, i);
    cell.mass += mass[i];
  }
  for (Real& c : cell.centre) c /= cell.mass;
  constexpr Real none[6] = {};
  for (std::uint32_t i = cell.first; i < cell.last; ++i) {
    const Real point[3] = {*place(0, i), *place(1, i), *place(2, i)};
    add_moments(mass[i], point, none, cell.centre, cell.second);
  }
  cell.box = box_of(cell.first, cell.last);
}

/// Of the cells that it holds.
void GravityTree::measure_parts(std::size_t at) {
  Cell& cell = cells_[at];
  cell.box = cells_[at + 1].box;
  const auto for_parts = [&](auto act) {
    for (std::size_t part = at + 1; part < cell.next; part = cells_[part].next) act(cells_[part]);
  };
  for_parts([&](const Cell& part) {
    for (int c = 0; c < 3; ++c) {
      cell.centre[c] += part.mass * part.centre[c];
      cell.box.low[c] = std::min(cell.box.low[c], part.box.low[c]);
      cell.box.high[c] = std::max(cell.box.high[c], part.box.high[c]);
    }
    cell.mass += part.mass;
  });
  for (Real& c : cell.centre) c /= cell.mass;
  for_parts([&](const Cell& part) { add_moments(part.mass, part.centre, part.second, cell.centre, cell.second); });
}

void GravityTree::find_sources(const Group& group, Sources& sources) const {
  const Box box = box_of(group.first, group.last);
  for (std::uint32_t at = 0; at < cells_.size();) {
    const Cell& cell = cells_[at];
    Real away = 0;  // from the nearest place of the group, squared
    for (int c = 0; c < 3; ++c) {
      const Real beyond = std::max({box.low[c] - cell.centre[c], cell.centre[c] - box.high[c], Real(0)});
      away += beyond * beyond;
    }
    if (away > cell.reach * cell.reach) {
      for (int c = 0; c < 3; ++c) sources.cells[c].push_back(cell.centre[c]);
      sources.cells[3].push_back(cell.mass);
      for (int k = 0; k < 6; ++k) sources.cells[4 + k].push_back(cell.second[k]);
    } else if (cell.is_leaf) {
      const auto append = [&](std::vector<Real>& to, const Real* from) {
        to.insert(to.end(), from + cell.first, from + cell.last);
      };
      for (int c = 0; c < 3; ++c) append(sources.points[c], place(c, 0));
      append(sources.points[3], mass_.data());
    } else {
      ++at;
      continue;
    }
    at = cell.next;
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
