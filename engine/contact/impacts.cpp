#include "engine/contact/impacts.h"

#include <algorithm>
#include <limits>

#include "engine/contact/rows.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// A round costs each of its bodies the number of contacts that are solved together; a body that has spent this much
/// in a substep is left to the solver. A row of balls passes an impact on in one round each, whatever its length; a
/// collapsing heap is reflected once or twice.
constexpr std::uint32_t most_spent = 128;
/// Approaches this much slower than the impact that set their bodies in motion are left to the solver: a series of
/// ever smaller bounces ends here.
constexpr Real negligible = std::max(Real(1e-9), 8 * std::numeric_limits<Real>::epsilon());
constexpr std::size_t sets_per_task = 64;
/// Updates of a set: as many as it takes, but large sets share a budget.
constexpr std::size_t most_updates = 400, update_budget = 8192, least_updates = 4;

std::size_t contact_index(const std::vector<Contact>& list, const Contact& contact) {
  return static_cast<std::size_t>(&contact - list.data());
}

}  // namespace

Real Substep::place(Contact& contact, bool wall, const Vector3<Real>& kick_a, const Vector3<Real>& kick_b) const {
  const std::uint32_t b = contact.b;
  Vector3<Real> moved = trial(b) + length * kick_b;
  Approach approach;
  if (wall) {
    const WallMoment& moment = moments[contact.a];
    moved -= moment.moved;
    approach = walls[contact.a].approach(bodies.position.at(b) - moment.offset, moved, bodies.radius[b]);
  } else {
    const std::uint32_t a = contact.a;
    moved -= trial(a) + length * kick_a;
    const Vector3<Real> apart = nearest_image(bodies.position.at(b) - bodies.position.at(a), period);
    approach = approach_between(apart, moved, bodies.radius[a] + bodies.radius[b]);
  }
  contact.normal = approach.normal;
  const Real gap = approach.distance;
  contact.least_speed = (gap > 0 ? -gap : -push_out * gap) / length;
  if (!(gap > 0)) return 0;
  return gap + dot(approach.normal, moved) < 0 ? approach.moment : Real(2);
}

void Impacts::begin(std::size_t slots) {
  kick.resize(slots);
  spin_kick.resize(slots);
  is_touched_.resize(slots, 0);
  scale_.resize(slots);
  spent_.resize(slots);
  earliest_.resize(slots);
  parent_.resize(slots);
  set_of_root_.resize(slots);
  for (const std::uint32_t slot : touched) is_touched_[slot] = 0;
  touched.clear();
  count = rounds = unfinished = 0;
}

void Impacts::resolve(const Substep& substep, ContactSet& set, const std::vector<std::vector<Index>>& first,
                      Workers& workers) {
  bodies_ = &substep.bodies;
  pair_count_ = set.pairs.size();
  next_.clear();
  for (const auto& list : first) next_.insert(next_.end(), list.begin(), list.end());
  while (!next_.empty()) {
    meetings_.clear();
    for (const Index index : next_) {
      Meeting meeting;
      if (!approaches(substep, set, index, meeting)) continue;
      if (meetings_.size() == meetings_.capacity()) meetings_.reserve(meetings_.size() * 5 / 4 + 64);
      meetings_.push_back(meeting);
    }
    if (meetings_.empty()) return;
    keep_first();
    ++rounds;
    count += meetings_.size();
    split_into_sets();
    const std::size_t sets = set_begin_.size() - 1;
    const auto solve = [&](std::size_t task) {  // sets share no body
      for (std::size_t s = task * sets_per_task; s < std::min((task + 1) * sets_per_task, sets); ++s) {
        reflect(set_begin_[s], set_begin_[s + 1]);
        spend(set, set_begin_[s], set_begin_[s + 1]);
      }
    };
    const bool few = meetings_.size() < 4 * sets_per_task;
    workers.for_each((sets + sets_per_task - 1) / sets_per_task, solve, few ? 1 : workers.threads());
    gather_next(set);
  }
}

/// A body meets what it meets first; the others wait for the next round, in which they may not meet any more.
void Impacts::keep_first() {
  constexpr Real together = Real(1e-6);  // of a substep
  const auto each_body = [&](const Meeting& m, auto act) {
    if (!is_wall(m.index)) act(m.contact->a);
    act(m.contact->b);
  };
  for (const Meeting& m : meetings_) each_body(m, [&](std::uint32_t slot) { earliest_[slot] = 2; });
  for (const Meeting& m : meetings_) {
    each_body(m, [&](std::uint32_t slot) { earliest_[slot] = std::min(earliest_[slot], m.moment); });
  }
  later_.clear();
  std::size_t kept = 0;
  for (const Meeting& m : meetings_) {
    bool first = true;
    each_body(m, [&](std::uint32_t slot) { first = first && m.moment <= earliest_[slot] + together; });
    if (first) {
      meetings_[kept++] = m;
    } else {
      later_.push_back(m.index);
    }
  }
  meetings_.resize(kept);
}

