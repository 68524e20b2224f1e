// Single bodies: where they are, their state by value, and changes between steps.
#include <cmath>
#include <stdexcept>

#include "engine/world/inertia.h"
#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& message) {
  throw SceneError(path, message);
}

void require_finite(const char* call, const char* what, const Vector3d& v) {
  for (int c = 0; c < 3; ++c) {
    if (std::isfinite(static_cast<Real>(v[c]))) continue;
    refuse(call, std::string(what) + " is not finite in this precision, expected three numbers");
  }
}

template <class V>
Vector3d to_double(const Vector3<V>& a) {
  return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}
template <std::size_t n>
Vector3<Real> read(Real* const (&columns)[n], std::size_t row) {
  return {columns[0][row], columns[1][row], columns[2][row]};
}
void write(Real* const (&columns)[3], std::size_t row, const Vector3<Wide>& a) {
  columns[0][row] = static_cast<Real>(a.x);
  columns[1][row] = static_cast<Real>(a.y);
  columns[2][row] = static_cast<Real>(a.z);
}
Vector3<Wide> widened(const Vector3<Real>& a) {
  return {a.x, a.y, a.z};
}

}  // namespace

Body<Real> body_at(const Group& group, std::size_t row) {
  return with_carried(group.carried, [&]<class M>() {
    const auto c = M::template constants<Real>(group.kernel.constants, row);
    Real y[M::size];
    M::load(group.kernel.state, row, y);
    return M::body(c, y);
  });
}

void place_pivoted(const Group& group, std::size_t row) {
  const auto c = PivotedMotion::constants<Real>(group.kernel.constants, row);
  Real y[PivotedMotion::size];
  PivotedMotion::load(group.kernel.state, row, y);
  PivotedMotion::store(group.kernel.state, c, y);
}

Vector3<Wide> momentum_for(const Group& group, std::size_t row, const Quaternion& orientation,
                           const Vector3<Wide>& spin) {
  const Real mass = group.kernel.constants.mass.at<Real>(row);
  const Vector3<Wide> inertia = wide(group.inertia[group.inertia.size() == 1 ? 0 : group.copies.index_of(row)]);
  Vector3<Wide> arm;
  if (group.pivots()) arm = widened(vector_at<Real>(group.kernel.constants.arm, row));
  if (!group.turns()) return momentum_in_body(inertia, Wide(mass), arm, spin);
  const Rotation<Wide> r = rotation_of(orientation);
  const Vector3<Wide> own = momentum_in_body(inertia, Wide(mass), arm, r.to_body(spin));
  return group.carried == MotionKind::body_frame ? own : r.to_world(own);
}

bool is_finite(const Group& group, std::size_t row) {
  return with_carried(group.carried, [&]<class M>() {
    Real y[M::size];
    M::load(group.kernel.state, row, y);
    for (const Real value : y) {
      if (!std::isfinite(value)) return false;
    }
    return true;
  });
}

bool all_finite(const Group& group, const Block& block) {
  for (std::size_t row = block.first; row < block.last; ++row) {
    if (group.presence.has(row) && !is_finite(group, row)) return false;
  }
  return true;
}

void Group::list_instances() {
  instances.clear();
  LocalForces& forces = kernel.forces;
  forces.read_position = false;
  const auto list = [&](bool EffectInfo::*does) {
    for (std::size_t e = 0; e < effects.size(); ++e) {
      const EffectInfo& info = local_effects()[e];
      for (std::size_t at = 0; info.*does && at < effects[e].size(); at += info.constants_size) {
        instances.push_back({static_cast<int>(e), effects[e].data() + at});
        if (info.reads("position")) forces.read_position = true;
      }
    }
    return instances.size();
  };
  const std::size_t pushing = list(&EffectInfo::pushes), all = list(&EffectInfo::flows);
  forces.begin = instances.data();
  forces.end = forces.flow_begin = forces.begin + pushing;
  forces.flow_end = forces.begin + all;
}

bool Group::answers_to_loads() const {
  for (std::size_t e = 0; e < effects.size(); ++e) {
    if (local_effects()[e].reads_loads && !effects[e].empty()) return true;
  }
  return false;
}

double Group::added_mass(std::size_t row) const {
  double sum = 0;
  for (std::size_t e = 0; e < effects.size(); ++e) {
    const EffectInfo& info = local_effects()[e];
    for (std::size_t at = 0; info.added_mass && at < effects[e].size(); at += info.constants_size) {
      sum += static_cast<double>(info.added_mass(effects[e].data() + at, row));
    }
  }
  return sum;
}

