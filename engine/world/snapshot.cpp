// The state as a whole: its hash, copies to return to, and views.
#include <algorithm>
#include <cstring>

#include "engine/core/hash.h"
#include "engine/core/nearest.h"
#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// Long double has 10 bytes of value in 16; the rest is not defined.
constexpr std::size_t value_bytes = std::is_same_v<Real, long double> ? 10 : sizeof(Real);

std::uint64_t hash_rows(const Real* values, std::size_t count, std::uint64_t seed) {
  if constexpr (value_bytes == sizeof(Real)) {
    return hash(values, count * sizeof(Real), seed);
  } else {
    for (std::size_t i = 0; i < count; ++i) seed = hash(values + i, value_bytes, seed);
    return seed;
  }
}

/// One copy's rows of a column that begins with the group's. Absent bodies count as such: NaN has many bit patterns.
std::uint64_t hash_copy(const Group& group, const Real* column, std::size_t copy, std::uint64_t seed) {
  const std::size_t bodies = group.copies.per_copy;
  if (group.presence) {
    for (std::size_t i = 0; i < bodies; ++i) {
      const std::size_t row = group.copies.row_of(copy, i);
      seed = group.presence.has(row) ? hash_rows(column + row, 1, seed) : combine(seed, 1);
    }
    return seed;
  }
  if (copy >= group.copies.woven) return hash_rows(column + copy * bodies, bodies, seed);
  Real values[most_woven] = {};
  for (std::size_t i = 0; i < bodies; ++i) values[i] = column[group.copies.row_of(copy, i)];
  return hash_rows(values, bodies, seed);
}

/// Does the next step need it?
bool lasts(const Column& column) {
  return column.info.role == Role::state || column.info.role == Role::kept;
}

/// Does any force, or the rate of another state column, depend on this column of the group?
bool is_read(const Group& group, const std::string& column) {
  if (column == "orientation") return group.motion != MotionKind::point && group.carried != MotionKind::oriented;
  if (column == "angular_momentum" || column == body_momentum) return group.motion != MotionKind::point;
  return true;
}

}  // namespace

/// In the order of ids: copy by copy, group by group as in the scene.
std::uint64_t World::state_hash() const {
  std::vector<const Group*> in_scene_order;
  for (const Group& group : groups_) in_scene_order.push_back(&group);
  std::sort(in_scene_order.begin(), in_scene_order.end(),
            [](const Group* a, const Group* b) { return a->scene_index < b->scene_index; });
  std::uint64_t sum = 0;
  for (std::size_t copy = 0; copy < copies_; ++copy) {
    for (const Group* group : in_scene_order) {
      for (const Column& column : columns_.all()) {
        if (column.info.role != Role::state || !column.covers(group->first_row) || group->live == 0) continue;
        if (!is_read(*group, column.info.name)) continue;
        for (int c = 0; c < column.info.components; ++c) {
          sum = hash_copy(*group, column.at(c, group->first_row), copy, sum);
        }
      }
    }
  }
  return sum;
}

/// Of what a snapshot must fit: the groups by name and size, what they carry, and the precision.
std::uint64_t World::structure() const {
  std::uint64_t sum = sizeof(Real);
  for (const Group& group : groups_) {
    sum = combine(sum, hash(group.name.data(), group.name.size()));
    for (const std::size_t n :
         {group.live, group.copies.per_copy, group.scene_index, static_cast<std::size_t>(group.carried)}) {
      sum = combine(sum, n);
    }
  }
  return combine(sum, columns_.bytes());
}

