#include "engine/contact/penalty.h"

#include <algorithm>

namespace ballpark::BALLPARK_PRECISION {

namespace {

Vector3<Real> real(const Vector3<double>& a) {
  return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
}

Vector3<Real> across(const Vector3<Real>& a, const Vector3<Real>& normal) {
  return a - dot(a, normal) * normal;
}

/// Where the spring is in a phase: moved by the rates of those before it.
Vector3<Real> moved(const Vector3<Real>& slid, const std::vector<Vector3<Real>>& rates, std::size_t contacts,
                    std::size_t i, std::span<const Real> weights) {
  Vector3<Real> sum = slid;
  for (std::size_t p = 0; p < weights.size(); ++p) {
    if (weights[p] != 0) sum += weights[p] * rates[p * contacts + i];
  }
  return sum;
}

}  // namespace

void Penalty::begin(double time, Real h, Workers& workers) {
  if (returns) counters_before_ = counters_;
  keep_list(time, h, workers);
  for_blocks(workers, [&](std::size_t first, std::size_t last, Part& part) {
    for (std::size_t i = first; i < last; ++i) {
      const bool alone = list_.first[i] == list_.first[i + 1] && first_wall_[i] == first_wall_[i + 1] &&
                         list_.first_lower[i] == list_.first_lower[i + 1];
      part.stepped += !alone && h * length(bodies.velocity.at(i)) > bodies.radius[i];
    }
  });
  if (returns) {
    for (Contacts* contacts : {&pairs_, &walls_}) contacts->before = contacts->slid;
  }
  for (const Part& part : parts_) counters_.stepped += part.stepped;
  const std::uint64_t neighbours = pairs_.size() + walls_.size();
  counters_.pairs += neighbours;
  counters_.peak_pairs = std::max(counters_.peak_pairs, neighbours);
}

void Penalty::take_back() {
  counters_before_.lists = counters_.lists;
  counters_ = counters_before_;
  for (Contacts* contacts : {&pairs_, &walls_}) contacts->slid = contacts->before;
}

void Penalty::set_moments(double time) {
  moments_.resize(walls.size());
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const WallMotion& motion = walls[w].motion;
    moments_[w].offset = real(motion.displacement(time));
    moments_[w].velocity = real(motion.velocity_at(time)) + walls[w].belt;
  }
}

/// Levers end where the surfaces meet, in proportion to the radii: so forces keep angular momentum.
bool Penalty::meets(std::size_t a, std::size_t b, Meeting& meeting) const {
  const Vector3<Real> apart = nearest_image(bodies.position.at(b) - bodies.position.at(a), period);
  const Real reach = bodies.radius[a] + bodies.radius[b], square = dot(apart, apart);
  if (!(square < reach * reach)) return false;
  const Gap<Real> gap = gap_between(apart, bodies.radius[a], bodies.radius[b]);
  const Real distance = reach + gap.distance;
  const Vector3<Real> over = bodies.velocity.at(b) - bodies.velocity.at(a);
  Touch& touch = meeting.touch;
  touch.depth = -gap.distance, touch.normal = gap.normal;
  touch.parting = dot(touch.normal, over);
  meeting.lever = distance / reach;
  if (!bodies.spins) return true;
  const Vector3<Real> sideways = over - touch.parting * touch.normal;
  touch.slip = sideways - meeting.lever * cross(bodies.surface.at(a) + bodies.surface.at(b), touch.normal);
  meeting.turning = distance > 0 ? (1 / distance) * sideways : Vector3<Real>{};
  const Vector3<Real> spins =
      (1 / bodies.radius[a]) * bodies.surface.at(a) + (1 / bodies.radius[b]) * bodies.surface.at(b);
  meeting.spin = (dot(spins, touch.normal) / 2) * touch.normal;
  return true;
}

bool Penalty::meets_wall(std::size_t wall, std::size_t slot, Meeting& meeting) const {
  const Real radius = bodies.radius[slot];
  const Vector3<Real> x = bodies.position.at(slot) - moments_[wall].offset;
  const Gap<Real> gap = std::visit([&](const auto& shape) { return gap_to(shape, x, radius); }, walls[wall].shape);
  if (!(gap.distance < 0)) return false;
  const Vector3<Real> over = bodies.velocity.at(slot) - moments_[wall].velocity;
  Touch& touch = meeting.touch;
  touch.depth = -gap.distance, touch.normal = gap.normal;
  touch.parting = dot(touch.normal, over);
  meeting.lever = (radius + gap.distance) / radius;
  if (!bodies.spins) return true;
  touch.slip = over - touch.parting * touch.normal - meeting.lever * cross(bodies.surface.at(slot), touch.normal);
  return true;
}

