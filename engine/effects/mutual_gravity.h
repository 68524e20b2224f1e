// Attraction of all bodies by each other: F_i = sum_j G m_i m_j r_ij / (r_ij^2 + s^2)^(3/2), r_ij from i to j; or, with
// an opening angle, far bodies together (gravity_tree.h). Every pair is looked at from both sides: lanes over bodies,
// each summing over the others in the order of ids. Of woven copies, lanes are over copies and a pair is looked at
// once; both give the same bits.
#pragma once

#include "engine/effects/pair_kernels.h"
#include "engine/kernels/vector3.h"

#ifndef BALLPARK_TARGET
#include "engine/effects/gravity_tree.h"
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

/// 1 / (r^2 + s^2)^(3/2). Zero without softening: the body itself, or one at the same place, whose pull has no
/// direction.
template <class V>
BALLPARK_INLINE V inverse_cube(const V& square) {
  const V zero = V(Real(0));
  return select(square > zero, V(Real(1)) / (square * square_root(square)), zero);
}

template <class V>
static void attract(const Attraction& a, std::size_t first, std::size_t last, Real* const* force) {
  over_lanes<V>(a, first, last, [&](const AttractedLanes<V>& lanes, std::size_t start) BALLPARK_INLINE_LAMBDA {
    Vector3<V> sum;
    over_bodies(a, lanes, start, [&](std::size_t j, const Vector3<V>& r, const V& square) BALLPARK_INLINE_LAMBDA {
      sum += (V(a.mass[j]) * inverse_cube(square)) * r;
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

/// Calls act(slot of the first body, body to body) for each vector of woven copies.
template <class V, class Act>
BALLPARK_INLINE void over_copies(const Attraction& a, Act act) {
  for (std::size_t weave = 0; weave < a.copies; weave += woven_width) {
    for (std::size_t lane = 0; lane < woven_width; lane += lane_count<V>) act(weave * a.count + lane);
  }
}

template <class V>
BALLPARK_INLINE Vector3<V> load_vector(const Real* const (&columns)[3], std::size_t slot) {
  return {load<V>(columns[0] + slot), load<V>(columns[1] + slot), load<V>(columns[2] + slot)};
}

/// A body sums what those before it push back, then what those behind it pull: in the order of ids.
template <class V>
static void attract_woven(const Attraction& a, Real* const* force) {
  over_copies<V>(a, [&](std::size_t start) BALLPARK_INLINE_LAMBDA {
    V sums[3][most_woven];
    for (std::size_t i = 0; i < a.count; ++i) sums[0][i] = sums[1][i] = sums[2][i] = V(Real(0));
    for (std::size_t i = 0; i < a.count; ++i) {
      const std::size_t slot = start + i * woven_width;
      const Vector3<V> x = load_vector<V>(a.position, slot);
      const V mass = load<V>(a.mass + slot);
      Vector3<V> sum = {sums[0][i], sums[1][i], sums[2][i]};
      for (std::size_t j = i + 1; j < a.count; ++j) {
        const std::size_t other = start + j * woven_width;
        const Vector3<V> r = load_vector<V>(a.position, other) - x;
        const V share = inverse_cube(dot(r, r) + V(a.softening_squared));
        sum += (load<V>(a.mass + other) * share) * r;
        const Vector3<V> back = (mass * share) * r;
        sums[0][j] -= back.x;
        sums[1][j] -= back.y;
        sums[2][j] -= back.z;
      }
      sum = (V(a.strength) * mass) * sum;
      store(force[0] + slot, load<V>(force[0] + slot) + sum.x);
      store(force[1] + slot, load<V>(force[1] + slot) + sum.y);
      store(force[2] + slot, load<V>(force[2] + slot) + sum.z);
    }
  });
}

template <class V>
static void woven_attraction_energy(const Attraction& a, Real* energy) {
  const V zero = V(Real(0));
  over_copies<V>(a, [&](std::size_t start) BALLPARK_INLINE_LAMBDA {
    for (std::size_t i = 0; i < a.count; ++i) {
      const std::size_t slot = start + i * woven_width;
      V sum = zero;
      for (std::size_t j = 0; j < a.count; ++j) {
        const std::size_t other = start + j * woven_width;
        const Vector3<V> r = load_vector<V>(a.position, other) - load_vector<V>(a.position, slot);
        const V square = dot(r, r) + V(a.softening_squared);
        if (j != i) sum += select(square > zero, load<V>(a.mass + other) / square_root(square), zero);
      }
      store(energy + slot, load<V>(energy + slot) + V(Real(-0.5)) * (V(a.strength) * load<V>(a.mass + slot)) * sum);
    }
  });
}

/// Calls act(first body, positions) for each vector of bodies.
template <class V, class Act>
BALLPARK_INLINE void over_pulled(const Pull& p, Act act) {
  for (std::size_t i = 0; i < p.bodies; i += lane_count<V>) act(i, load_vector<V>(p.position, i));
}
template <class V>
BALLPARK_INLINE Vector3<V> source_at(const Real* const* columns, std::size_t j) {
  return {V(columns[0][j]), V(columns[1][j]), V(columns[2][j])};
}

/// Second moments S of a cell, r from its centre to a body, R^2 = r^2 + s^2: the potential of its bodies is
/// -M / R - (3 rSr / R^5 - tr S / R^3) / 2 to second order, and they pull by its slope.
template <class V>
struct CellMoments {
  Vector3<V> turned;  ///< S r
  V along, trace;     ///< rSr, tr S

  BALLPARK_INLINE CellMoments(const Real* const* cells, std::size_t j, const Vector3<V>& r) {
    const V xx(cells[4][j]), yy(cells[5][j]), zz(cells[6][j]), xy(cells[7][j]), xz(cells[8][j]), yz(cells[9][j]);
    turned = {xx * r.x + xy * r.y + xz * r.z, xy * r.x + yy * r.y + yz * r.z, xz * r.x + yz * r.y + zz * r.z};
    along = dot(r, turned);
    trace = xx + yy + zz;
  }
};

template <class V>
static void pull(const Pull& p, Real* const* acceleration) {
  const V one = V(Real(1)), softening = V(p.softening_squared);
  over_pulled<V>(p, [&](std::size_t i, const Vector3<V>& x) BALLPARK_INLINE_LAMBDA {
    Vector3<V> sum;
    for (std::size_t j = 0; j < p.point_count; ++j) {
      const Vector3<V> r = source_at<V>(p.points, j) - x;
      sum += (V(p.points[3][j]) * inverse_cube(dot(r, r) + softening)) * r;
    }
    for (std::size_t j = 0; j < p.cell_count; ++j) {
      const Vector3<V> r = x - source_at<V>(p.cells, j);
      const CellMoments<V> s(p.cells, j, r);
      const V inverse = one / square_root(dot(r, r) + softening), square = inverse * inverse, cube = square * inverse;
      const V fifth = cube * square, twice = V(Real(1.5)) * s.trace - V(Real(7.5)) * (s.along * square);
      sum += (V(Real(3)) * fifth) * s.turned;
      sum += (fifth * twice - V(p.cells[3][j]) * cube) * r;
    }
    store(acceleration[0] + i, sum.x);
    store(acceleration[1] + i, sum.y);
    store(acceleration[2] + i, sum.z);
  });
}

/// Of the body itself as well, at a distance of zero: the caller takes that back where there is softening.
template <class V>
static void pull_potential(const Pull& p, Real* potential) {
  const V zero = V(Real(0)), one = V(Real(1)), softening = V(p.softening_squared);
  over_pulled<V>(p, [&](std::size_t i, const Vector3<V>& x) BALLPARK_INLINE_LAMBDA {
    V sum = zero;
    for (std::size_t j = 0; j < p.point_count; ++j) {
      const Vector3<V> r = source_at<V>(p.points, j) - x;
      const V square = dot(r, r) + softening;
      sum -= select(square > zero, V(p.points[3][j]) / square_root(square), zero);
    }
    for (std::size_t j = 0; j < p.cell_count; ++j) {
      const Vector3<V> r = x - source_at<V>(p.cells, j);
      const CellMoments<V> s(p.cells, j, r);
      const V inverse = one / square_root(dot(r, r) + softening), square = inverse * inverse;
      const V shape = V(Real(1.5)) * (s.along * square) - V(Real(0.5)) * s.trace;
      sum -= inverse * (V(p.cells[3][j]) + square * shape);
    }
    store(potential + i, sum);
  });
}

template <class V>
constexpr PairKernels pair_kernels() {
  return {&attract<V>, &attraction_energy<V>, &attract_woven<V>, &woven_attraction_energy<V>,
          &pull<V>,    &pull_potential<V>};
}

#ifndef BALLPARK_TARGET
class MutualGravity : public PairEffect {
 public:
  static constexpr bool weaves = true;
  explicit MutualGravity(const PairInput& input);
  void add_forces(const PairBodies& bodies, Workers& workers) override;
  double energy(const PairBodies& bodies, Workers& workers) override;
  PairCost cost() const override { return cost_; }
  std::vector<Link> links() const override { return all_links(count_); }
  LinkForce force_of(std::size_t copy, const Link& link, const Vector3<Real>& r, const Vector3<Real>& v) const override;
  static EffectDescription description();

 private:
  /// Some copies, from a slot on, and the first and the last of their bodies that a task is for.
  struct Task {
    Attraction of;
    std::size_t start, first, last;
    bool woven;
  };
  Task task_of(const PairBodies& bodies, const CopyRange& range, std::size_t first, std::size_t last,
               std::size_t end) const;
  template <class Act>
  void for_tasks(const PairBodies& bodies, Workers& workers, Act act) const;
  template <class Act>
  void for_groups(const PairBodies& bodies, Workers& workers, Act act);
  void measure(const PairInput& input);

  Real strength_, softening_;
  PairKernels kernels_;
  std::size_t count_;
  std::vector<Real> masses_;        ///< of one copy
  std::vector<GravityTree> trees_;  ///< of each copy; none: all pairs are summed
  PairCost cost_;
};
#endif

}  // namespace ballpark::BALLPARK_PRECISION
