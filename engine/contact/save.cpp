// Impulses between steps as bytes: a run goes on from a snapshot with the same bits.
#include <algorithm>
#include <cstring>

#include "engine/contact/impulse_solver.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

using Saved = ContactSet::Saved;

struct Head {
  std::uint64_t pairs = 0, walls = 0;
  Real last_substep = 0;
};

}  // namespace

std::vector<ContactSet::Saved> ContactSet::saved_pairs() const {
  std::vector<Saved> list;
  for (const std::uint32_t at : place) list.push_back({pairs[at].a, pairs[at].b, pairs[at].solved, pairs[at].relaxed});
  return list;
}

std::vector<ContactSet::Saved> ContactSet::saved_walls() const {
  std::vector<Saved> list;
  for (const Contact& contact : walls) list.push_back({contact.a, contact.b, contact.solved, contact.relaxed});
  return list;
}

/// As if these were the contacts of the last step: the next one takes its impulses from them.
void ContactSet::restore(const std::vector<Saved>& saved_pairs, const std::vector<Saved>& saved_walls,
                         std::size_t slots) {
  const auto take = [](const std::vector<Saved>& saved, std::vector<Contact>& list) {
    list.assign(saved.size(), {});
    for (std::size_t i = 0; i < saved.size(); ++i) {
      list[i].a = saved[i].a, list[i].b = saved[i].b;
      list[i].solved = saved[i].solved, list[i].relaxed = saved[i].relaxed;
    }
  };
  const auto count = [&](const std::vector<Saved>& saved, std::vector<std::uint32_t>& first, auto slot_of) {
    first.assign(slots + 1, 0);
    for (const Saved& contact : saved) ++first[slot_of(contact) + 1];
    for (std::size_t slot = 0; slot < slots; ++slot) first[slot + 1] += first[slot];
  };
  take(saved_pairs, pairs);
  take(saved_walls, walls);
  count(saved_pairs, first_of_slot, [](const Saved& contact) { return contact.a; });
  count(saved_walls, first_wall_of_slot, [](const Saved& contact) { return contact.b; });
  place.resize(pairs.size());
  other_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) place[i] = static_cast<std::uint32_t>(i), other_[i] = pairs[i].b;
}

std::vector<std::byte> ImpulseSolver::save() const {
  const std::vector<Saved> pairs = set_.saved_pairs(), touching = set_.saved_walls();
  const Head head{pairs.size(), touching.size(), last_substep_};
  std::vector<std::byte> bytes(sizeof head + (pairs.size() + touching.size()) * sizeof(Saved));
  std::memcpy(bytes.data(), &head, sizeof head);
  std::byte* at = bytes.data() + sizeof head;
  if (!pairs.empty()) std::memcpy(at, pairs.data(), pairs.size() * sizeof(Saved));
  if (!touching.empty()) {
    std::memcpy(at + pairs.size() * sizeof(Saved), touching.data(), touching.size() * sizeof(Saved));
  }
  return bytes;
}

bool ImpulseSolver::restore(const std::vector<std::byte>& bytes) {
  Head head;
  if (bytes.size() < sizeof head) return false;
  std::memcpy(&head, bytes.data(), sizeof head);
  const std::size_t room = (bytes.size() - sizeof head) / sizeof(Saved);
  if (head.pairs > room || head.walls != room - head.pairs) return false;
  std::vector<Saved> pairs(head.pairs), touching(head.walls);
  const std::byte* at = bytes.data() + sizeof head;
  if (!pairs.empty()) std::memcpy(pairs.data(), at, pairs.size() * sizeof(Saved));
  if (!touching.empty())
    std::memcpy(touching.data(), at + pairs.size() * sizeof(Saved), touching.size() * sizeof(Saved));
  const auto sorted = [](const Saved& x, const Saved& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
  const auto by_slot = [](const Saved& x, const Saved& y) { return x.b != y.b ? x.b < y.b : x.a < y.a; };
  const bool fits =
      std::all_of(pairs.begin(), pairs.end(), [&](const Saved& c) { return c.a < c.b && c.b < bodies.count; }) &&
      std::all_of(touching.begin(), touching.end(),
                  [&](const Saved& c) { return c.a < walls.size() && c.b < bodies.count; }) &&
      std::is_sorted(pairs.begin(), pairs.end(), sorted) && std::is_sorted(touching.begin(), touching.end(), by_slot);
  if (!fits) return false;
  set_.restore(pairs, touching, bodies.count);
  last_substep_ = head.last_substep;
  return true;
}

}  // namespace ballpark::BALLPARK_PRECISION
