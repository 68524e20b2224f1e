#include "engine/contact/contact_set.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace ballpark::BALLPARK_PRECISION {

namespace {

constexpr std::size_t block_length = 2048;           // contacts or bodies of a task
constexpr std::size_t most_fast = 16;                // bodies that are held against every other
constexpr int most_colours = 63;                     // before the one that shares bodies
constexpr std::uint32_t shares = ~std::uint32_t(0);  // stands for that one

template <class T>
std::size_t capacity_bytes(const std::vector<T>& list) {
  return list.capacity() * sizeof(T);
}

/// Resizes with a sixteenth of room to spare, not twice.
template <class T>
void resize(std::vector<T>& list, std::size_t size) {
  if (size > list.capacity()) list.reserve(size + size / 16);
  list.resize(size);
}

template <class T>
void append(std::vector<T>& list, const T& item) {
  if (list.size() == list.capacity()) list.reserve(list.size() * 5 / 4 + 64);
  list.push_back(item);
}

/// act(first, last) for blocks of items.
template <class Act>
void for_blocks(std::size_t count, Workers& workers, Act act) {
  const std::size_t blocks = (count + block_length - 1) / block_length;
  const auto task = [&](std::size_t b) { act(b * block_length, std::min((b + 1) * block_length, count)); };
  workers.for_each(blocks, task, blocks < 2 ? 1 : workers.threads());
}

/// Distance of a point from the segment that starts at the origin.
Real distance_from_segment(const Vector3<Real>& point, const Vector3<Real>& segment) {
  const Real square = dot(segment, segment), along = dot(segment, point);
  const Real share = along > 0 && square > 0 ? std::min(along / square, Real(1)) : Real(0);
  return length(point - share * segment);
}

}  // namespace

void ContactSet::find(const ContactBodies& bodies, const std::vector<Wall>& shapes,
                      const std::vector<WallMoment>& moments, const Period& period, const LawTable& laws, Real step,
                      Real margin, Workers& workers, std::vector<std::uint32_t>* nearby) {
  remember(bodies, workers);
  find_reaches(bodies, step, margin);
  lists_ = candidates = 0;
  other_.clear();
  first_of_rank.assign(bodies.count + 1, 0);
  for (std::size_t first = 0; first < bodies.count; first += bodies.per_copy) {
    const Balls balls{
        {bodies.position.x.data() + first, bodies.position.y.data() + first, bodies.position.z.data() + first},
        {grid_radius_.data() + first, 0},
        bodies.per_copy,
        0};
    grid_.sort(balls, period, workers);
    sift(bodies, first, period, step, margin, workers);
    order(bodies, first, workers);
    if (nearby) nearby->insert(nearby->end(), grid_.order().begin(), grid_.order().end());
  }
  first_of_rank[bodies.count] = static_cast<std::uint32_t>(other_.size());
  for (std::size_t list = lists_; list < watched_.size(); ++list) watched_[list].clear();
  colour(bodies);
  fill(bodies, laws, workers);
  find_walls(bodies, shapes, moments, laws, step, margin, workers);
}

/// Keeps the impulses of those contacts of the last step that bore any, by the ranks they were between.
void ContactSet::remember(const ContactBodies& bodies, Workers& workers) {
  const auto pair_at = [this](std::uint32_t i) -> const Contact& { return pairs[place[i]]; };
  const auto wall_at = [this](std::uint32_t i) -> const Contact& { return walls[i]; };
  const auto pair_other = [this](std::uint32_t i) { return other_[i]; };
  const auto wall_other = [this](std::uint32_t i) { return walls[i].a; };
  keep_impulses(bodies, first_of_rank, pair_at, pair_other, carried_, workers);
  keep_impulses(bodies, first_wall_of_rank, wall_at, wall_other, carried_walls_, workers);
}

/// Of the contacts at(i), i in [first[rank], first[rank + 1]): counted by rank, then written where they belong.
template <class At, class Other>
void ContactSet::keep_impulses(const ContactBodies& bodies, const std::vector<std::uint32_t>& first, At at, Other other,
                               Carried& kept, Workers& workers) {
  const std::size_t ranks = first.empty() ? 0 : first.size() - 1;
  kept.first.assign(ranks + 1, 0);
  const auto for_ranks = [&](auto act) {  // those of near bodies lie near each other
    for_blocks(ranks, workers, [&](std::size_t begin, std::size_t end) {
      for (std::size_t slot = begin; slot < end; ++slot) act(bodies.rank_of(slot));
    });
  };
  for_ranks([&](std::uint32_t rank) {
    for (std::uint32_t i = first[rank]; i < first[rank + 1]; ++i) kept.first[rank + 1] += at(i).bears();
  });
  for (std::size_t rank = 0; rank < ranks; ++rank) kept.first[rank + 1] += kept.first[rank];
  resize(kept.other, kept.first[ranks]);
  resize(kept.impulses, kept.first[ranks]);
  for_ranks([&](std::uint32_t rank) {
    std::uint32_t to = kept.first[rank];
    for (std::uint32_t i = first[rank]; i < first[rank + 1]; ++i) {
      const Contact& contact = at(i);
      if (!contact.bears()) continue;
      kept.other[to] = other(i);
      kept.impulses[to++] = {contact.solved, contact.relaxed};
    }
  });
}

