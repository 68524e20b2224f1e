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
constexpr std::size_t sets_per_task = 64, contacts_per_task = 256, most_blocks = 16;
/// Updates of a set: as many as it takes, but large sets share a budget.
constexpr std::size_t most_updates = 400, update_budget = 8192, least_updates = 4;

template <class T>
void append(std::vector<T>& list, const T& item) {
  if (list.size() == list.capacity()) list.reserve(list.size() * 5 / 4 + 16);
  list.push_back(item);
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

void Impacts::begin(const ContactBodies& bodies, std::vector<Mover>& movers) {
  const std::size_t slots = bodies.count;
  bodies_ = &bodies;
  movers_ = &movers;
  movers.resize(slots);
  is_touched_.resize(slots, 0);
  scale_.resize(slots);
  spent_.resize(slots);
  earliest_.resize(slots);
  parent_.resize(slots);
  set_of_root_.resize(slots);
  for (const std::uint32_t slot : touched_) is_touched_[slot] = 0;
  touched_.clear();
  count = rounds = unfinished = 0;
}

void Impacts::resolve(const Substep& substep, ContactSet& set, const std::vector<std::vector<Index>>& first,
                      Workers& workers) {
  pair_count_ = set.pairs.size();
  next_.clear();
  for (const auto& list : first) next_.insert(next_.end(), list.begin(), list.end());
  while (!next_.empty()) {
    find_meetings(substep, set, workers);
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

/// Of the contacts in `next_` those that meet and approach, in the order of ranks. All are held against the bodies as
/// the last round left them, so that their own order does not matter.
void Impacts::find_meetings(const Substep& substep, ContactSet& set, Workers& workers) {
  const std::size_t per_block = std::max(contacts_per_task, (next_.size() + most_blocks - 1) / most_blocks);
  const std::size_t blocks = (next_.size() + per_block - 1) / per_block;
  if (found_.size() < blocks) found_.resize(blocks);
  const auto find = [&](std::size_t block) {
    Found& found = found_[block];
    found.hits.clear();
    found.unfinished = 0;
    const std::size_t first = block * per_block, last = std::min(first + per_block, next_.size());
    for (std::size_t i = first; i < last; ++i) {
      Hit hit;
      if (approaches(substep, set, next_[i], hit, found.unfinished)) append(found.hits, hit);
    }
  };
  workers.for_each(blocks, find, blocks < 2 ? 1 : workers.threads());
  hits_.clear();
  for (std::size_t block = 0; block < blocks; ++block) {
    unfinished += found_[block].unfinished;
    for (const Hit& hit : found_[block].hits) append(hits_, hit);
  }
  std::sort(hits_.begin(), hits_.end(), [](const Hit& x, const Hit& y) { return x.index < y.index; });
  meetings_.clear();
  for (const Hit& hit : hits_) append(meetings_, meeting_of(substep, set, hit));
}

Vector3<Real> Impacts::start_over(const Substep& substep, const Contact& contact, bool wall) {
  const VectorColumn& velocity = substep.bodies.velocity;
  return velocity.at(contact.b) - (wall ? substep.moments[contact.a].velocity : velocity.at(contact.a));
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
    each_body(m,
              [&](std::uint32_t slot) { earliest_[slot] = std::min(earliest_[slot], static_cast<float>(m.moment)); });
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

/// Places the contact anew; true if its sides approach and meet.
bool Impacts::approaches(const Substep& substep, ContactSet& set, Index index, Hit& hit,
                         std::uint64_t& given_up) const {
  const bool wall = is_wall(index);
  Contact& contact = wall ? set.walls[index - pair_count_] : set.pairs[set.place[index]];
  mark_of(set, index) &= static_cast<std::uint8_t>(~ContactSet::queued);
  const std::uint32_t a = contact.a, b = contact.b;
  const auto inverse_mass = [&](std::uint32_t slot) { return substep.bodies.inverse_mass[slot]; };
  const auto scale_of = [&](std::uint32_t slot) { return is_touched_[slot] ? Real(scale_[slot]) : Real(0); };
  const Vector3<Real> kick_a = wall ? Vector3<Real>{} : kick_of(a), kick_b = kick_of(b);
  hit.index = index;
  hit.moment = substep.place(contact, wall, kick_a, kick_b);
  const Real base = contact.loaded() ? Real(0) : dot(contact.normal, start_over(substep, contact, wall));
  hit.approach = -(base + dot(contact.normal, kick_b - kick_a));
  const Real noticed = std::max(negligible * std::max(wall ? Real(0) : scale_of(a), scale_of(b)),
                                contact.sum().normal * (inverse_mass(b) + (wall ? Real(0) : inverse_mass(a))));
  if (hit.moment > 1 || !(hit.approach > noticed)) return false;
  const auto spent = [&](std::uint32_t slot) { return is_touched_[slot] && spent_[slot] >= most_spent; };
  if (!spent(b) && (wall || !spent(a))) return true;
  ++given_up;
  return false;
}

/// What its set needs to know of a contact that was hit; its bodies count as touched.
Impacts::Meeting Impacts::meeting_of(const Substep& substep, const ContactSet& set, const Hit& hit) {
  const bool wall = is_wall(hit.index);
  const Contact& contact = wall ? set.walls[hit.index - pair_count_] : set.pairs[set.place[hit.index]];
  const ContactBodies& bodies = substep.bodies;
  const std::uint32_t a = contact.a, b = contact.b;
  const ImpactLaw& law = wall ? substep.laws.of(substep.walls[a].material, bodies.material[b])
                              : substep.laws.of(bodies.material[a], bodies.material[b]);
  Meeting meeting;
  meeting.index = hit.index;
  meeting.contact = &contact;
  meeting.moment = hit.moment;
  const auto of_a = [&](const std::vector<Real>& values) { return wall ? Real(0) : values[a]; };
  const Real inverse = of_a(bodies.inverse_mass) + bodies.inverse_mass[b];
  meeting.normal_mass = 1 / inverse;
  meeting.tangent_mass = 1 / (inverse + of_a(bodies.mobility) + bodies.mobility[b]);
  meeting.drift = start_over(substep, contact, wall);
  meeting.base = contact.loaded() ? Real(0) : dot(contact.normal, meeting.drift);
  meeting.wanted =
      hit.approach > substep.restitution_threshold ? law.restitution_at(hit.approach) * hit.approach : Real(0);
  if (bodies.spins) {
    Vector3<Real> surfaces = bodies.surface.at(b);
    if (!wall) surfaces += bodies.surface.at(a);
    meeting.drift -= cross(surfaces, contact.normal);
  }
  for (const std::uint32_t slot : {wall ? b : a, b}) touch(slot, hit.approach);
  return meeting;
}

void Impacts::touch(std::uint32_t slot, Real approach) {
  if (!is_touched_[slot]) {
    is_touched_[slot] = 1;
    touched_.push_back(slot);
    (*movers_)[slot] = {{}, {}, bodies_->inverse_mass[slot], bodies_->mobility[slot]};
    scale_[slot] = 0;
    spent_[slot] = 0;
  }
  scale_[slot] = std::max(scale_[slot], static_cast<float>(approach));
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
  for (std::size_t i = first; i < last; ++i)
    fastest = std::max(fastest, Real(scale_[meetings_[sorted_[i]].contact->b]));
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
    mark_of(set, meeting.index) |= ContactSet::reflected;
    if (!wall) spent_[contact.a] += cost;
    spent_[contact.b] += cost;
  }
}

/// Gauss-Seidel: this contact's own law, given the others' impulses. Friction is capped by the whole impulse.
Real Impacts::update(Meeting& m) {
  const Contact& c = *m.contact;
  const bool wall = is_wall(m.index);
  Mover& b = (*movers_)[c.b];
  Mover* a = wall ? nullptr : &(*movers_)[c.a];
  const Vector3<Real> kicks = wall ? b.velocity : b.velocity - a->velocity;
  const Real speed = m.base + dot(c.normal, kicks);
  const Real impulse = std::max(Real(0), m.impulse + m.normal_mass * (m.wanted - speed));
  const Real error = std::abs(impulse - m.impulse) / m.normal_mass;
  Vector3<Real> push = (impulse - m.impulse) * c.normal;
  m.impulse = impulse;
  if (bodies_->spins) {
    Vector3<Real> spins = b.surface;
    if (!wall) spins += a->surface;
    const Vector3<Real> over = m.drift + kicks;
    const Vector3<Real> slip = over - dot(c.normal, over) * c.normal - cross(spins, c.normal);
    const Vector3<Real> tangent = within_cone(m.tangent - m.tangent_mass * slip, c.friction * impulse);
    const Vector3<Real> change = tangent - m.tangent, turned = cross(c.normal, change);
    m.tangent = tangent;
    push += change;
    b.twist(turned);
    if (!wall) a->twist(turned);
  }
  b.push(push);
  if (!wall) a->push(Real(-1) * push);
  return error;
}

std::uint8_t& Impacts::mark_of(ContactSet& set, Index index) const {
  return is_wall(index) ? set.wall_marks[index - pair_count_] : set.pair_marks[set.place[index]];
}

/// All contacts of the bodies that just changed, each once.
void Impacts::gather_next(ContactSet& set) {
  if (!neighbours_known_) find_neighbours(set);
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  next_.clear();
  const auto add = [&](Index index) {
    std::uint8_t& mark = mark_of(set, index);
    if (mark & ContactSet::queued) return;
    mark |= ContactSet::queued;
    next_.push_back(index);
  };
  for (const Index index : later_) add(index);
  for (const std::uint32_t slot : changed_) {
    const std::uint32_t rank = bodies_->rank_of(slot);
    for (Index i = set.first_of_rank[rank]; i < set.first_of_rank[rank + 1]; ++i) add(i);
    for (Index i = set.first_wall_of_rank[rank]; i < set.first_wall_of_rank[rank + 1]; ++i) {
      add(static_cast<Index>(i + pair_count_));
    }
    for (std::uint32_t i = before_begin_[rank]; i < before_begin_[rank + 1]; ++i) add(before_[i]);
  }
}

/// For each rank the pairs in which it comes second.
void Impacts::find_neighbours(const ContactSet& set) {
  const std::size_t slots = is_touched_.size();
  before_begin_.assign(slots + 1, 0);
  before_.resize(pair_count_);
  for (const Contact& contact : set.pairs) ++before_begin_[bodies_->rank_of(contact.b)];
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : before_begin_) begin = sum += begin;
  for (std::size_t i = pair_count_; i-- > 0;) {
    before_[--before_begin_[bodies_->rank_of(set.pairs[set.place[i]].b)]] = static_cast<std::uint32_t>(i);
  }
  neighbours_known_ = true;
}

std::size_t Impacts::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  std::size_t found = of(found_) + of(hits_);
  for (const Found& block : found_) found += of(block.hits);
  return found + of(touched_) + of(meetings_) + of(sorted_) + of(next_) + of(is_touched_) + of(scale_) + of(spent_) +
         of(earliest_) + of(later_) + of(changed_) + of(parent_) + of(set_of_root_) + of(set_begin_) +
         of(before_begin_) + of(before_);
}

}  // namespace ballpark::BALLPARK_PRECISION
