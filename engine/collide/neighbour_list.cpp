#include "engine/collide/neighbour_list.h"

#include <algorithm>

namespace ballpark::BALLPARK_PRECISION {

namespace {
constexpr std::size_t block_length = 4096;  // slots of a task
}

bool NeighbourList::holds(const VectorColumn& position, const Period& period, const std::vector<Real>& ahead,
                          Workers& workers) {
  const std::size_t slots = position.x.size();
  if (allowance_.size() != slots) return false;
  const std::size_t blocks = (slots + block_length - 1) / block_length;
  block_holds_.assign(blocks, 1);
  const auto task = [&](std::size_t block) {
    bool within = true;
    for (std::size_t i = block * block_length; i < std::min((block + 1) * block_length, slots); ++i) {
      const Vector3<Real> moved = nearest_image(position.at(i) - built_.at(i), period);
      const Real left = allowance_[i] - ahead[i];
      const bool absent = position.x[i] != position.x[i] && built_.x[i] != built_.x[i];  // then as now
      within &= (left >= 0 && dot(moved, moved) <= left * left) | absent;
    }
    block_holds_[block] = within;
  };
  workers.for_each(blocks, task, blocks < 2 ? 1 : workers.threads());
  return std::all_of(block_holds_.begin(), block_holds_.end(), [](std::uint8_t held) { return held; });
}

void NeighbourList::build(const VectorColumn& position, const std::vector<Real>& radius,
                          const std::vector<Real>& allowance, std::size_t per_copy, const Period& period,
                          Workers& workers) {
  const std::size_t slots = radius.size();
  constexpr Real slack = Real(1) + Real(1e-5);  // no rounding may lose a pair
  built_ = position;
  allowance_ = allowance;
  reach_.resize(slots);
  for (std::size_t i = 0; i < slots; ++i) reach_[i] = (radius[i] + allowance[i]) * slack;
  found_.clear();
  for (std::size_t start = 0; start < slots; start += per_copy) {
    grid_.find({{position.x.data() + start, position.y.data() + start, position.z.data() + start},
                {reach_.data() + start, 0},
                per_copy,
                0},
               period, workers);
    for (std::size_t block = 0; block < grid_.block_count(); ++block) {
      for (const Pair& pair : grid_.pairs(block)) {
        const auto [a, b] = std::minmax(pair.a, pair.b);
        found_.push_back({static_cast<std::uint32_t>(start + a), static_cast<std::uint32_t>(start + b)});
      }
    }
  }
  order(slots);
}

/// Counting sort by a; each short list by b; then every slot's pairs as b, which come in the order of a.
void NeighbourList::order(std::size_t slots) {
  first.assign(slots + 1, 0);
  first_lower.assign(slots + 1, 0);
  for (const Pair& pair : found_) ++first[pair.a + 1], ++first_lower[pair.b + 1];
  for (std::size_t i = 0; i < slots; ++i) first[i + 1] += first[i], first_lower[i + 1] += first_lower[i];
  other.resize(found_.size());
  lower.resize(found_.size());
  for (const Pair& pair : found_) other[first[pair.a]++] = pair.b;  // then first[a] is where a's list ends
  for (std::size_t i = slots; i > 0; --i) first[i] = first[i - 1];
  first[0] = 0;
  std::vector<std::uint32_t>& next = first_lower;  // filled in place, likewise
  for (std::size_t a = 0; a < slots; ++a) {
    std::sort(other.begin() + first[a], other.begin() + first[a + 1]);
    for (std::uint32_t i = first[a]; i < first[a + 1]; ++i) lower[next[other[i]]++] = i;
  }
  for (std::size_t i = slots; i > 0; --i) next[i] = next[i - 1];
  next[0] = 0;
}

std::size_t NeighbourList::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  return grid_.bytes() + built_.bytes() + of(first) + of(other) + of(first_lower) + of(lower) + of(allowance_) +
         of(reach_) + of(found_) + of(block_holds_);
}

}  // namespace ballpark::BALLPARK_PRECISION
