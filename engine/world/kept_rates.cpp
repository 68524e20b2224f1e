// Rates that outlive a step: an embedded pair's last phase is the next step's first, a multistep method looks back.
// Nothing is copied: pointers to the sets of rates change places.
#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

/// After a step: set 0 becomes the step before, and the place of what is not needed any more is free for the next.
void World::turn_rates() {
  ++turns_;
  arrange_rates();
}

/// Where each set is after so many turns: sets that take turns follow each other in a ring.
void World::arrange_rates() {
  std::vector<std::size_t>& ring = ring_;
  ring.assign(1, 0);
  if (adaptive_) {
    if (keeps_rates_) ring.push_back(static_cast<std::size_t>(unit_.last_set));
  } else {
    for (int j = 0; j < method_.history; ++j) ring.push_back(static_cast<std::size_t>(method_.history_begin + j));
  }
  const std::size_t n = ring.size();
  if (n == 1) return;
  for (Group& group : groups_) {
    const auto size = static_cast<std::size_t>(state_size(group.motion));
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t from = ring[(j + n - turns_ % n) % n];
      for (std::size_t i = 0; i < size && !group.rates.empty(); ++i) {
        group.rates[ring[j] * size + i] = group.rate_columns[from * size + i];
      }
    }
  }
}

/// The state or what acts on it has changed.
void World::forget_rates() {
  known_sets_ = 0;
  method_.first_known = false;
  for (Group& group : groups_) group.rates = group.rate_columns;  // a body that begins to turn has longer sets
  arrange_rates();
}

std::vector<double> World::pace() const {
  return {elapsed_.time,
          elapsed_.rest,
          control_.step,
          control_.error_before,
          static_cast<double>(control_.was_rejected),
          static_cast<double>(method_.first_known),
          static_cast<double>(known_sets_),
          static_cast<double>(turns_),
          static_cast<double>(stuck_),
          static_cast<double>(load_count()),
          part_,
          static_cast<double>(next_event_),
          static_cast<double>(events_.size())};
}

void World::set_pace(const std::vector<double>& pace) {
  elapsed_ = {pace[0], pace[1]};
  control_.step = pace[2];
  control_.error_before = pace[3];
  control_.was_rejected = pace[4] != 0;
  method_.first_known = pace[5] != 0;
  known_sets_ = static_cast<int>(pace[6]);
  turns_ = static_cast<std::size_t>(pace[7]);
  stuck_ = pace[8] != 0;
  part_ = pace[10];
  for (Group& group : groups_) group.rates = group.rate_columns;
  arrange_rates();
  if (pace[9] != static_cast<double>(load_count())) forget_rates();  // asked for since
}

std::size_t World::load_count() const {
  std::size_t count = 0;
  for (const Group& group : groups_) {
    for (std::size_t e = 0; e < group.effects.size(); ++e) count += group.instance_count(e);
  }
  return count;
}

}  // namespace ballpark::BALLPARK_PRECISION