/// How far each body may go in the step, and which go so far that their reach would widen every cell of the grid.
void ContactSet::find_reaches(const ContactBodies& bodies, Real step, Real margin) {
  constexpr int bins = 64;
  std::array<std::size_t, bins> beyond{};  // bodies that go farther than (largest radius) * 2^(bin - 2)
  Real largest = 0;
  for (const Real r : bodies.radius) largest = std::max(largest, r);
  swept.resize(bodies.count);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    const Real far = step * length(bodies.velocity.at(i));
    swept[i] = far - far == 0 ? far : Real(0);  // what is not finite touches nothing
    Real limit = largest / 4;
    for (int bin = 0; bin < bins && swept[i] > limit; ++bin, limit *= 2) ++beyond[static_cast<std::size_t>(bin)];
  }
  Real limit = largest / 4;
  for (int bin = 0; bin < bins && beyond[static_cast<std::size_t>(bin)] > most_fast; ++bin) limit *= 2;
  fast_.clear();
  is_fast_.assign(bodies.count, 0);
  grid_radius_.resize(bodies.count);
  constexpr Real slack = Real(1) + Real(1e-5);  // no rounding may lose a pair
  for (std::size_t i = 0; i < bodies.count; ++i) {
    const bool fast = swept[i] > limit;
    if (fast) fast_.push_back(static_cast<std::uint32_t>(i));
    is_fast_[i] = fast;
    grid_radius_[i] = (bodies.radius[i] * (1 + margin) + (fast ? Real(0) : swept[i])) * slack;
  }
}

/// Which candidates of the copy with the slots from `first` on are contacts: they stay in the grid's lists, and those
/// of fast bodies in lists of their own. Whether a pair is one depends on these two bodies alone.
void ContactSet::sift(const ContactBodies& bodies, std::size_t first, const Period& period, Real step, Real margin,
                      Workers& workers) {
  const auto begin = static_cast<std::uint32_t>(first), end = static_cast<std::uint32_t>(first + bodies.per_copy);
  const std::size_t blocks = grid_.block_count(), list = lists_;
  lists_ += blocks + fast_.size();
  if (watched_.size() < lists_) watched_.resize(lists_);
  if (fast_near_.size() < fast_.size()) fast_near_.resize(fast_.size());
  for (std::size_t block = 0; block < blocks; ++block) watched_[list + block].clear();
  grid_.search(workers, [&](std::size_t block, const Pair& pair) {
    const std::uint32_t a = begin + pair.a, b = begin + pair.b;
    return !is_fast_[a] && !is_fast_[b] && is_contact(bodies, period, step, margin, {a, b}, watched_[list + block]);
  });
  candidates += grid_.candidate_count() + fast_.size() * bodies.per_copy;
  workers.for_each(fast_.size(), [&](std::size_t f) {
    std::vector<WatchedPair>& watched = watched_[list + blocks + f];
    watched.clear();
    fast_near_[f].clear();
    const std::uint32_t i = fast_[f];
    if (i < begin || i >= end) return;
    for (std::uint32_t j = begin; j < end; ++j) {
      if (j == i || (is_fast_[j] && j < i)) continue;  // two fast ones meet once
      if (is_contact(bodies, period, step, margin, {i, j}, watched)) append(fast_near_[f], {i - begin, j - begin});
    }
  });
}

/// False: too far apart, or to be watched only.
bool ContactSet::is_contact(const ContactBodies& bodies, const Period& period, Real step, Real margin, Pair pair,
                            std::vector<WatchedPair>& watched) const {
  const bool forward = bodies.rank_of(pair.a) < bodies.rank_of(pair.b);
  const std::uint32_t a = forward ? pair.a : pair.b, b = forward ? pair.b : pair.a;
  const Vector3<Real> apart = nearest_image(bodies.position.at(b) - bodies.position.at(a), period);
  const Vector3<Real> way_a = step * bodies.velocity.at(a), way_b = step * bodies.velocity.at(b);
  const Real reach = (bodies.radius[a] + bodies.radius[b]) * (1 + margin), farthest = reach + swept[a] + swept[b];
  if (dot(apart, apart) > farthest * farthest) return false;
  if (come_within(apart, way_b - way_a, reach)) return true;
  const bool a_first = swept[a] >= swept[b];
  const Real off = a_first ? distance_from_segment(apart, way_a) : distance_from_segment(Real(-1) * apart, way_b);
  if (off <= reach + std::min(swept[a], swept[b])) append(watched, {a, b});
  return false;
}

