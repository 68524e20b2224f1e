#include "engine/world/pair_neighbours.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// Of the reach. Wider, and bodies look at more others than act; narrower, and the list is made more often.
constexpr Real skin_share = Real(0.15);

}  // namespace

PairNeighbours::PairNeighbours(Real reach, std::size_t count, std::size_t copies, const Period& period)
    : period_(period), count_(count) {
  if (count > few) {
    radius_.assign(count, reach / 2);
    skin_.assign(count, skin_share * reach / 2);
    ahead_.assign(count, 0);
    kept_.resize(copies);
    return;
  }
  for (std::uint32_t slot = 0; slot < count; ++slot) {
    all_.first.push_back(static_cast<std::uint32_t>(all_.other.size()));
    for (std::uint32_t other = 0; other < count; ++other) {
      if (other != slot) all_.other.push_back(other);
    }
  }
  all_.first.push_back(static_cast<std::uint32_t>(all_.other.size()));
}

void PairNeighbours::follow(const PairBodies& bodies, Workers& workers) {
  if (kept_.empty()) return;
  for (std::size_t copy = bodies.copies.first; copy < bodies.copies.last; ++copy) follow(bodies, copy, workers);
}

/// The list tells of itself when a body has gone half the skin, wherever from: a stage, a step taken back or a state
/// restored.
void PairNeighbours::follow(const PairBodies& bodies, std::size_t copy, Workers& workers) {
  Kept& kept = kept_[copy];
  const std::size_t start = copy * count_;
  std::vector<Real>* const columns[3] = {&kept.position.x, &kept.position.y, &kept.position.z};
  for (int c = 0; c < 3; ++c) columns[c]->assign(bodies.position[c] + start, bodies.position[c] + start + count_);
  if (kept.list.holds(kept.position, period_, ahead_, workers)) return;
  kept.list.build(kept.position, radius_, skin_, count_, period_, workers);
  list_both(kept.list, kept.near);
}

/// From pairs a < b to the neighbours of each body on both sides: those before it, then those behind.
void PairNeighbours::list_both(const NeighbourList& list, Near& near) {
  const std::size_t count = list.first.size() - 1;
  const auto begin = [&](std::size_t slot) { return list.first[slot] + list.first_lower[slot]; };
  near.first.resize(count + 1);
  near.other.resize(2 * list.other.size());
  for (std::size_t slot = 0; slot <= count; ++slot) near.first[slot] = begin(slot);
  for (std::uint32_t a = 0; a < count; ++a) {
    const std::uint32_t behind = list.first_lower[a + 1];
    for (std::uint32_t pair = list.first[a]; pair < list.first[a + 1]; ++pair) {
      const std::uint32_t b = list.other[pair];
      near.other[behind + pair] = b;
      near.other[near.first[b]++] = a;  // then first[b] is where those before b end
    }
  }
  for (std::size_t slot = 0; slot <= count; ++slot) near.first[slot] = begin(slot);
}

}  // namespace ballpark::BALLPARK_PRECISION
