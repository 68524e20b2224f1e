// Contacts by penalty between steps: laws of all pairs, lists of neighbours, and what contacts remember while they
// change.
#include <algorithm>

#include "engine/contact/penalty.h"

namespace ballpark::BALLPARK_PRECISION {

void Penalty::prepare() {
  ratios_.clear();
  for (const ImpactLaw& law : laws.laws) {
    ratios_.push_back(damping_ratio(static_cast<double>(law.restitution), settings.may_pull));
  }
  force.resize(bodies.count);
  moment.resize(bodies.count);
  loads_.resize(bodies.count);
  allowance_.resize(bodies.count);
  ahead_.resize(bodies.count);
}

SpringDashpot Penalty::law_of(std::uint16_t material, std::uint16_t other, Real inverse_mass, Real mobility,
                              Real radius) const {
  constexpr Real two_pi = Real(6.283185307179586476925L);
  const double ratio = ratios_[material * laws.materials + other];
  const auto damping = [&](Real stiffness, Real inverse) {
    return static_cast<Real>(2 * ratio) * square_root(stiffness / inverse);
  };
  SpringDashpot law;
  law.stiffness = settings.stiffness;
  law.damping = damping(law.stiffness, inverse_mass);
  law.friction = laws.of(material, other).friction;
  law.cohesion = two_pi * laws.of(material, other).cohesion * radius;
  if (law.friction == 0) return law;
  law.slide_stiffness = settings.slide_stiffness;
  law.slide_damping = damping(law.slide_stiffness, inverse_mass + mobility);
  return law;
}

Penalty::Bound Penalty::stiffest_pair() const {
  if (bodies.count == 0 || (walls.empty() && bodies.per_copy < 2)) return {};
  double first = 0, second = 0;  // of the two bodies with the largest
  double ratio = 0;              // of materials that meet
  for (std::size_t slot = 0; slot < bodies.count; ++slot) {
    const double spring = static_cast<double>(stiffness_per_mass(slot));
    if (spring > first) {
      second = first, first = spring;
    } else if (spring > second) {
      second = spring;
    }
    for (std::size_t m = 0; m < laws.materials; ++m) {
      ratio = std::max(ratio, ratios_[bodies.material[slot] * laws.materials + m]);
    }
  }
  const double spring = bodies.per_copy < 2 ? first : first + second;
  return {spring, 2 * ratio * __builtin_sqrt(spring)};  // c / m = 2 b sqrt(k / m), m the effective mass
}

/// Searches for neighbours anew if a body or wall may use up its share of the skin in a step of length h.
void Penalty::keep_list(double time, Real h, Workers& workers) {
  Real wall_speed = 0;
  for (const Wall& wall : walls) wall_speed = std::max(wall_speed, static_cast<Real>(wall.motion.top_speed()));
  const auto look_ahead = [&](Real wall_way) {
    for_blocks(workers, [&](std::size_t first, std::size_t last, Part&) {
      for (std::size_t i = first; i < last; ++i) {
        // Twice: it may gain speed. What goes farther than that is counted: no list is wide enough for it. Steps that
        // can be taken back are, if they take a body farther than its radius.
        const Real far = returns ? bodies.radius[i] / 2 : h * length(bodies.velocity.at(i));
        ahead_[i] = (far - far == 0 ? std::min(2 * far, 2 * bodies.radius[i]) : Real(0)) + wall_way;
      }
    });
  };
  look_ahead(wall_speed * (static_cast<Real>(time - listed_at_) + h));
  if (!was_restored_ && list_.holds(bodies.position, period, ahead_, workers)) return;
  look_ahead(wall_speed * h);
  list(time, workers);
}

void Penalty::list(double time, Workers& workers) {
  if (!was_restored_) remember(known_);
  counters_.lists += !was_restored_;
  was_restored_ = false;
  listed_at_ = time;
  for (std::size_t i = 0; i < bodies.count; ++i) allowance_[i] = settings.margin * bodies.radius[i] + ahead_[i];
  list_.build(bodies.position, bodies.radius, allowance_, bodies.per_copy, period, workers);
  list_walls(time);
  pairs_.resize(list_.other.size(), bodies.spins);
  walls_.resize(wall_.size(), bodies.spins);
  set_laws();
  if (bodies.spins) recall();
}

void Penalty::set_laws() {
  for (std::size_t a = 0; a < bodies.count; ++a) {
    const std::uint16_t material = bodies.material[a];
    const Real inverse_mass = bodies.inverse_mass[a], mobility = bodies.mobility[a];
    for (std::uint32_t i = list_.first[a]; i < list_.first[a + 1]; ++i) {
      const std::uint32_t b = list_.other[i];
      const Real r = bodies.radius[a], other = bodies.radius[b];
      pairs_.laws[i] = law_of(material, bodies.material[b], inverse_mass + bodies.inverse_mass[b],
                              mobility + bodies.mobility[b], r * other / (r + other));
    }
    for (std::uint32_t i = first_wall_[a]; i < first_wall_[a + 1]; ++i) {
      walls_.laws[i] = law_of(walls[wall_[i]].material, material, inverse_mass, mobility, bodies.radius[a]);
    }
  }
}

void Penalty::list_walls(double time) {
  set_moments(time);
  first_wall_.assign(1, 0);
  wall_.clear();
  for (std::size_t slot = 0; slot < bodies.count; ++slot) {
    for (std::uint32_t w = 0; w < walls.size(); ++w) {
      const Vector3<Real> x = bodies.position.at(slot) - moments_[w].offset;
      if (walls[w].distance(x, bodies.radius[slot]) <= allowance_[slot]) wall_.push_back(w);
    }
    first_wall_.push_back(static_cast<std::uint32_t>(wall_.size()));
  }
}

/// Keeps what contacts remember: those of the list, or what was restored and no list has yet.
void Penalty::remember(Memories& all) const {
  all.pairs.clear(), all.walls.clear();
  if (pairs_.slid.empty() && walls_.slid.empty()) return;
  const auto any = [](const Vector3<Real>& slid) { return dot(slid, slid) != 0; };
  for (std::uint32_t slot = 0; slot < bodies.count; ++slot) {
    for (std::uint32_t i = list_.first[slot]; i < list_.first[slot + 1]; ++i) {
      if (any(pairs_.slid[i])) all.pairs.push_back({slot, list_.other[i], pairs_.slid[i]});
    }
    for (std::uint32_t i = first_wall_[slot]; i < first_wall_[slot + 1]; ++i) {
      if (any(walls_.slid[i])) all.walls.push_back({wall_[i], slot, walls_.slid[i]});
    }
  }
}

void Penalty::recall() {
  for (const Memory& memory : known_.pairs) {
    const auto begin = list_.other.begin() + list_.first[memory.a],
               end = list_.other.begin() + list_.first[memory.a + 1];
    const auto found = std::lower_bound(begin, end, memory.b);
    if (found != end && *found == memory.b) {
      pairs_.slid[static_cast<std::size_t>(found - list_.other.begin())] = memory.slid;
    }
  }
  for (const Memory& memory : known_.walls) {
    for (std::uint32_t i = first_wall_[memory.b]; i < first_wall_[memory.b + 1]; ++i) {
      if (wall_[i] == memory.a) walls_.slid[i] = memory.slid;
    }
  }
}

void Penalty::Contacts::resize(std::size_t n, bool slides) {
  laws.resize(n);
  touches.assign(n, 0);
  forces.resize(n);
  if (!slides) return;
  twists.resize(n);
  slid.assign(n, {});
  rates.clear();
}

std::size_t Penalty::Contacts::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  return of(laws) + of(touches) + of(forces) + of(twists) + of(slid) + of(rates);
}

std::size_t Penalty::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  return bodies.bytes() + force.bytes() + moment.bytes() + list_.bytes() + pairs_.bytes() + walls_.bytes() +
         of(first_wall_) + of(wall_) + of(allowance_) + of(ahead_) + of(loads_) + of(parts_);
}

}  // namespace ballpark::BALLPARK_PRECISION