/// Sorts the contacts of the copy with the slots from `begin` on by their ranks: counted by the first, then each short
/// list by the second.
void ContactSet::order(const ContactBodies& bodies, std::size_t begin, Workers& workers) {
  const std::size_t end = begin + bodies.per_copy;
  const auto each = [&](auto act) {
    const auto ranked = [&](const Pair& pair) {
      const std::uint32_t a = bodies.rank_of(begin + pair.a), b = bodies.rank_of(begin + pair.b);
      act(std::min(a, b), std::max(a, b));
    };
    for (std::size_t block = 0; block < grid_.block_count(); ++block) {
      for (const Pair& pair : grid_.pairs(block)) ranked(pair);
    }
    for (std::size_t f = 0; f < fast_.size(); ++f) {
      for (const Pair& pair : fast_near_[f]) ranked(pair);
    }
  };
  each([&](std::uint32_t a, std::uint32_t) { ++first_of_rank[a]; });
  auto before = static_cast<std::uint32_t>(other_.size());
  for (std::size_t rank = begin; rank < end; ++rank) {
    before += first_of_rank[rank];
    first_of_rank[rank] = before;  // the end of its list: filling counts down to the beginning
  }
  resize(other_, before);
  first_of_rank[end] = before;
  each([&](std::uint32_t a, std::uint32_t b) { other_[--first_of_rank[a]] = b; });
  for_blocks(end - begin, workers, [&](std::size_t first, std::size_t last) {
    for (std::size_t a = begin + first; a < begin + last; ++a) {
      std::sort(other_.begin() + first_of_rank[a], other_.begin() + first_of_rank[a + 1]);
    }
  });
  first_of_rank[end] = 0;  // to be counted in the next copy
}

/// Greedy, in the order of ranks: the first colour that neither body has. It stands in `place` until places are known.
void ContactSet::colour(const ContactBodies& bodies) {
  used_.assign(bodies.count, 0);
  resize(place, other_.size());
  std::array<std::size_t, most_colours + 2> count{};
  for (std::size_t a = 0; a < bodies.count; ++a) {
    for (std::uint32_t i = first_of_rank[a]; i < first_of_rank[a + 1]; ++i) {
      const std::uint32_t b = other_[i];
      const int c = std::min(std::countr_one(used_[a] | used_[b]), most_colours);
      if (c < most_colours) {
        used_[a] |= std::uint64_t{1} << c;
        used_[b] |= std::uint64_t{1} << c;
      }
      place[i] = c < most_colours ? static_cast<std::uint32_t>(c) : shares;
      ++count[static_cast<std::size_t>(c) + 1];
    }
  }
  last_colour_shares = count[most_colours + 1] > 0;
  int colours = most_colours + 1;
  while (colours > 0 && count[static_cast<std::size_t>(colours)] == 0) --colours;
  for (std::size_t c = 1; c < count.size(); ++c) count[c] += count[c - 1];
  colour_begin.assign(count.begin(), count.begin() + colours + 1);
  lay_out(bodies, count);
}

/// Contacts of one colour lie in the order of slots: what is near is near in memory. Only the last colour, whose order
/// matters, lies in that of ranks. `place`: of each pair its colour, then where it goes. `next`: of each colour.
template <std::size_t n>
void ContactSet::lay_out(const ContactBodies& bodies, std::array<std::size_t, n>& next) {
  for (std::size_t slot = 0; slot < bodies.count; ++slot) {
    const std::uint32_t rank = bodies.rank_of(slot);
    for (std::uint32_t i = first_of_rank[rank]; i < first_of_rank[rank + 1]; ++i) {
      if (place[i] != shares) place[i] = static_cast<std::uint32_t>(next[place[i]]++);
    }
  }
  if (!last_colour_shares) return;
  for (std::uint32_t& to : place) {
    if (to == shares) to = static_cast<std::uint32_t>(next[most_colours]++);
  }
}