World::Place World::place_of(std::size_t id) const {
  const std::size_t copy = id / per_copy_, in_copy = id % per_copy_;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    const std::size_t index = in_copy - group.id_offset;  // wraps for groups behind it
    if (in_copy >= group.id_offset && index < group.copies.per_copy) return {g, group.copies.row_of(copy, index)};
  }
  throw std::out_of_range("no body has this id");
}

World::Place World::known_place(std::size_t id, const char* call) const {
  if (id >= body_count()) {
    refuse(call,
           "body " + std::to_string(id) + " does not exist, expected an id below " + std::to_string(body_count()));
  }
  return place_of(id);
}

/// What is changed in a look would be lost with it.
World::Place World::place_to_change(std::size_t id, const char* call) const {
  if (looks_ > 0) refuse(call, "called from within a look, whose changes are lost; expected a call between steps");
  const Place place = known_place(id, call);
  if (!groups_[place.group].presence.has(place.row)) {
    refuse(call, "body " + std::to_string(id) + " is not there: it has not entered yet, or is gone");
  }
  return place;
}

std::size_t World::row_of(std::size_t id) const {
  if (id >= body_count()) throw std::out_of_range("no body has this id");
  const Place place = place_of(id);
  return groups_[place.group].first_row + place.row;
}

std::size_t World::id_of(const Group& group, std::size_t row) const {
  return group.copies.copy_of(row) * per_copy_ + group.id_offset + group.copies.index_of(row);
}

std::vector<ContactLoad> World::contact_loads() const {
  if (!contacts_) refuse("contact_loads", "bodies do not touch in this scene, expected one with [contact]");
  const std::vector<BodyLoad> loads = contacts_->loads(groups_, time(), workers_);
  std::vector<ContactLoad> all(body_count());
  for (const SlotRange& range : contacts_->ranges) {
    for (std::size_t i = 0; i < range.count; ++i) {
      const BodyLoad& load = loads[range.first_slot + i];
      all[id_of(groups_[range.group], range.first_row + i)] = {load.contacts, to_double(load.force)};
    }
  }
  return all;
}

BodyState World::body(std::size_t id) const {
  const auto [g, row] = known_place(id, "body");
  const Group& group = groups_[g];
  const Body<Real> b = body_at(group, row);
  BodyState state{to_double(b.position), to_double(b.velocity),  {}, to_double(b.spin), group.turns(),
                  group.spins(),         group.presence.has(row)};
  if (group.turns()) {
    const auto& q = group.kernel.state.orientation;
    state.orientation = {static_cast<double>(q[0][row]), static_cast<double>(q[1][row]), static_cast<double>(q[2][row]),
                         static_cast<double>(q[3][row])};
  }
  return state;
}

void World::set(std::size_t id, const BodyState& state) {
  const Place place = place_to_change(id, "set");
  const Group& group = groups_[place.group];
  require_finite("set", "position", state.position);
  require_finite("set", "velocity", state.velocity);
  require_finite("set", "angular_velocity", state.angular_velocity);
  const Quaternion& q = state.orientation;
  if (state.has_orientation && !(std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) <= 2e-6)) {
    refuse("set", "orientation is not a unit quaternion");
  }
  if (state.has_orientation && !group.turns()) refuse("set", "group " + group.name + " carries no orientation");
  if (state.has_angular_velocity && !group.spins()) refuse("set", "group " + group.name + " carries no rotation");
  booked_jump(&LedgerBook::outside, [&] { put(place, state, body(id)); });
}

/// What the state does not give stays as it is now.
void World::put(const Place& place, const BodyState& state, const BodyState& now) {
  Group& group = groups_[place.group];
  const std::size_t row = place.row;
  const StateColumns& columns = group.kernel.state;
  const Quaternion orientation = state.has_orientation ? state.orientation : now.orientation;
  const Vector3d spin = state.has_angular_velocity ? state.angular_velocity : now.angular_velocity;
  if (group.turns()) {
    const double values[4] = {orientation.w, orientation.x, orientation.y, orientation.z};
    for (int c = 0; c < 4; ++c) columns.orientation[c][row] = static_cast<Real>(values[c]);
  }
  for (Real* carry : group.carry) carry[row] = 0;
  if (state.has_angular_velocity) group.motion = group.turning;  // what stood still until now may turn
  if (group.spins()) write(columns.momentum, row, momentum_for(group, row, orientation, wide(spin)));
  forget_rates();
  if (group.pivots()) return place_pivoted(group, row);
  write(columns.position, row, wide(state.position));
  write(columns.velocity, row, wide(state.velocity));
}

