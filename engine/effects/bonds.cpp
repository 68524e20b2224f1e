#include "engine/effects/bonds.h"

#include <algorithm>
#include <tuple>

namespace ballpark::BALLPARK_PRECISION {

namespace {

constexpr std::size_t task_length = 1024;

}  // namespace

Bonds::Bonds(const PairInput& input) : period_(input.period) {
  const auto& pairs = input.effect.pairs("pairs");
  const auto value = [&](const char* name, std::size_t i) {
    const std::vector<double>& list = input.effect.numbers(name);
    return static_cast<Real>(list[list.size() == 1 ? 0 : i]);
  };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::size_t a = input.slot_of(pairs[i][0]), b = input.slot_of(pairs[i][1]);
    Bond bond{static_cast<std::uint32_t>(std::min(a, b)), static_cast<std::uint32_t>(std::max(a, b)),
              value("stiffness", i), value("damping", i), value("rest_length", i)};
    bonds_.push_back(bond);
  }
  const auto key = [](const Bond& b) { return std::tuple(b.a, b.b, b.stiffness, b.damping, b.rest_length); };
  std::sort(bonds_.begin(), bonds_.end(), [&](const Bond& x, const Bond& y) { return key(x) < key(y); });
  list_ends(input.bodies);
  bound_stiffness(input.bodies);
  forces_.resize(bonds_.size() * input.bodies.copies.last);
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const Bond& bond = bonds_[i % bonds_.size()];
    const std::size_t start = i / bonds_.size() * input.bodies.count;
    const bool as_placed = bond.rest_length < 0;
    rest_lengths_.push_back(as_placed ? length(apart(input.bodies, start + bond.a, start + bond.b)) : bond.rest_length);
  }
}

Vector3<Real> Bonds::apart(const PairBodies& bodies, std::size_t a, std::size_t b) const {
  return nearest_image(bodies.position_of(b) - bodies.position_of(a), period_);
}

void Bonds::list_ends(const PairBodies& bodies) {
  first_end_.assign(bodies.count + 1, 0);
  for (const Bond& bond : bonds_) ++first_end_[bond.a + 1], ++first_end_[bond.b + 1];
  for (std::size_t i = 0; i < bodies.count; ++i) first_end_[i + 1] += first_end_[i];
  ends_.resize(2 * bonds_.size());
  std::vector<std::uint32_t> next(first_end_.begin(), first_end_.end() - 1);
  for (std::uint32_t i = 0; i < bonds_.size(); ++i) {
    ends_[next[bonds_[i].a]++] = {i, 1};
    ends_[next[bonds_[i].b]++] = {i, 0};
  }
}

/// Eigenvalues of M^-1 K, K = B^T W B over the bonds, are those of W B M^-1 B^T, whose rows sum to at most d_a / m_a +
/// d_b / m_b, d the stiffness of all bonds of a body (Gershgorin; exact for two bodies).
void Bonds::bound_stiffness(const PairBodies& bodies) {
  std::vector<double> spring(bodies.count), damping(bodies.count);
  for (const Bond& bond : bonds_) {
    for (const std::uint32_t end : {bond.a, bond.b}) {
      const double inverse = 1 / static_cast<double>(bodies.mass[end]);
      spring[end] += static_cast<double>(bond.stiffness) * inverse;
      damping[end] += static_cast<double>(bond.damping) * inverse;
    }
  }
  for (const Bond& bond : bonds_) {
    per_mass_.spring = std::max(per_mass_.spring, spring[bond.a] + spring[bond.b]);
    per_mass_.damping = std::max(per_mass_.damping, damping[bond.a] + damping[bond.b]);
  }
}

template <class V>
Vector3<V> Bonds::force_on_b(std::size_t i, const Vector3<V>& r, const Vector3<V>& v) const {
  const Bond& bond = bonds_[i % bonds_.size()];
  const V distance = length(r), zero = V(Real(0));
  if (!(distance > zero)) return distance == zero ? Vector3<V>{} : r;  // no direction
  const V tension = V(bond.stiffness) * (distance - V(rest_lengths_[i])) + V(bond.damping) * dot(v, r) / distance;
  return (-tension / distance) * r;
}