/// Writes a contact's force, with its tangential spring at `slid`.
Penalty::Held Penalty::bear(Contacts& contacts, std::size_t i, const Meeting& meeting, const Vector3<Real>& slid) {
  const SpringDashpot& law = contacts.laws[i];
  const Touch& touch = meeting.touch;
  const Real pressed = push(law, touch, settings.may_pull);
  contacts.forces[i] = (pressed - law.cohesion) * touch.normal;
  if (contacts.slid.empty()) return {};
  contacts.twists[i] = {};
  if (law.friction == 0) return {};
  Held held;
  held.force = friction(law, touch, pressed, slid, held.share);
  contacts.forces[i] += held.force;
  contacts.twists[i] = meeting.lever * cross(touch.normal, held.force);
  return held;
}

/// Writes a contact's force in the phase, and the rate of its tangential spring. Where the spring itself is at hand,
/// one that slips is set so that with its dashpot it pulls as hard as friction holds.
void Penalty::press(Contacts& contacts, std::size_t i, std::span<const Real> stage, bool touching,
                    const Meeting& meeting) {
  const std::size_t rate = stage.size() * contacts.size() + i;
  contacts.touches[i] = touching;
  const bool slides = !contacts.slid.empty(), starts = stage.empty();
  if (!touching) {
    if (slides && starts) contacts.slid[i] = {};
    if (slides) contacts.rates[rate] = {};
    return;
  }
  const SpringDashpot& law = contacts.laws[i];
  const Touch& touch = meeting.touch;
  const bool rubs = slides && law.friction != 0;
  Vector3<Real> slid;
  if (rubs) slid = across(moved(contacts.slid[i], contacts.rates, contacts.size(), i, stage), touch.normal);
  const Held held = bear(contacts, i, meeting, slid);
  if (slides) contacts.rates[rate] = {};
  if (!rubs) return;
  if (starts && held.share < 1) slid = (Real(-1) / law.slide_stiffness) * (held.force + law.slide_damping * touch.slip);
  if (starts) contacts.slid[i] = slid;
  contacts.rates[rate] = slide_rate(meeting, slid);
}

/// The spring slips with the surfaces and turns with the normal and about it.
Vector3<Real> Penalty::slide_rate(const Meeting& meeting, const Vector3<Real>& slid) {
  const Touch& touch = meeting.touch;
  return touch.slip - dot(slid, meeting.turning) * touch.normal + cross(meeting.spin, slid);
}

void Penalty::touch_all(std::span<const Real> stage, std::size_t first, std::size_t last, Part& part) {
  for_meetings(first, last, [&](Contacts& contacts, std::size_t i, bool touching, const Meeting& meeting) {
    press(contacts, i, stage, touching, meeting);
    part.contacts += touching;
    if (touching) part.deepest = std::max(part.deepest, meeting.touch.depth);
  });
}

void Penalty::drift(Real h, Workers& workers) {
  if (!bodies.spins || h == 0) return;
  for_blocks(workers, [&](std::size_t first, std::size_t last, Part&) {
    for_meetings(first, last, [&](Contacts& contacts, std::size_t i, bool touching, const Meeting& meeting) {
      if (!touching || contacts.laws[i].friction == 0) return;
      const Vector3<Real> slid = across(contacts.slid[i], meeting.touch.normal);
      contacts.slid[i] = slid + h * slide_rate(meeting, slid);
    });
  });
}

/// Every body adds up its own contacts in the order of the others' ids, then of the walls.
void Penalty::sum(std::size_t slot) {
  Vector3<Real> all, turned;
  Load load;
  const auto add = [&](const Contacts& contacts, std::uint32_t i, Real side) {
    if (!contacts.touches[i]) return;
    all += side * contacts.forces[i];
    if (!contacts.twists.empty()) turned -= contacts.twists[i];
    ++load.contacts;
    load.damping += damping_per_mass(contacts.laws[i], slot);
  };
  for (std::uint32_t k = list_.first_lower[slot]; k < list_.first_lower[slot + 1]; ++k) add(pairs_, list_.lower[k], 1);
  for (std::uint32_t i = list_.first[slot]; i < list_.first[slot + 1]; ++i) add(pairs_, i, -1);
  for (std::uint32_t i = first_wall_[slot]; i < first_wall_[slot + 1]; ++i) add(walls_, i, 1);
  force.put(slot, all);
  moment.put(slot, turned);
  loads_[slot] = load;
}