/// A sudden change of momentum, and of angular momentum by its moment.
void World::kick(const Place& place, const Vector3d& J, const Vector3d& offset) {
  Group& group = groups_[place.group];
  if (offset != Vector3d::Zero()) group.motion = group.turning;
  const StateColumns& columns = group.kernel.state;
  const std::size_t row = place.row;
  const Body<Real> b = body_at(group, row);
  const Real effective = group.kernel.constants.effective_mass.at<Real>(row);
  Vector3<Wide> lever = wide(offset);
  if (group.pivots()) {
    lever += widened(b.position - vector_at<Real>(group.kernel.constants.pivot, row));
  } else {
    write(columns.velocity, row, widened(b.velocity) + (1 / static_cast<Wide>(effective)) * wide(J));
  }
  if (group.spins()) {
    Vector3<Wide> change = cross(lever, wide(J));
    if (group.carried == MotionKind::body_frame)
      change = rotation_of(body(id_of(group, row)).orientation).to_body(change);
    write(columns.momentum, row, widened(read(columns.momentum, row)) + change);
  }
  if (group.pivots()) place_pivoted(group, row);
  forget_rates();
}

void World::apply_impulse(std::size_t id, const Vector3d& J, const Vector3d& offset) {
  const Place place = place_to_change(id, "apply_impulse");
  require_finite("apply_impulse", "J", J);
  require_finite("apply_impulse", "offset", offset);
  if (!groups_[place.group].spins() && offset != Vector3d::Zero()) {
    refuse("apply_impulse", "group " + groups_[place.group].name + " carries no rotation, expected an offset of zero");
  }
  booked_jump(&LedgerBook::outside, [&] { kick(place, J, offset); });
}

void World::schedule_impulse(const Impulse& impulse) {
  const Place place = place_to_change(impulse.id, "apply_impulse_at");
  require_finite("apply_impulse_at", "J", impulse.J);
  require_finite("apply_impulse_at", "offset", impulse.offset);
  if (!std::isfinite(impulse.at) || impulse.at < time()) {
    refuse("apply_impulse_at", "at is " + std::to_string(impulse.at) + " s, expected a time from now on");
  }
  if (!groups_[place.group].spins() && impulse.offset != Vector3d::Zero()) {
    refuse("apply_impulse_at",
           "group " + groups_[place.group].name + " carries no rotation, expected an offset of zero");
  }
  add_event({impulse.at, impulse});
}

/// An instance of the effect `force` or `torque` for one body.
void World::apply_load(const std::string& kind, std::size_t id, const Vector3d& load, double at, double until) {
  const std::string call = "apply_" + kind;
  const Place place = place_to_change(id, call.c_str());
  require_finite(call.c_str(), kind.c_str(), load);
  if (!(at < until)) refuse(call, "until is not after at");
  if (until <= time()) refuse(call, "until is over, expected a time from now on");
  Group& group = groups_[place.group];
  const auto index = static_cast<std::size_t>(local_effect_index(kind));
  const EffectInfo& info = local_effects()[index];
  if (kind == "torque") {
    if (!group.spins()) refuse(call, "group " + group.name + " carries no rotation");
    group.motion = group.turning;  // from now on a torque changes its spin
  }
  forget_rates();
  std::map<std::string, Value> parameters{{kind, load}, {"at", at}, {"until", until}};
  for (const ParameterInfo& p : info.description.parameters) {
    if (p.fallback) parameters.emplace(p.name, *p.fallback);
  }
  std::vector<std::byte>& instances = group.effects[index];
  instances.resize(instances.size() + info.constants_size);
  void* constants = instances.data() + instances.size() - info.constants_size;
  info.pack({parameters, 0, {}}, constants);
  info.rows(constants)->row = static_cast<std::ptrdiff_t>(place.row);
  group.list_instances();
  for (const double edge : {at, until}) {
    if (std::isfinite(edge) && edge > time()) add_event({edge, {}});
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