/// Contacts with what is constant over the step, and the impulses that the same pair had in the last one.
void ContactSet::fill(const ContactBodies& bodies, const LawTable& laws, Workers& workers) {
  resize(pairs, other_.size());
  const std::size_t blocks = (bodies.count + block_length - 1) / block_length;
  workers.for_each(blocks, [&](std::size_t block) {
    for (std::size_t slot = block * block_length; slot < std::min((block + 1) * block_length, bodies.count); ++slot) {
      const std::uint32_t a = bodies.rank_of(slot);
      const bool known = a + 1 < carried_.first.size();
      std::uint32_t old = known ? carried_.first[a] : 0;
      const std::uint32_t old_end = known ? carried_.first[a + 1] : 0;
      for (std::uint32_t i = first_of_rank[a]; i < first_of_rank[a + 1]; ++i) {
        Contact& contact = pairs[place[i]];
        const std::uint32_t other = bodies.slot_of(other_[i]);
        contact.a = static_cast<std::uint32_t>(slot);
        contact.b = other;
        contact.friction = laws.of(bodies.material[slot], bodies.material[other]).friction;
        while (old < old_end && carried_.other[old] < other_[i]) ++old;
        const bool met = old < old_end && carried_.other[old] == other_[i];
        contact.solved = met ? carried_.impulses[old].solved : ContactImpulse{};
        contact.relaxed = met ? carried_.impulses[old].relaxed : ContactImpulse{};
      }
    }
  });
}

/// Each body against each wall: there are few walls. Blocks of slots list what is near; then each writes its part.
void ContactSet::find_walls(const ContactBodies& bodies, const std::vector<Wall>& shapes,
                            const std::vector<WallMoment>& moments, const LawTable& laws, Real step, Real margin,
                            Workers& workers) {
  const std::size_t blocks = (bodies.count + block_length - 1) / block_length;
  near_walls_.resize(blocks);
  wall_ways_.clear();
  for (const Wall& wall : shapes) wall_ways_.push_back(step * static_cast<Real>(wall.motion.top_speed()));
  first_wall_of_rank.assign(bodies.count + 1, 0);
  workers.for_each(blocks, [&](std::size_t block) {
    near_walls_[block].clear();
    for (std::size_t slot = block * block_length; slot < std::min((block + 1) * block_length, bodies.count); ++slot) {
      for (std::size_t w = 0; w < shapes.size(); ++w) {
        const Real radius = bodies.radius[slot];
        const Real reach = margin * radius + swept[slot] + wall_ways_[w];
        if (!(shapes[w].distance(bodies.position.at(slot) - moments[w].offset, radius) <= reach)) continue;
        append(near_walls_[block], {static_cast<std::uint32_t>(w), static_cast<std::uint32_t>(slot)});
        ++first_wall_of_rank[bodies.rank_of(slot) + 1];
      }
    }
  });
  for (std::size_t rank = 0; rank < bodies.count; ++rank) first_wall_of_rank[rank + 1] += first_wall_of_rank[rank];
  resize(walls, first_wall_of_rank[bodies.count]);
  workers.for_each(blocks, [&](std::size_t block) {
    std::size_t at = 0;
    std::uint32_t last = ~std::uint32_t(0);
    for (const Pair& near : near_walls_[block]) {
      if (near.b != last) at = first_wall_of_rank[bodies.rank_of(near.b)];
      last = near.b;
      walls[at++] = wall_contact(bodies, shapes, laws, near.a, near.b);
    }
  });
}

Contact ContactSet::wall_contact(const ContactBodies& bodies, const std::vector<Wall>& shapes, const LawTable& laws,
                                 std::uint32_t wall, std::uint32_t slot) const {
  Contact contact;
  contact.a = wall;
  contact.b = slot;
  contact.friction = laws.of(shapes[wall].material, bodies.material[slot]).friction;
  const std::uint32_t rank = bodies.rank_of(slot);
  if (rank + 1 >= carried_walls_.first.size()) return contact;
  for (std::uint32_t old = carried_walls_.first[rank]; old < carried_walls_.first[rank + 1]; ++old) {
    if (carried_walls_.other[old] != wall) continue;
    contact.solved = carried_walls_.impulses[old].solved;
    contact.relaxed = carried_walls_.impulses[old].relaxed;
  }
  return contact;
}

std::size_t ContactSet::Carried::bytes() const {
  return capacity_bytes(first) + capacity_bytes(other) + capacity_bytes(impulses);
}

std::size_t ContactSet::bytes() const {
  std::size_t sum = grid_.bytes() + capacity_bytes(pairs) + capacity_bytes(walls) + capacity_bytes(place) +
                    capacity_bytes(first_of_rank) + capacity_bytes(first_wall_of_rank) + capacity_bytes(swept) +
                    capacity_bytes(grid_radius_) + capacity_bytes(fast_) + capacity_bytes(is_fast_) +
                    capacity_bytes(other_) + capacity_bytes(pair_marks) + capacity_bytes(wall_marks) +
                    capacity_bytes(used_) + carried_.bytes() + carried_walls_.bytes();
  for (const auto& list : fast_near_) sum += capacity_bytes(list);
  for (const auto& list : watched_) sum += capacity_bytes(list);
  for (const auto& list : near_walls_) sum += capacity_bytes(list);
  return sum;
}

}  // namespace ballpark::BALLPARK_PRECISION