/// Of a body's normal and tangential springs, the stiffer.
Real Penalty::stiffness_per_mass(std::size_t slot) const {
  const Real normal = settings.stiffness * bodies.inverse_mass[slot];
  const Real sliding = settings.slide_stiffness * (bodies.inverse_mass[slot] + bodies.mobility[slot]);
  return bodies.spins ? std::max(normal, sliding) : normal;
}

Real Penalty::damping_per_mass(const SpringDashpot& law, std::size_t slot) const {
  const Real normal = law.damping * bodies.inverse_mass[slot];
  return std::max(normal, law.slide_damping * (bodies.inverse_mass[slot] + bodies.mobility[slot]));
}

/// Largest eigenvalue of M^-1 K over the contact network, bounded by blocks of contacts: that of a contact is at most
/// the sum over its two bodies of (contacts of the body) times (stiffness per mass). Exact for two bodies.
void Penalty::bound(std::size_t first, std::size_t last, Part& part) const {
  const auto spring = [&](std::size_t slot) {
    return static_cast<Real>(loads_[slot].contacts) * stiffness_per_mass(slot);
  };
  const auto damping = [&](std::size_t slot) { return loads_[slot].damping; };
  for (std::size_t a = first; a < last; ++a) {
    part.spring = std::max(part.spring, spring(a)), part.damping = std::max(part.damping, damping(a));
    for (std::uint32_t i = list_.first[a]; i < list_.first[a + 1]; ++i) {
      if (!pairs_.touches[i]) continue;
      part.spring = std::max(part.spring, spring(a) + spring(list_.other[i]));
      part.damping = std::max(part.damping, damping(a) + damping(list_.other[i]));
    }
  }
}

void Penalty::find_forces(std::span<const Real> stage, bool first_phase, double time, Workers& workers) {
  set_moments(time);
  const std::size_t phases = stage.size() + 1;
  for (Contacts* contacts : {&pairs_, &walls_}) {
    if (bodies.spins && contacts->rates.size() < phases * contacts->size()) {
      contacts->rates.resize(phases * contacts->size());
    }
  }
  for_blocks(workers, [&](std::size_t first, std::size_t last, Part& part) { touch_all(stage, first, last, part); });
  if (first_phase) {
    std::uint64_t touching = 0;
    for (const Part& part : parts_)
      touching += part.contacts, counters_.deepest = std::max(counters_.deepest, part.deepest);
    counters_.contacts += touching;
    counters_.peak_contacts = std::max(counters_.peak_contacts, touching);
  }
  for_blocks(workers, [&](std::size_t first, std::size_t last, Part&) {
    for (std::size_t slot = first; slot < last; ++slot) sum(slot);
  });
  if (!first_phase) return;
  for_blocks(workers, [&](std::size_t first, std::size_t last, Part& part) { bound(first, last, part); });
  for (const Part& part : parts_) {
    counters_.spring = std::max(counters_.spring, part.spring);
    counters_.damping = std::max(counters_.damping, part.damping);
  }
}

void Penalty::finish(std::span<const Real> weights, Workers& workers) {
  if (!bodies.spins) return;
  const auto advance = [&](Contacts& contacts, std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t i = from; i < to; ++i) {
      contacts.slid[i] = moved(contacts.slid[i], contacts.rates, contacts.size(), i, weights);
    }
  };
  for_blocks(workers, [&](std::size_t first, std::size_t last, Part&) {
    advance(pairs_, list_.first[first], list_.first[last]);
    advance(walls_, first_wall_[first], first_wall_[last]);
  });
}

double Penalty::energy(double time, Workers& workers) {
  keep_list(time, 0, workers);
  set_moments(time);
  double sum = 0;
  for_meetings(0, bodies.count, [&](Contacts& contacts, std::size_t i, bool touching, const Meeting& meeting) {
    if (!touching) return;
    const SpringDashpot& law = contacts.laws[i];
    Real stored = (law.stiffness * meeting.touch.depth - 2 * law.cohesion) * meeting.touch.depth;
    if (!contacts.slid.empty() && law.slide_stiffness > 0) {  // of a spring that slips, what friction holds
      const Real most = law.friction * std::max(Real(0), push(law, meeting.touch, settings.may_pull));
      const Real held = std::min(law.slide_stiffness * length(contacts.slid[i]), most);
      stored += held * held / law.slide_stiffness;
    }
    sum += static_cast<double>(stored / 2);
  });
  return sum;
}

}  // namespace ballpark::BALLPARK_PRECISION