/// Places the contact anew; true if its sides approach and meet, and then what its set needs to know.
bool Impacts::approaches(const Substep& substep, ContactSet& set, Index index, Meeting& meeting) {
  const bool wall = is_wall(index);
  Contact& contact = wall ? set.walls[index - pair_count_] : set.pairs[set.place[index]];
  const ContactBodies& bodies = substep.bodies;
  const std::uint32_t a = contact.a, b = contact.b;
  const auto scale_of = [&](std::uint32_t slot) { return is_touched_[slot] ? scale_[slot] : Real(0); };
  const Vector3<Real> kick_a = wall ? Vector3<Real>{} : kick_of(a), kick_b = kick_of(b);
  meeting.moment = substep.place(contact, wall, kick_a, kick_b);
  const Vector3<Real> other = wall ? substep.moments[a].velocity : bodies.velocity.at(a);
  const Vector3<Real> over = bodies.velocity.at(b) - other, kicks = kick_b - kick_a;
  meeting.base = contact.loaded() ? Real(0) : dot(contact.normal, over);
  const Real approach = -(meeting.base + dot(contact.normal, kicks));
  const Real noticed = std::max(negligible * std::max(wall ? Real(0) : scale_of(a), scale_of(b)),
                                contact.sum().normal / contact.normal_mass);
  if (meeting.moment > 1 || !(approach > noticed)) return false;
  const auto spent = [&](std::uint32_t slot) { return is_touched_[slot] && spent_[slot] >= most_spent; };
  if (spent(b) || (!wall && spent(a))) {
    ++unfinished;
    return false;
  }
  const ImpactLaw& law = wall ? substep.laws.of(substep.walls[a].material, bodies.material[b])
                              : substep.laws.of(bodies.material[a], bodies.material[b]);
  meeting.index = index;
  meeting.contact = &contact;
  meeting.wanted = approach > substep.restitution_threshold ? law.restitution * approach : Real(0);
  meeting.drift = over;
  if (bodies.spins) {
    Vector3<Real> surfaces = bodies.surface.at(b);
    if (!wall) surfaces += bodies.surface.at(a);
    meeting.drift -= cross(surfaces, contact.normal);
  }
  for (const std::uint32_t slot : {wall ? b : a, b}) {
    touch(slot);
    scale_[slot] = std::max(scale_[slot], approach);
  }
  return true;
}

void Impacts::touch(std::uint32_t slot) {
  if (is_touched_[slot]) return;
  is_touched_[slot] = 1;
  touched.push_back(slot);
  kick.put(slot, {});
  spin_kick.put(slot, {});
  scale_[slot] = 0;
  spent_[slot] = 0;
}

std::uint32_t Impacts::root(std::uint32_t slot) {
  while (parent_[slot] != slot) slot = parent_[slot] = parent_[parent_[slot]];
  return slot;
}

/// Sorts the meetings by the connected set of bodies that they are in, and lists the bodies.
void Impacts::split_into_sets() {
  constexpr std::uint32_t none = ~std::uint32_t(0);
  changed_.clear();
  for (const Meeting& m : meetings_) {
    for (const std::uint32_t slot : {is_wall(m.index) ? m.contact->b : m.contact->a, m.contact->b}) {
      parent_[slot] = slot;
      set_of_root_[slot] = none;
      changed_.push_back(slot);
    }
  }
  for (const Meeting& m : meetings_) {
    if (!is_wall(m.index)) parent_[root(m.contact->a)] = root(m.contact->b);
  }
  set_begin_.assign(1, 0);
  for (Meeting& m : meetings_) {
    std::uint32_t& set = set_of_root_[root(m.contact->b)];
    if (set == none) {
      set = static_cast<std::uint32_t>(set_begin_.size() - 1);
      set_begin_.push_back(0);
    }
    m.set = set;
    ++set_begin_[set + 1];
  }
  for (std::size_t s = 1; s < set_begin_.size(); ++s) set_begin_[s] += set_begin_[s - 1];
  sorted_.resize(meetings_.size());
  for (std::uint32_t i = 0; i < meetings_.size(); ++i) sorted_[set_begin_[meetings_[i].set]++] = i;  // leaves the ends
  set_begin_.insert(set_begin_.begin(), 0);
  set_begin_.pop_back();
}

/// One small solve: impulses that part all contacts of the set at the speeds that they want, none of which pulls.
void Impacts::reflect(std::size_t first, std::size_t last) {
  const std::size_t size = last - first;
  const std::size_t updates = size == 1 ? 1 : std::clamp(update_budget / size, least_updates, most_updates);
  Real fastest = 0;
  for (std::size_t i = first; i < last; ++i) fastest = std::max(fastest, scale_[meetings_[sorted_[i]].contact->b]);
  const Real close = std::numeric_limits<Real>::epsilon() * fastest / 4;
  for (std::size_t n = 0; n < updates; ++n) {
    Real error = 0;
    for (std::size_t i = first; i < last; ++i) error = std::max(error, update(meetings_[sorted_[i]]));
    if (error <= close) return;
  }
}

