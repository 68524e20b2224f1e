// What an effect between bodies tells of itself. It sees its bodies by slot, the rank of a body's id among them, so
// that no order of rows reaches a bit, and writes the force on each; the world sums it before bodies' own effects act.
#pragma once

#include <memory>

#include "engine/core/aligned_array.h"
#include "engine/core/function_ref.h"
#include "engine/core/workers.h"
#include "engine/effects/effect_info.h"
#include "engine/effects/pair_kernels.h"
#include "engine/kernels/period.h"

namespace ballpark::BALLPARK_PRECISION {

/// Slots of copy c: [c stride, c stride + count), then padding of no mass.
struct PairBodies {
  std::size_t count = 0;   ///< of one copy
  std::size_t stride = 0;  ///< from one copy to the next: a multiple of any vector
  std::size_t copies = 1;
  AlignedArray<Real> mass, position[3], velocity[3];
  AlignedArray<Real> force[3];

  void resize();
  Vector3<Real> position_of(std::size_t slot) const { return at(position, slot); }
  Vector3<Real> velocity_of(std::size_t slot) const { return at(velocity, slot); }

 private:
  static Vector3<Real> at(const AlignedArray<Real> (&c)[3], std::size_t i) {
    return {c[0].data()[i], c[1].data()[i], c[2].data()[i]};
  }
};

/// Memory and arithmetic of one evaluation, for explain.
struct PairCost {
  double bytes = 0, flops = 0;  ///< for one body
};

class PairEffect {
 public:
  virtual ~PairEffect() = default;
  /// Writes the force on every slot.
  virtual void find_forces(PairBodies& bodies, Workers& workers) = 0;
  /// Potential energy of all copies together [J].
  virtual double energy(const PairBodies& bodies, Workers& workers) = 0;
  /// Bound on its stiffness and damping per mass [1/s^2, 1/s]: zero, it sets no limit to the step.
  virtual Stiffness per_mass() const { return {}; }
  virtual PairCost cost() const = 0;
};

/// A scene's effect as its own code reads it. Parameters are checked and defaults filled in.
struct PairInput {
  const EffectInput& effect;
  const PairBodies& bodies;  ///< at the start
  FunctionRef<std::size_t(std::size_t id)> slot_of;
  PairKernels kernels;
  Period period;  ///< of the scene's space
};

struct PairEffectInfo {
  EffectDescription description;
  std::unique_ptr<PairEffect> (*make)(const PairInput&) = nullptr;
};

template <class E>
PairEffectInfo pair_effect_info() {
  return {E::description(),
          [](const PairInput& input) -> std::unique_ptr<PairEffect> { return std::make_unique<E>(input); }};
}

}  // namespace ballpark::BALLPARK_PRECISION