Snapshot World::snapshot() const {
  Snapshot copy{.time = time(),
                .structure = structure(),
                .motions = {},
                .counters = counters(),
                .status = status_,
                .columns = {},
                .pace = pace(),
                .contacts = {},
                .ledger = {}};
  if (contacts_) copy.contacts = contacts_->save();
  if (book_) copy.ledger = book_->numbers();
  for (const Group& group : groups_) copy.motions.push_back(group.motion != MotionKind::point);
  for (const Column& column : columns_.all()) {
    if (!lasts(column)) continue;
    for (int c = 0; c < column.info.components; ++c) {
      const auto* bytes = reinterpret_cast<const std::byte*>(column.at(c, column.first_row));
      copy.columns.emplace_back(bytes, bytes + column.rows * sizeof(Real));
    }
  }
  return copy;
}

void World::restore(const Snapshot& snapshot) {
  return_to(snapshot);
  if (book_ && !book_->set_numbers(snapshot.ledger)) keep_ledger(true);
}

void World::return_to(const Snapshot& snapshot) {
  std::size_t count = 0;
  bool fits = snapshot.structure == structure() && snapshot.motions.size() == groups_.size();
  const auto for_each_array = [&](auto act) {
    count = 0;
    for (Column& column : columns_.all()) {
      if (!lasts(column)) continue;
      for (int c = 0; c < column.info.components; ++c, ++count) act(column, c);
    }
  };
  for_each_array([&](const Column& column, int) {
    fits = fits && count < snapshot.columns.size() && snapshot.columns[count].size() == column.rows * sizeof(Real);
  });
  if (!fits || count != snapshot.columns.size() || snapshot.pace.size() != pace().size()) {
    throw SceneError("restore", "the snapshot is of another scene, number of copies or precision");
  }
  if (contacts_ && !contacts_->restore(snapshot.contacts)) {
    throw SceneError("restore", "the contacts of the snapshot do not fit this scene");
  }
  for_each_array([&](Column& column, int c) {
    const std::vector<std::byte>& from = snapshot.columns[count];
    if (!from.empty()) std::memcpy(column.at(c, column.first_row), from.data(), from.size());
  });
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].motion = snapshot.motions[g] ? groups_[g].turning : MotionKind::point;
    groups_[g].presence.recount();
  }
  set_pace(snapshot.pace);
  counters_ = snapshot.counters;
  if (contacts_) contacts_->set_counters(snapshot.counters);
  status_ = snapshot.status;
  watched_stiffness_ = {snapshot.counters.contact_spring, snapshot.counters.contact_damping};
  next_event_ = static_cast<std::size_t>(snapshot.pace[11]);
  if (snapshot.pace[12] == static_cast<double>(events_.size())) return;
  const double now = time() - 1e-9 * step_;  // some were asked for since
  next_event_ = static_cast<std::size_t>(
      std::lower_bound(events_.begin(), events_.end(), now, [](const Event& e, double at) { return e.at < at; }) -
      events_.begin());
}

RawView World::view(const std::string& name) const {
  std::vector<std::string> known;
  for (const Column& column : columns_.all()) {
    if (column.info.role != Role::state) continue;
    known.push_back(column.info.name);
    if (column.info.name != name) continue;
    const std::size_t end = groups_.empty() ? 0 : groups_.back().first_row + groups_.back().live;
    RawView raw{column.first_row, std::min(column.rows, end - column.first_row), {}};
    for (int c = 0; c < column.info.components; ++c) raw.components.push_back(column.at(c, column.first_row));
    return raw;
  }
  throw SceneError("view", "no column \"" + name + "\" in this world" + suggestion(name, known));
}

double World::constant(const std::string& name, const std::string& group_name) const {
  std::vector<std::string> names;
  for (const Group& group : groups_) {
    names.push_back(group.name);
    if (group.name != group_name) continue;
    std::vector<std::string> known;
    for (const auto& [key, value] : group.constants) {
      known.push_back(key);
      if (key == name) return value;
    }
    throw SceneError("constant", "\"" + name + "\" is no constant of group " + group_name + suggestion(name, known));
  }
  throw SceneError("constant", "no group \"" + group_name + "\"" + suggestion(group_name, names));
}

}  // namespace ballpark::BALLPARK_PRECISION
