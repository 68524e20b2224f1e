// The kernels of one target, as pointers; a dispatcher picks a table at run time.
#pragma once

#include <limits>

#include "engine/effects/local_effects.h"
#include "engine/effects/pair_kernels.h"
#include "engine/integrators/method.h"
#include "engine/kernels/motion.h"

namespace ballpark::BALLPARK_PRECISION {

/// One group as kernels see it; rows count from the group's first.
struct StepGroup {
  std::size_t live = std::numeric_limits<std::size_t>::max();  ///< rows of bodies; padding follows
  StateColumns state;
  BodyConstants constants;
  LocalForces forces;
  StateColumns trial;            ///< staged path: where forces are evaluated
  Real* trial_spin[3] = {};      ///< staged path with user effects: angular velocity of the trial state
  Real* const* carry = nullptr;  ///< compensated summation: what rounding took from each value of the state
  Real* const* rates = nullptr;  ///< rate i of set p is rates[p * size + i]: of phases, and kept between steps
  StateColumns before;           ///< embedded pairs: the state at the step's start, to return to
};

/// What a pass that moves bodies tells: does every value stay finite, and the largest error over the tolerance,
/// squared.
struct Moved {
  bool finite = true;
  Real over = 0;
};

/// Rows [first, last), first a multiple of any vector; what is left of the last vector is padding.
using FusedStep = Moved(const StepGroup&, const Method&, std::size_t first, std::size_t last);
using Prepare = void(const StepGroup&, const Method&, int phase, std::size_t first, std::size_t last);
using Evaluate = void(const StepGroup&, const Method&, int phase, std::size_t first, std::size_t last);
using Finish = Moved(const StepGroup&, const Method&, std::size_t first, std::size_t last);

/// One family's kernels, by motion.
struct FamilyKernels {
  FusedStep* fused[motion_count];
  Prepare* prepare[motion_count];
  Finish* finish[motion_count];
};
struct StepKernels {
  FamilyKernels families[family_count];
};

struct KernelTable {
  const char* target;
  StepKernels plain_and_compensated[2];
  Evaluate* evaluate[motion_count];
  PairKernels pair;

  const FamilyKernels& family(Family f, bool compensated) const {
    return plain_and_compensated[compensated].families[static_cast<int>(f)];
  }
};

const KernelTable& kernel_table_base();
const KernelTable& kernel_table_v3();
const KernelTable& kernel_table_v4();

}  // namespace ballpark::BALLPARK_PRECISION
