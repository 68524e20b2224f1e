// Attraction of all bodies by each other: F_i = sum_j G m_i m_j r_ij / (r_ij^2 + s^2)^(3/2), r_ij from i to j.
// Every pair is looked at from both sides: lanes over bodies, each summing over the others in the order of ids.
#pragma once

#include "engine/effects/pair_kernels.h"
#include "engine/kernels/vector3.h"

#ifndef BALLPARK_TARGET
#include "engine/effects/pair_effect.h"
#endif

namespace ballpark::BALLPARK_PRECISION {

/// Calls term(j, r, r^2 + s^2) for all bodies j, r from the bodies at x to j.
template <class V, class Term>
BALLPARK_INLINE void over_bodies(const Attraction& a, std::size_t slot, Term term) {
  const Vector3<V> x = {load<V>(a.position[0] + slot), load<V>(a.position[1] + slot), load<V>(a.position[2] + slot)};
  for (std::size_t j = 0; j < a.count; ++j) {
    const Vector3<V> r = Vector3<V>{V(a.position[0][j]), V(a.position[1][j]), V(a.position[2][j])} - x;
    term(j, r, dot(r, r) + V(a.softening_squared));
  }
}

template <class V>
static void attract(const Attraction& a, std::size_t first, std::size_t last, Real* const* force) {
  const V zero = V(Real(0));
  for (std::size_t slot = first; slot < last; slot += lane_count<V>) {
    Vector3<V> sum;
    over_bodies<V>(a, slot, [&](std::size_t j, const Vector3<V>& r, const V& square) BALLPARK_INLINE_LAMBDA {
      // Zero without softening: the body itself, or one at the same place, whose pull has no direction.
      sum += select(square > zero, V(a.mass[j]) / (square * square_root(square)), zero) * r;
    });
    sum = (V(a.strength) * load<V>(a.mass + slot)) * sum;
    store(force[0] + slot, sum.x);
    store(force[1] + slot, sum.y);
    store(force[2] + slot, sum.z);
  }
}

template <class V>
static void attraction_energy(const Attraction& a, std::size_t first, std::size_t last, Real* energy) {
  const V zero = V(Real(0));
  for (std::size_t slot = first; slot < last; slot += lane_count<V>) {
    V sum = zero;
    const V numbers = lane_numbers<V>();
    over_bodies<V>(a, slot, [&](std::size_t j, const Vector3<V>&, const V& square) BALLPARK_INLINE_LAMBDA {
      const V term = select(square > zero, V(a.mass[j]) / square_root(square), zero);
      const bool among = j >= slot && j < slot + lane_count<V>;
      sum += among ? select(numbers == V(static_cast<Real>(j - slot)), zero, term) : term;
    });
    store(energy + slot, V(Real(-0.5)) * (V(a.strength) * load<V>(a.mass + slot)) * sum);
  }
}

template <class V>
constexpr PairKernels pair_kernels() {
  return {&attract<V>, &attraction_energy<V>};
}

#ifndef BALLPARK_TARGET
class MutualGravity : public PairEffect {
 public:
  explicit MutualGravity(const PairInput& input);
  void find_forces(PairBodies& bodies, Workers& workers) override;
  double energy(const PairBodies& bodies, Workers& workers) override;
  PairCost cost() const override;
  static EffectDescription description();

 private:
  /// Calls act(attraction of a copy, first slot of the copy, first and last of a task's slots in it).
  template <class Act>
  void for_tasks(const PairBodies& bodies, Workers& workers, Act act) const;

  Real strength_, softening_;
  PairKernels kernels_;
  std::size_t count_;
};
#endif

}  // namespace ballpark::BALLPARK_PRECISION
