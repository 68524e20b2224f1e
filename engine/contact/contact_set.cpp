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

/// Resizes with an eighth of room to spare, not twice.
template <class T>
void resize(std::vector<T>& list, std::size_t size) {
  if (size > list.capacity()) list.reserve(size + size / 8);
  list.resize(size);
}

template <class T>
void append(std::vector<T>& list, const T& item) {
  if (list.size() == list.capacity()) list.reserve(list.size() * 5 / 4 + 64);
  list.push_back(item);
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
  remember();
  find_reaches(bodies, step, margin);
  lists_ = candidates = 0;
  for (std::size_t first = 0; first < bodies.count; first += bodies.per_copy) {
    const Balls balls{
        {bodies.position.x.data() + first, bodies.position.y.data() + first, bodies.position.z.data() + first},
        {grid_radius_.data() + first, 0},
        bodies.per_copy,
        0};
    grid_.find(balls, period, workers);
    sift(bodies, first, period, step, margin, workers);
  }
  for (std::size_t list = lists_; list < near_.size(); ++list) near_[list].clear(), watched_[list].clear();
  order(bodies.count);
  colour(bodies.count);
  fill(bodies, laws, workers);
  find_walls(bodies, shapes, moments, laws, step, margin, workers);
}

/// Keeps the impulses of those contacts of the last step that bore any, by the slots they were between.
void ContactSet::remember() {
  const std::size_t slots = first_of_slot.empty() ? 0 : first_of_slot.size() - 1;
  old_first_.assign(slots + 1, 0);
  old_first_wall_.assign(slots + 1, 0);
  carried_.clear();
  carried_walls_.clear();
  for (std::size_t slot = 0; slot < slots; ++slot) {
    for (std::uint32_t i = first_of_slot[slot]; i < first_of_slot[slot + 1]; ++i) {
      const Contact& contact = pairs[place[i]];
      if (contact.bears()) append(carried_, {contact.b, contact.solved, contact.relaxed});
    }
    for (std::uint32_t i = first_wall_of_slot[slot]; i < first_wall_of_slot[slot + 1]; ++i) {
      if (walls[i].bears()) append(carried_walls_, {walls[i].a, walls[i].solved, walls[i].relaxed});
    }
    old_first_[slot + 1] = static_cast<std::uint32_t>(carried_.size());
    old_first_wall_[slot + 1] = static_cast<std::uint32_t>(carried_walls_.size());
  }
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

/// Which candidates of the copy with the slots from `first` on are contacts. Whether a pair is one depends on these two
/// bodies alone.
void ContactSet::sift(const ContactBodies& bodies, std::size_t first, const Period& period, Real step, Real margin,
                      Workers& workers) {
  const auto begin = static_cast<std::uint32_t>(first), end = static_cast<std::uint32_t>(first + bodies.per_copy);
  const std::size_t blocks = grid_.block_count(), list = lists_;
  lists_ += blocks + fast_.size();
  near_.resize(std::max(near_.size(), lists_));
  watched_.resize(near_.size());
  const auto for_list = [&](std::size_t count, std::size_t at, auto fill) {
    workers.for_each(count, [&](std::size_t i) {
      near_[at + i].clear();
      watched_[at + i].clear();
      fill(i, near_[at + i], watched_[at + i]);
    });
  };
  for_list(blocks, list, [&](std::size_t block, auto& near, auto& watched) {
    for (const Pair& pair : grid_.pairs(block)) {
      const std::uint32_t a = begin + pair.a, b = begin + pair.b;
      if (!is_fast_[a] && !is_fast_[b]) sift_pair(bodies, period, step, margin, {a, b}, near, watched);
    }
  });
  for_list(fast_.size(), list + blocks, [&](std::size_t f, auto& near, auto& watched) {
    const std::uint32_t i = fast_[f];
    if (i < begin || i >= end) return;
    for (std::uint32_t j = begin; j < end; ++j) {
      if (j == i || (is_fast_[j] && j < i)) continue;  // two fast ones meet once
      sift_pair(bodies, period, step, margin, {i, j}, near, watched);
    }
  });
  candidates += grid_.pair_count() + fast_.size() * bodies.per_copy;
}

void ContactSet::sift_pair(const ContactBodies& bodies, const Period& period, Real step, Real margin, Pair pair,
                           std::vector<Pair>& near, std::vector<WatchedPair>& watched) const {
  const auto [a, b] = std::minmax(pair.a, pair.b);
  const Vector3<Real> apart = nearest_image(bodies.position.at(b) - bodies.position.at(a), period);
  const Vector3<Real> way_a = step * bodies.velocity.at(a), way_b = step * bodies.velocity.at(b);
  const Real reach = (bodies.radius[a] + bodies.radius[b]) * (1 + margin), farthest = reach + swept[a] + swept[b];
  if (dot(apart, apart) > farthest * farthest) return;
  if (come_within(apart, way_b - way_a, reach)) return append(near, {a, b});
  const bool a_first = swept[a] >= swept[b];
  const Real off = a_first ? distance_from_segment(apart, way_a) : distance_from_segment(Real(-1) * apart, way_b);
  if (off <= reach + std::min(swept[a], swept[b])) append(watched, {a, b});
}

/// Sorts the contacts by their slots: counted by the first, then each short list by the second.
void ContactSet::order(std::size_t slots) {
  first_of_slot.assign(slots + 1, 0);
  std::size_t count = 0;
  for (const auto& list : near_) {
    for (const Pair& pair : list) ++first_of_slot[pair.a];
    count += list.size();
  }
  std::uint32_t before = 0;
  for (std::uint32_t& first : first_of_slot) {
    before += first;
    first = before;  // the end of its list: filling counts down to the beginning
  }
  resize(other_, count);
  for (const auto& list : near_) {
    for (const Pair& pair : list) other_[--first_of_slot[pair.a]] = pair.b;
  }
  for (std::size_t a = 0; a < slots; ++a) {
    std::sort(other_.begin() + first_of_slot[a], other_.begin() + first_of_slot[a + 1]);
  }
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
      const bool known = a + 1 < old_first_.size();
      std::uint32_t old = known ? old_first_[a] : 0;
      const std::uint32_t old_end = known ? old_first_[a + 1] : 0;
      for (std::uint32_t i = first_of_slot[a]; i < first_of_slot[a + 1]; ++i) {
        const std::uint32_t b = other_[i];
        Contact& contact = pairs[place[i]];
        contact.a = static_cast<std::uint32_t>(a);
        contact.b = b;
        contact.friction = laws.of(bodies.material[a], bodies.material[b]).friction;
        const Real inverse = bodies.inverse_mass[a] + bodies.inverse_mass[b];
        contact.normal_mass = 1 / inverse;
        contact.tangent_mass = 1 / (inverse + bodies.mobility[a] + bodies.mobility[b]);
        while (old < old_end && carried_[old].other < b) ++old;
        const bool met = old < old_end && carried_[old].other == b;
        contact.solved = met ? carried_[old].solved : ContactImpulse{};
        contact.relaxed = met ? carried_[old].relaxed : ContactImpulse{};
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
  if (slot + 1 >= old_first_wall_.size()) return contact;
  for (std::uint32_t old = old_first_wall_[slot]; old < old_first_wall_[slot + 1]; ++old) {
    if (carried_walls_[old].other != wall) continue;
    contact.solved = carried_walls_[old].solved;
    contact.relaxed = carried_walls_[old].relaxed;
  }
  return contact;
}

std::size_t ContactSet::bytes() const {
  std::size_t sum = grid_.bytes() + capacity_bytes(pairs) + capacity_bytes(walls) + capacity_bytes(place) +
                    capacity_bytes(first_of_slot) + capacity_bytes(first_wall_of_slot) + capacity_bytes(swept) +
                    capacity_bytes(grid_radius_) + capacity_bytes(fast_) + capacity_bytes(is_fast_) +
                    capacity_bytes(other_) + capacity_bytes(colour_) + capacity_bytes(used_) +
                    capacity_bytes(carried_) + capacity_bytes(carried_walls_) + capacity_bytes(old_first_) +
                    capacity_bytes(old_first_wall_);
  for (const auto& list : near_) sum += capacity_bytes(list);
  for (const auto& list : watched_) sum += capacity_bytes(list);
  for (const auto& list : near_walls_) sum += capacity_bytes(list);
  return sum;
}

}  // namespace ballpark::BALLPARK_PRECISION
