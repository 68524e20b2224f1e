// What an effect between bodies tells of itself. It sees its bodies by slot, the rank of a body's id among them, so
// that no order of rows reaches a bit, and adds the force on each; bodies' own effects act after it.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/function_ref.h"
#include "engine/core/workers.h"
#include "engine/effects/effect_info.h"
#include "engine/effects/pair_kernels.h"
#include "engine/kernels/dual.h"
#include "engine/kernels/period.h"

namespace ballpark::BALLPARK_PRECISION {

/// Copies [first, last) of a scene.
struct CopyRange {
  std::size_t first = 0, last = 1;
};

/// Bodies in columns by slot: those of copy c are [c count, (c + 1) count). These are some of the copies.
struct PairBodies {
  std::size_t count = 0;  ///< of one copy
  CopyRange copies;
  std::size_t woven = 0;  ///< copies [0, woven) stand body by body, see pair_kernels.h
  std::size_t end = 0;    ///< of the slots that may be touched: those of these copies, and padding if there is some
  const Real* mass = nullptr;
  const Real* position[3] = {};
  const Real* velocity[3] = {};  ///< null if the effect does not read it
  Real* force[3] = {};

  Vector3<Real> position_of(std::size_t slot) const {
    return {position[0][slot], position[1][slot], position[2][slot]};
  }
  Vector3<Real> velocity_of(std::size_t slot) const {
    return {velocity[0][slot], velocity[1][slot], velocity[2][slot]};
  }
};

/// act(slot) for slots [first, last), in tasks.
template <class Act>
void for_slots(std::size_t first, std::size_t last, std::size_t task_length, Workers& workers, Act act) {
  const std::size_t tasks = (last - first + task_length - 1) / task_length;
  const auto task = [&](std::size_t t) {
    const std::size_t begin = first + t * task_length;
    for (std::size_t i = begin; i < std::min(begin + task_length, last); ++i) act(i);
  };
  workers.for_each(tasks, task, tasks < 2 ? 1 : workers.threads());
}

/// Who may be within reach of whom, wherever the bodies go.
class Neighbours {
 public:
  virtual ~Neighbours() = default;
  /// Before anything is asked of these copies: looks again if a body may have come within reach.
  virtual void follow(const PairBodies& bodies, Workers& workers) = 0;
  /// Slots within the copy of at least all bodies within reach of one, in their order, without itself.
  virtual std::span<const std::uint32_t> of(std::size_t copy, std::size_t slot) const = 0;
  virtual bool searches() const = 0;  ///< or takes all for neighbours?
};

/// Memory and arithmetic of one evaluation, for explain.
struct PairCost {
  double bytes = 0, flops = 0;  ///< for one body
};

/// Two bodies of a copy that act on each other, by slot.
struct Link {
  std::uint32_t a, b, index;  ///< in links()
};
/// A force by what parts two bodies: with derivatives by r, then by v, both from a to b.
using LinkForce = Vector3<Dual<6>>;

class PairEffect {
 public:
  virtual ~PairEffect() = default;
  /// Adds the force on every body. Other threads may do so for other copies.
  virtual void add_forces(const PairBodies& bodies, Workers& workers) = 0;
  /// Potential energy of these copies together [J].
  virtual double energy(const PairBodies& bodies, Workers& workers) = 0;
  /// Bound on its stiffness and damping per mass [1/s^2, 1/s]: zero, it sets no limit to the step.
  virtual Stiffness per_mass() const { return {}; }
  virtual PairCost cost() const = 0;
  virtual bool searches() const { return false; }  ///< does it find near bodies in a grid?

  // For implicit integrators: the same forces, pair by pair.
  virtual std::vector<Link> links() const = 0;  ///< of one copy
  /// Force on b of a link; that on a is its negative.
  virtual LinkForce force_of(std::size_t copy, const Link& link, const Vector3<Real>& r,
                             const Vector3<Real>& v) const = 0;
};

/// Every body with each behind it, in that order.
inline std::vector<Link> all_links(std::size_t count) {
  std::vector<Link> all;
  for (std::uint32_t a = 0; a < count; ++a) {
    for (std::uint32_t b = a + 1; b < count; ++b) all.push_back({a, b, static_cast<std::uint32_t>(all.size())});
  }
  return all;
}

/// Variables of LinkForce, from the first on.
inline LinkForce as_variables(const Vector3<Real>& a, int first) {
  return {Dual<6>::variable(a.x, first), Dual<6>::variable(a.y, first + 1), Dual<6>::variable(a.z, first + 2)};
}

/// A scene's effect as its own code reads it. Parameters are checked and defaults filled in.
struct PairInput {
  const EffectInput& effect;
  const PairBodies& bodies;  ///< all, at the start
  FunctionRef<std::size_t(std::size_t id)> slot_of;
  PairKernels kernels;
  Period period;  ///< of the scene's space
  FunctionRef<std::unique_ptr<Neighbours>(Real reach)> neighbours;
  Workers& workers;
};

struct PairEffectInfo {
  EffectDescription description;
  std::unique_ptr<PairEffect> (*make)(const PairInput&) = nullptr;
  bool weaves = false;  ///< can it go through woven copies?
};

template <class E>
PairEffectInfo pair_effect_info() {
  return {E::description(),
          [](const PairInput& input) -> std::unique_ptr<PairEffect> { return std::make_unique<E>(input); }, E::weaves};
}

}  // namespace ballpark::BALLPARK_PRECISION
