#include "engine/contact/contact_set.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace ballpark::BALLPARK_PRECISION {

namespace {

constexpr std::size_t block_length = 2048;  // contacts or bodies of a task
constexpr std::size_t most_fast = 16;       // bodies that are held against every other
constexpr int most_colours = 63;            // before the one that shares bodies

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

void ContactBodies::resize(std::size_t n, bool solved) {
  count = n;
  for (auto* values : {&radius, &inverse_mass, &mobility}) values->resize(n);
  material.resize(n);
  for (auto* column : {&position, &velocity, &surface}) column->resize(n);
  if (!solved) return;
  for (auto* column : {&end_position, &end_velocity, &end_surface}) column->resize(n);
}

std::size_t ContactBodies::bytes() const {
  std::size_t sum =
      capacity_bytes(radius) + capacity_bytes(inverse_mass) + capacity_bytes(mobility) + capacity_bytes(material);
  for (const auto* column : {&position, &velocity, &surface, &end_position, &end_velocity, &end_surface, &turned}) {
    sum += column->bytes();
  }
  return sum;
}

void ContactSet::find(const ContactBodies& bodies, const std::vector<Wall>& shapes,
                      const std::vector<WallMoment>& moments, const Period& period, const LawTable& laws, Real step,
                      Real margin, Workers& workers) {
  remember(workers);
  find_reaches(bodies, step, margin);
  lists_ = candidates = 0;
  other_.clear();
  first_of_slot.assign(bodies.count + 1, 0);
  for (std::size_t first = 0; first < bodies.count; first += bodies.per_copy) {
    const Balls balls{
        {bodies.position.x.data() + first, bodies.position.y.data() + first, bodies.position.z.data() + first},
        {grid_radius_.data() + first, 0},
        bodies.per_copy,
        0};
    grid_.find(balls, period, workers);
    sift(bodies, first, period, step, margin, workers);
    order(first, first + bodies.per_copy, workers);
  }
  first_of_slot[bodies.count] = static_cast<std::uint32_t>(other_.size());
  for (std::size_t list = lists_; list < watched_.size(); ++list) watched_[list].clear();
  colour(bodies.count);
  fill(bodies, laws, workers);
  find_walls(bodies, shapes, moments, laws, step, margin, workers);
}

/// Keeps the impulses of those contacts of the last step that bore any, by the slots they were between.
void ContactSet::remember(Workers& workers) {
  const auto pair_at = [this](std::uint32_t i) -> const Contact& { return pairs[place[i]]; };
  const auto wall_at = [this](std::uint32_t i) -> const Contact& { return walls[i]; };
  keep_impulses(
      first_of_slot, pair_at, [](const Contact& c) { return c.b; }, carried_, workers);
  keep_impulses(
      first_wall_of_slot, wall_at, [](const Contact& c) { return c.a; }, carried_walls_, workers);
}

/// Of the contacts at(i), i in [first[slot], first[slot + 1]): counted by slot, then written where they belong.
template <class At, class Other>
void ContactSet::keep_impulses(const std::vector<std::uint32_t>& first, At at, Other other, Carried& kept,
                               Workers& workers) {
  const std::size_t slots = first.empty() ? 0 : first.size() - 1;
  kept.first.assign(slots + 1, 0);
  for_blocks(slots, workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      for (std::uint32_t i = first[slot]; i < first[slot + 1]; ++i) kept.first[slot + 1] += at(i).bears();
    }
  });
  for (std::size_t slot = 0; slot < slots; ++slot) kept.first[slot + 1] += kept.first[slot];
  resize(kept.other, kept.first[slots]);
  resize(kept.impulses, kept.first[slots]);
  for_blocks(slots, workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      std::uint32_t to = kept.first[slot];
      for (std::uint32_t i = first[slot]; i < first[slot + 1]; ++i) {
        const Contact& contact = at(i);
        if (!contact.bears()) continue;
        kept.other[to] = other(contact);
        kept.impulses[to++] = {contact.solved, contact.relaxed};
      }
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
  candidates += grid_.pair_count() + fast_.size() * bodies.per_copy;
  lists_ += blocks + fast_.size();
  if (watched_.size() < lists_) watched_.resize(lists_);
  if (fast_near_.size() < fast_.size()) fast_near_.resize(fast_.size());
  workers.for_each(blocks, [&](std::size_t block) {
    std::vector<WatchedPair>& watched = watched_[list + block];
    watched.clear();
    grid_.keep(block, [&](const Pair& pair) {
      const std::uint32_t a = begin + pair.a, b = begin + pair.b;
      return !is_fast_[a] && !is_fast_[b] && is_contact(bodies, period, step, margin, {a, b}, watched);
    });
  });
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
  const auto [a, b] = std::minmax(pair.a, pair.b);
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

/// Sorts the contacts of one copy by their slots: counted by the first, then each short list by the second.
void ContactSet::order(std::size_t begin, std::size_t end, Workers& workers) {
  const auto each = [&](auto act) {
    for (std::size_t block = 0; block < grid_.block_count(); ++block) {
      for (const Pair& pair : grid_.pairs(block))
        act(begin + std::min(pair.a, pair.b), begin + std::max(pair.a, pair.b));
    }
    for (std::size_t f = 0; f < fast_.size(); ++f) {
      for (const Pair& pair : fast_near_[f]) act(begin + std::min(pair.a, pair.b), begin + std::max(pair.a, pair.b));
    }
  };
  each([&](std::size_t a, std::size_t) { ++first_of_slot[a]; });
  auto before = static_cast<std::uint32_t>(other_.size());
  for (std::size_t slot = begin; slot < end; ++slot) {
    before += first_of_slot[slot];
    first_of_slot[slot] = before;  // the end of its list: filling counts down to the beginning
  }
  resize(other_, before);
  first_of_slot[end] = before;
  each([&](std::size_t a, std::size_t b) { other_[--first_of_slot[a]] = static_cast<std::uint32_t>(b); });
  for_blocks(end - begin, workers, [&](std::size_t first, std::size_t last) {
    for (std::size_t a = begin + first; a < begin + last; ++a) {
      std::sort(other_.begin() + first_of_slot[a], other_.begin() + first_of_slot[a + 1]);
    }
  });
  first_of_slot[end] = 0;  // to be counted in the next copy
}

/// Greedy, in the order of slots: the first colour that neither body has.
void ContactSet::colour(std::size_t slots) {
  used_.assign(slots, 0);
  resize(colour_, other_.size());
  std::array<std::size_t, most_colours + 2> count{};
  for (std::size_t a = 0; a < slots; ++a) {
    for (std::uint32_t i = first_of_slot[a]; i < first_of_slot[a + 1]; ++i) {
      const std::uint32_t b = other_[i];
      const int c = std::min(std::countr_one(used_[a] | used_[b]), most_colours);
      if (c < most_colours) {
        used_[a] |= std::uint64_t{1} << c;
        used_[b] |= std::uint64_t{1} << c;
      }
      colour_[i] = static_cast<std::uint8_t>(c);
      ++count[static_cast<std::size_t>(c) + 1];
    }
  }
  last_colour_shares = count[most_colours + 1] > 0;
  int colours = most_colours + 1;
  while (colours > 0 && count[static_cast<std::size_t>(colours)] == 0) --colours;
  for (std::size_t c = 1; c < count.size(); ++c) count[c] += count[c - 1];
  colour_begin.assign(count.begin(), count.begin() + colours + 1);
  resize(place, other_.size());
  for (std::size_t i = 0; i < other_.size(); ++i) place[i] = static_cast<std::uint32_t>(count[colour_[i]]++);
}

/// Contacts with what is constant over the step, and the impulses that the same pair had in the last one.
void ContactSet::fill(const ContactBodies& bodies, const LawTable& laws, Workers& workers) {
  resize(pairs, other_.size());
  const std::size_t blocks = (bodies.count + block_length - 1) / block_length;
  workers.for_each(blocks, [&](std::size_t block) {
    for (std::size_t a = block * block_length; a < std::min((block + 1) * block_length, bodies.count); ++a) {
      const bool known = a + 1 < carried_.first.size();
      std::uint32_t old = known ? carried_.first[a] : 0;
      const std::uint32_t old_end = known ? carried_.first[a + 1] : 0;
      for (std::uint32_t i = first_of_slot[a]; i < first_of_slot[a + 1]; ++i) {
        const std::uint32_t b = other_[i];
        Contact& contact = pairs[place[i]];
        contact.a = static_cast<std::uint32_t>(a);
        contact.b = b;
        contact.friction = laws.of(bodies.material[a], bodies.material[b]).friction;
        const Real inverse = bodies.inverse_mass[a] + bodies.inverse_mass[b];
        contact.normal_mass = 1 / inverse;
        contact.tangent_mass = 1 / (inverse + bodies.mobility[a] + bodies.mobility[b]);
        while (old < old_end && carried_.other[old] < b) ++old;
        const bool met = old < old_end && carried_.other[old] == b;
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
  first_wall_of_slot.assign(bodies.count + 1, 0);
  workers.for_each(blocks, [&](std::size_t block) {
    near_walls_[block].clear();
    for (std::size_t slot = block * block_length; slot < std::min((block + 1) * block_length, bodies.count); ++slot) {
      for (std::size_t w = 0; w < shapes.size(); ++w) {
        const Real radius = bodies.radius[slot];
        const Real reach = margin * radius + swept[slot] + wall_ways_[w];
        if (!(shapes[w].distance(bodies.position.at(slot) - moments[w].offset, radius) <= reach)) continue;
        append(near_walls_[block], {static_cast<std::uint32_t>(w), static_cast<std::uint32_t>(slot)});
        ++first_wall_of_slot[slot + 1];
      }
    }
  });
  for (std::size_t slot = 0; slot < bodies.count; ++slot) first_wall_of_slot[slot + 1] += first_wall_of_slot[slot];
  resize(walls, first_wall_of_slot[bodies.count]);
  workers.for_each(blocks, [&](std::size_t block) {
    std::size_t at = first_wall_of_slot[block * block_length];
    for (const Pair& near : near_walls_[block]) walls[at++] = wall_contact(bodies, shapes, laws, near.a, near.b);
  });
}

Contact ContactSet::wall_contact(const ContactBodies& bodies, const std::vector<Wall>& shapes, const LawTable& laws,
                                 std::uint32_t wall, std::uint32_t slot) const {
  Contact contact;
  contact.a = wall;
  contact.b = slot;
  contact.friction = laws.of(shapes[wall].material, bodies.material[slot]).friction;
  contact.normal_mass = 1 / bodies.inverse_mass[slot];
  contact.tangent_mass = 1 / (bodies.inverse_mass[slot] + bodies.mobility[slot]);
  if (slot + 1 >= carried_walls_.first.size()) return contact;
  for (std::uint32_t old = carried_walls_.first[slot]; old < carried_walls_.first[slot + 1]; ++old) {
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
                    capacity_bytes(first_of_slot) + capacity_bytes(first_wall_of_slot) + capacity_bytes(swept) +
                    capacity_bytes(grid_radius_) + capacity_bytes(fast_) + capacity_bytes(is_fast_) +
                    capacity_bytes(other_) + capacity_bytes(colour_) + capacity_bytes(used_) + carried_.bytes() +
                    carried_walls_.bytes();
  for (const auto& list : fast_near_) sum += capacity_bytes(list);
  for (const auto& list : watched_) sum += capacity_bytes(list);
  for (const auto& list : near_walls_) sum += capacity_bytes(list);
  return sum;
}

}  // namespace ballpark::BALLPARK_PRECISION