std::vector<Link> Bonds::links() const {
  std::vector<Link> all;
  for (const Bond& bond : bonds_) all.push_back({bond.a, bond.b, static_cast<std::uint32_t>(all.size())});
  return all;
}

LinkForce Bonds::force_of(std::size_t copy, const Link& link, const Vector3<Real>& r, const Vector3<Real>& v) const {
  return force_on_b(copy * bonds_.size() + link.index, as_variables(nearest_image(r, period_), 0), as_variables(v, 3));
}

void Bonds::add_forces(const PairBodies& bodies, Workers& workers) {
  const std::size_t first = bodies.copies.first, last = bodies.copies.last;
  for_slots(first * bonds_.size(), last * bonds_.size(), task_length, workers, [&](std::size_t i) {
    const Bond& bond = bonds_[i % bonds_.size()];
    const std::size_t start = i / bonds_.size() * bodies.count, a = start + bond.a, b = start + bond.b;
    forces_[i] = force_on_b(i, apart(bodies, a, b), bodies.velocity_of(b) - bodies.velocity_of(a));
  });
  for_slots(first * bodies.count, last * bodies.count, task_length, workers, [&](std::size_t i) {
    const std::size_t copy = i / bodies.count, slot = i % bodies.count;
    Vector3<Real> sum;
    for (std::uint32_t e = first_end_[slot]; e < first_end_[slot + 1]; ++e) {
      const Vector3<Real>& force = forces_[copy * bonds_.size() + ends_[e].bond];
      ends_[e].is_a ? sum -= force : sum += force;
    }
    bodies.force[0][i] += sum.x, bodies.force[1][i] += sum.y, bodies.force[2][i] += sum.z;
  });
}

double Bonds::energy(const PairBodies& bodies, Workers&) {
  double sum = 0;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const Bond& bond = bonds_[i % bonds_.size()];
    const std::size_t start = i / bonds_.size() * bodies.count;
    const Real extension = length(apart(bodies, start + bond.a, start + bond.b)) - rest_lengths_[i];
    sum += static_cast<double>(bond.stiffness / 2 * extension * extension);
  }
  return sum;
}

PairCost Bonds::cost() const {
  const double bodies = static_cast<double>(first_end_.size() - 1), bonds = static_cast<double>(bonds_.size());
  constexpr double real = sizeof(Real), of_bond = 24 + 2 * (12 + 15) * real, of_end = 8 + 3 * real;
  return {3 * real + (of_bond + 2 * of_end) * bonds / bodies, 36 * bonds / bodies};
}

EffectDescription Bonds::description() {
  return {
      .name = "bonds",
      .doc =
          "springs and dampers between bodies from a list, F = -(k (|r| - l) + c v.r/|r|) r/|r|, r and v from a to b",
      .source = "Hooke's law; the damper acts along the spring and keeps angular momentum",
      .parameters = {{.name = "pairs",
                      .kind = ParameterKind::pairs,
                      .unit = "1",
                      .fallback = {},
                      .doc = "the ids [a, b] of each bond's two bodies, counted over one copy of the scene"},
                     {.name = "stiffness",
                      .kind = ParameterKind::numbers,
                      .unit = "N/m",
                      .fallback = {},
                      .minimum = 0,
                      .doc = "k: one, or one for each pair"},
                     {.name = "damping",
                      .kind = ParameterKind::numbers,
                      .unit = "N s/m",
                      .fallback = 0.0,
                      .minimum = 0,
                      .doc = "c: one, or one for each pair"},
                     {.name = "rest_length",
                      .kind = ParameterKind::numbers,
                      .unit = "m",
                      .fallback = -1.0,
                      .doc = "l: one, or one for each pair; negative: the distance at the start"}},
      .reads = {"position", "velocity"},
      .exerts = {"force"},
      .has_energy = true,
      .flops = 36,
      .between_bodies = true};
}

}  // namespace ballpark::BALLPARK_PRECISION
