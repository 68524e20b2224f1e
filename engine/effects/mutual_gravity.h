// Attraction of all bodies by each other: F_i = sum_j G m_i m_j r_ij / (r_ij^2 + s^2)^(3/2), r_ij from i to j.
// Every pair is looked at from both sides: lanes over bodies, each summing over the others in the order of ids.
#pragma once

#include "engine/effects/pair_kernels.h"
#include "engine/kernels/vector3.h"

#ifndef BALLPARK_TARGET
#include "engine/effects/pair_effect.h"
#endif

namespace ballpark::BALLPARK_PRECISION {

/// Some bodies of one copy, one in each lane; the lanes before and behind them are others'.
template <class V>
struct AttractedLanes {
  std::size_t slot;  ///< of the first lane
  V first, last;     ///< lanes of these bodies: [first, last)

  BALLPARK_INLINE V read(const Real* column) const { return load<V>(column + slot); }
  /// Others keep their value.
  BALLPARK_INLINE void add(Real* column, const V& value) const {
    const V zero = V(Real(0)), numbers = lane_numbers<V>();
    store(column + slot, read(column) + select(first > numbers, zero, select(last > numbers, value, zero)));
  }
};

/// Calls act(lanes, first body of their copy) for all of bodies [first, last) of each copy.
template <class V, class Act>
BALLPARK_INLINE void over_lanes(const Attraction& a, std::size_t first, std::size_t last, Act act) {
  for (std::size_t copy = 0; copy < a.copies; ++copy) {
    const std::size_t start = copy * a.count;
    for (std::size_t i = first; i < last; i += lane_count<V>) {
      const std::size_t left = last - i, bodies = left < lane_count<V> ? left : lane_count<V>;
      const std::size_t slot = start + i, latest = a.end - lane_count<V>, at = slot < latest ? slot : latest;
      act(AttractedLanes<V>{at, V(static_cast<Real>(slot - at)), V(static_cast<Real>(slot - at + bodies))}, start);
    }
  }
}

/// Calls term(j, r, r^2 + s^2) for all bodies j of the copy that begins at `start`, r from the lanes to j.
template <class V, class Term>
BALLPARK_INLINE void over_bodies(const Attraction& a, const AttractedLanes<V>& lanes, std::size_t start, Term term) {
  const Vector3<V> x = {lanes.read(a.position[0]), lanes.read(a.position[1]), lanes.read(a.position[2])};
  for (std::size_t j = start; j < start + a.count; ++j) {
    const Vector3<V> r = Vector3<V>{V(a.position[0][j]), V(a.position[1][j]), V(a.position[2][j])} - x;
    term(j, r, dot(r, r) + V(a.softening_squared));
  }
}

template <class V>
static void attract(const Attraction& a, std::size_t first, std::size_t last, Real* const* force) {
  const V zero = V(Real(0));
  over_lanes<V>(a, first, last, [&](const AttractedLanes<V>& lanes, std::size_t start) BALLPARK_INLINE_LAMBDA {
    Vector3<V> sum;
    over_bodies(a, lanes, start, [&](std::size_t j, const Vector3<V>& r, const V& square) BALLPARK_INLINE_LAMBDA {
      // Zero without softening: the body itself, or one at the same place, whose pull has no direction.
      sum += select(square > zero, V(a.mass[j]) / (square * square_root(square)), zero) * r;
    });
    sum = (V(a.strength) * lanes.read(a.mass)) * sum;
    lanes.add(force[0], sum.x);
    lanes.add(force[1], sum.y);
    lanes.add(force[2], sum.z);
  });
}

template <class V>
static void attraction_energy(const Attraction& a, std::size_t first, std::size_t last, Real* energy) {
  const V zero = V(Real(0)), numbers = lane_numbers<V>();
  over_lanes<V>(a, first, last, [&](const AttractedLanes<V>& lanes, std::size_t start) BALLPARK_INLINE_LAMBDA {
    V sum = zero;
    over_bodies(a, lanes, start, [&](std::size_t j, const Vector3<V>&, const V& square) BALLPARK_INLINE_LAMBDA {
      const V term = select(square > zero, V(a.mass[j]) / square_root(square), zero);
      const bool among = j >= lanes.slot && j < lanes.slot + lane_count<V>;
      sum += among ? select(numbers == V(static_cast<Real>(j - lanes.slot)), zero, term) : term;
    });
    lanes.add(energy, V(Real(-0.5)) * (V(a.strength) * lanes.read(a.mass)) * sum);
  });
}

template <class V>
constexpr PairKernels pair_kernels() {
  return {&attract<V>, &attraction_energy<V>};
}

#ifndef BALLPARK_TARGET
class MutualGravity : public PairEffect {
 public:
  explicit MutualGravity(const PairInput& input);
  void add_forces(const PairBodies& bodies, Workers& workers) override;
  double energy(const PairBodies& bodies, Workers& workers) override;
  PairCost cost() const override;
  std::vector<Link> links() const override;
  LinkForce force_of(std::size_t copy, const Link& link, const Vector3<Real>& r, const Vector3<Real>& v) const override;
  static EffectDescription description();

 private:
  /// Calls act(attraction of some copies, the slot it begins at, the first and the last of their bodies it is for).
  template <class Act>
  void for_tasks(const PairBodies& bodies, Workers& workers, Act act) const;

  Real strength_, softening_;
  PairKernels kernels_;
  std::size_t count_;
  std::vector<Real> masses_;  ///< of one copy
};
#endif

}  // namespace ballpark::BALLPARK_PRECISION
