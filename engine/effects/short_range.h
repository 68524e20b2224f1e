// The driver of forces between bodies that end at a cut-off. What acts is a struct P:
//   P(EffectInput)      its parameters
//   cutoff              [m]
//   push(r^2)           -U'(r)/r: the force on b is push r, r from a to b; a template on the value type, r > 0
//   energy(r^2)         U(r)
//   flops               of a pair, its distance among them
//   description()       catalogue entry, with a parameter "cutoff"
// Each pair is looked at from both sides, and every body sums what its neighbours do in the order of ids. Pairs beyond
// the cut-off add nothing: which of them are listed as neighbours changes no bit.
#pragma once

#include <cmath>

#include "engine/effects/pair_effect.h"

namespace ballpark::BALLPARK_PRECISION {

inline constexpr double least_reach = 1e-15;  ///< its square is a number in every precision [m]

inline ParameterInfo cutoff_parameter(const char* doc) {
  return {.name = "cutoff", .unit = "m", .fallback = {}, .minimum = least_reach, .doc = doc};
}

template <class P>
class ShortRange : public PairEffect {
 public:
  static constexpr bool weaves = false;

  explicit ShortRange(const PairInput& input)
      : pair_(input.effect),
        square_(pair_.cutoff * pair_.cutoff),
        period_(input.period),
        count_(input.bodies.count),
        neighbours_(input.neighbours(pair_.cutoff)) {
    measure(input.bodies, input.workers);
  }

  void add_forces(const PairBodies& bodies, Workers& workers) override {
    over_bodies(bodies, workers, [&](std::size_t i) {
      Vector3<Real> sum;
      over_pairs(bodies, i, apart, [&](const Batch& near) {
        Real push[batch_length];
        for (std::size_t k = 0; k < near.count; ++k) push[k] = pair_.push(near.square[k]);
        for (std::size_t k = 0; k < near.count; ++k) sum -= push[k] * Vector3<Real>{near.x[k], near.y[k], near.z[k]};
      });
      bodies.force[0][i] += sum.x, bodies.force[1][i] += sum.y, bodies.force[2][i] += sum.z;
    });
  }

  double energy(const PairBodies& bodies, Workers& workers) override {
    std::vector<Real> energies(bodies.end);
    over_bodies(bodies, workers, [&](std::size_t i) {
      over_pairs(bodies, i, anywhere, [&](const Batch& near) {
        for (std::size_t k = 0; k < near.count; ++k) {
          if (near.slot[k] > i) energies[i] += pair_.energy(near.square[k]);
        }
      });
    });
    double sum = 0;
    for (const Real energy : energies) sum += static_cast<double>(energy);
    return sum;
  }

  Stiffness per_mass() const override { return per_mass_; }
  PairCost cost() const override { return cost_; }
  bool searches() const override { return neighbours_->searches(); }
  std::vector<Link> links() const override { return all_links(count_); }

  LinkForce force_of(std::size_t, const Link&, const Vector3<Real>& a_to_b, const Vector3<Real>&) const override {
    const LinkForce r = as_variables(nearest_image(a_to_b, period_), 0);
    const Dual<6> square = dot(r, r);
    if (!(square.value > 0 && square.value < square_)) return {};
    return pair_.push(square) * r;
  }

  static EffectDescription description() { return P::description(); }

 private:
  /// act(slot) for all bodies, once their neighbours are known.
  template <class Act>
  void over_bodies(const PairBodies& bodies, Workers& workers, Act act) {
    constexpr std::size_t task_length = 128;
    neighbours_->follow(bodies, workers);
    for_slots(bodies.copies.first * count_, bodies.copies.last * count_, task_length, workers, act);
  }

  /// Bodies within the cut-off of another, r from that one to them, side by side for lanes.
  static constexpr std::size_t batch_length = 64;
  struct Batch {
    std::size_t count;
    Real x[batch_length], y[batch_length], z[batch_length], square[batch_length];
    std::size_t slot[batch_length];
  };
  /// r^2 of a pair is more: two bodies at one place push each other in no direction, but have an energy.
  static constexpr Real apart = 0, anywhere = -1;

  /// act(batch) for all those within the cut-off of body a, in their order. No branch to mispredict.
  template <class Act>
  void over_pairs(const PairBodies& bodies, std::size_t a, Real more_than, Act act) const {
    const std::size_t copy = a / count_, start = copy * count_;
    const Vector3<Real> x = bodies.position_of(a);
    const std::span<const std::uint32_t> others = neighbours_->of(copy, a - start);
    Batch near;
    for (std::size_t first = 0; first < others.size(); first += batch_length) {
      const std::size_t end = std::min(first + batch_length, others.size());
      near.count = 0;
      for (std::size_t k = first; k < end; ++k) {
        const std::size_t at = near.count, b = near.slot[at] = start + others[k];
        const Vector3<Real> r = nearest_image(bodies.position_of(b) - x, period_);
        near.x[at] = r.x, near.y[at] = r.y, near.z[at] = r.z;
        const Real square = near.square[at] = dot(r, r);
        near.count += (square < square_) & (square > more_than);
      }
      act(near);
    }
  }

  /// Largest |eigenvalue| of -dF/dr: along r it is U'', across it U'/r. Where forces are beyond numbers, so is that.
  double stiffness(Real square) const {
    const Dual<1> push = pair_.push(Dual<1>::variable(square, 0));
    const double across = std::abs(static_cast<double>(push.value));
    const double along = std::abs(static_cast<double>(push.value + 2 * square * push.by[0]));
    return along + across < largest ? std::max(along, across) : largest;
  }

  /// Of the bodies at the start: what they cost, and how stiff they are, by Gershgorin's circles as bonds are.
  void measure(const PairBodies& bodies, Workers& workers) {
    std::vector<double> spring(bodies.end);
    std::vector<std::size_t> pairs(bodies.end), listed(bodies.end);
    over_bodies(bodies, workers, [&](std::size_t i) {
      listed[i] = neighbours_->of(i / count_, i % count_).size();
      over_pairs(bodies, i, apart, [&](const Batch& near) {
        pairs[i] += near.count;
        for (std::size_t k = 0; k < near.count; ++k) {
          spring[i] += stiffness(near.square[k]) / static_cast<double>(bodies.mass[i]);
        }
      });
      spring[i] = std::min(spring[i], largest);
    });
    double acting = 0, looked_at = 0;
    for (std::size_t i = 0; i < bodies.end; ++i) {
      acting += static_cast<double>(pairs[i]), looked_at += static_cast<double>(listed[i]);
      if (spring[i] == 0) continue;
      over_pairs(bodies, i, apart, [&](const Batch& near) {
        for (std::size_t k = 0; k < near.count; ++k) {
          per_mass_.spring = std::max(per_mass_.spring, spring[i] + spring[near.slot[k]]);
        }
      });
    }
    constexpr double real = sizeof(Real), of_distance = 8;
    const double all = static_cast<double>(count_ * bodies.copies.last);
    cost_ = {6 * real + sizeof(std::uint32_t) * looked_at / all,
             (P::flops * acting + of_distance * (looked_at - acting)) / all};
  }

  static constexpr double largest = 1e300;

  P pair_;
  Real square_;  ///< of the cut-off
  Period period_;
  std::size_t count_;
  std::unique_ptr<Neighbours> neighbours_;
  Stiffness per_mass_;
  PairCost cost_;
};

}  // namespace ballpark::BALLPARK_PRECISION
