// What contacts remember between steps as bytes: a run goes on from a snapshot with the same bits.
#include <algorithm>
#include <cstring>

#include "engine/contact/impulse_solver.h"
#include "engine/contact/penalty.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

using Saved = ContactSet::Saved;

struct Head {
  std::uint64_t pairs = 0, walls = 0;
  Real last_substep = 0;
};

template <class Item>
std::vector<std::byte> packed(Real last_substep, const std::vector<Item>& pairs, const std::vector<Item>& walls) {
  const Head head{pairs.size(), walls.size(), last_substep};
  std::vector<std::byte> bytes(sizeof head + (pairs.size() + walls.size()) * sizeof(Item));
  std::memcpy(bytes.data(), &head, sizeof head);
  std::byte* at = bytes.data() + sizeof head;
  if (!pairs.empty()) std::memcpy(at, pairs.data(), pairs.size() * sizeof(Item));
  if (!walls.empty()) std::memcpy(at + pairs.size() * sizeof(Item), walls.data(), walls.size() * sizeof(Item));
  return bytes;
}

/// False if the bytes are not the items of these bodies and walls, in their order.
template <class Item>
bool unpack(const std::vector<std::byte>& bytes, const ContactScene& scene, Real& last_substep,
            std::vector<Item>& pairs, std::vector<Item>& walls) {
  Head head;
  if (bytes.size() < sizeof head) return false;
  std::memcpy(&head, bytes.data(), sizeof head);
  const std::size_t room = (bytes.size() - sizeof head) / sizeof(Item);
  if (head.pairs > room || head.walls != room - head.pairs) return false;
  pairs.resize(head.pairs), walls.resize(head.walls);
  const std::byte* at = bytes.data() + sizeof head;
  if (!pairs.empty()) std::memcpy(pairs.data(), at, pairs.size() * sizeof(Item));
  if (!walls.empty()) std::memcpy(walls.data(), at + pairs.size() * sizeof(Item), walls.size() * sizeof(Item));
  last_substep = head.last_substep;
  const auto sorted = [](const Item& x, const Item& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
  const auto by_slot = [](const Item& x, const Item& y) { return x.b != y.b ? x.b < y.b : x.a < y.a; };
  const std::size_t slots = scene.bodies.count, faces = scene.walls.size();
  return std::all_of(pairs.begin(), pairs.end(), [&](const Item& c) { return c.a < c.b && c.b < slots; }) &&
         std::all_of(walls.begin(), walls.end(), [&](const Item& c) { return c.a < faces && c.b < slots; }) &&
         std::is_sorted(pairs.begin(), pairs.end(), sorted) && std::is_sorted(walls.begin(), walls.end(), by_slot);
}

}  // namespace

std::vector<ContactSet::Saved> ContactSet::saved_pairs() const {
  std::vector<Saved> list;
  for (std::uint32_t rank = 0; rank + 1 < first_of_rank.size(); ++rank) {
    for (std::uint32_t i = first_of_rank[rank]; i < first_of_rank[rank + 1]; ++i) {
      const Contact& contact = pairs[place[i]];
      list.push_back({rank, other_[i], contact.solved, contact.relaxed, contact.normal});
    }
  }
  return list;
}

std::vector<ContactSet::Saved> ContactSet::saved_walls() const {
  std::vector<Saved> list;
  for (std::uint32_t rank = 0; rank + 1 < first_wall_of_rank.size(); ++rank) {
    for (std::uint32_t i = first_wall_of_rank[rank]; i < first_wall_of_rank[rank + 1]; ++i) {
      list.push_back({walls[i].a, rank, walls[i].solved, walls[i].relaxed, walls[i].normal});
    }
  }
  return list;
}

/// As if these were the contacts of the last step: the next one takes its impulses from them.
void ContactSet::restore(const std::vector<Saved>& saved_pairs, const std::vector<Saved>& saved_walls,
                         std::size_t slots) {
  const auto take = [](const std::vector<Saved>& saved, std::vector<Contact>& list) {
    list.assign(saved.size(), {});
    for (std::size_t i = 0; i < saved.size(); ++i) {
      list[i].a = saved[i].a;
      list[i].solved = saved[i].solved, list[i].relaxed = saved[i].relaxed;
      list[i].normal = saved[i].normal;
    }
  };
  const auto count = [&](const std::vector<Saved>& saved, std::vector<std::uint32_t>& first, auto rank_of) {
    first.assign(slots + 1, 0);
    for (const Saved& contact : saved) ++first[rank_of(contact) + 1];
    for (std::size_t slot = 0; slot < slots; ++slot) first[slot + 1] += first[slot];
  };
  take(saved_pairs, pairs);
  take(saved_walls, walls);
  count(saved_pairs, first_of_rank, [](const Saved& contact) { return contact.a; });
  count(saved_walls, first_wall_of_rank, [](const Saved& contact) { return contact.b; });
  place.resize(pairs.size());
  other_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) place[i] = static_cast<std::uint32_t>(i), other_[i] = saved_pairs[i].b;
}

std::vector<std::byte> ImpulseSolver::save() const {
  return packed(last_substep_, set_.saved_pairs(), set_.saved_walls());
}

bool ImpulseSolver::restore(const std::vector<std::byte>& bytes) {
  std::vector<Saved> pairs, touching;
  Real last_substep = 0;
  if (!unpack(bytes, *this, last_substep, pairs, touching)) return false;
  set_.restore(pairs, touching, bodies.count);
  last_substep_ = last_substep;
  return true;
}

std::vector<std::byte> Penalty::save() const {
  if (was_restored_) return packed(0, known_.pairs, known_.walls);
  Memories all;
  remember(all);
  return packed(0, all.pairs, all.walls);
}

/// The next step lists neighbours anew and gives them what they remember.
bool Penalty::restore(const std::vector<std::byte>& bytes) {
  Memories saved;
  Real none = 0;
  if (!unpack(bytes, *this, none, saved.pairs, saved.walls)) return false;
  known_ = saved;  // a copy: the room that there is stays
  was_restored_ = true;
  return true;
}

}  // namespace ballpark::BALLPARK_PRECISION