void Impacts::spend(ContactSet& set, std::size_t first, std::size_t last) {
  const auto cost = static_cast<std::uint32_t>(std::min<std::size_t>(last - first, most_spent));
  for (std::size_t i = first; i < last; ++i) {
    const Meeting& meeting = meetings_[sorted_[i]];
    const Contact& contact = *meeting.contact;
    const bool wall = is_wall(meeting.index);
    (wall ? set.wall_marks[contact_index(set.walls, contact)] : set.pair_marks[contact_index(set.pairs, contact)]) |=
        ContactSet::reflected;
    if (!wall) spent_[contact.a] += cost;
    spent_[contact.b] += cost;
  }
}

Vector3<Real> Impacts::kick_difference(const Contact& contact, bool wall, const VectorColumn& column) const {
  return wall ? column.at(contact.b) : column.at(contact.b) - column.at(contact.a);
}

/// Gauss-Seidel: this contact's own law, given the others' impulses. Friction is capped by the whole impulse.
Real Impacts::update(Meeting& m) {
  const Contact& c = *m.contact;
  const bool wall = is_wall(m.index);
  const Vector3<Real> kicks = kick_difference(c, wall, kick);
  const Real speed = m.base + dot(c.normal, kicks);
  const Real impulse = std::max(Real(0), m.impulse + c.normal_mass * (m.wanted - speed));
  const Real error = std::abs(impulse - m.impulse) / c.normal_mass;
  Vector3<Real> push = (impulse - m.impulse) * c.normal;
  m.impulse = impulse;
  if (bodies_->spins) {
    Vector3<Real> spins = spin_kick.at(c.b);
    if (!wall) spins += spin_kick.at(c.a);
    const Vector3<Real> over = m.drift + kicks;
    const Vector3<Real> slip = over - dot(c.normal, over) * c.normal - cross(spins, c.normal);
    const Vector3<Real> tangent = within_cone(m.tangent - c.tangent_mass * slip, c.friction * impulse);
    const Vector3<Real> change = tangent - m.tangent, turned = cross(c.normal, change);
    m.tangent = tangent;
    push += change;
    spin_kick.put(c.b, spin_kick.at(c.b) - bodies_->mobility[c.b] * turned);
    if (!wall) spin_kick.put(c.a, spin_kick.at(c.a) - bodies_->mobility[c.a] * turned);
  }
  kick.put(c.b, kick.at(c.b) + bodies_->inverse_mass[c.b] * push);
  if (!wall) kick.put(c.a, kick.at(c.a) - bodies_->inverse_mass[c.a] * push);
  return error;
}

/// All contacts of the bodies that just changed, sorted and each once.
void Impacts::gather_next(const ContactSet& set) {
  if (!neighbours_known_) find_neighbours(set);
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  next_ = later_;
  const auto add = [&](std::uint32_t begin, std::uint32_t end, std::size_t offset) {
    for (std::uint32_t i = begin; i < end; ++i) next_.push_back(static_cast<Index>(i + offset));
  };
  for (const std::uint32_t slot : changed_) {
    add(set.first_of_slot[slot], set.first_of_slot[slot + 1], 0);
    add(set.first_wall_of_slot[slot], set.first_wall_of_slot[slot + 1], pair_count_);
    for (std::uint32_t i = before_begin_[slot]; i < before_begin_[slot + 1]; ++i) next_.push_back(before_[i]);
  }
  std::sort(next_.begin(), next_.end());
  next_.erase(std::unique(next_.begin(), next_.end()), next_.end());
}

/// For each slot the pairs in which it comes second.
void Impacts::find_neighbours(const ContactSet& set) {
  const std::size_t slots = is_touched_.size();
  before_begin_.assign(slots + 1, 0);
  before_.resize(pair_count_);
  for (const Contact& contact : set.pairs) ++before_begin_[contact.b];
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : before_begin_) begin = sum += begin;
  for (std::size_t i = pair_count_; i-- > 0;) {
    before_[--before_begin_[set.pairs[set.place[i]].b]] = static_cast<std::uint32_t>(i);
  }
  neighbours_known_ = true;
}

std::size_t Impacts::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  return kick.bytes() + spin_kick.bytes() + of(touched) + of(meetings_) + of(sorted_) + of(next_) + of(is_touched_) +
         of(scale_) + of(spent_) + of(earliest_) + of(later_) + of(changed_) + of(parent_) + of(set_of_root_) +
         of(set_begin_) + of(before_begin_) + of(before_);
}

}  // namespace ballpark::BALLPARK_PRECISION
