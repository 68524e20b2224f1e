// One effect between bodies in a world: where it finds its bodies by slot, and where their forces go.
#pragma once

#include "engine/core/aligned_array.h"
#include "engine/effects/pair_effects.h"
#include "engine/world/kernel_table.h"
#include "engine/world/slots.h"

namespace ballpark {
struct Explanation;
}

namespace ballpark::BALLPARK_PRECISION {

class PairSystem {
 public:
  PairSystem(const PairEffectInfo& effect_info, const std::vector<Group>& groups, std::vector<std::size_t> chosen,
             std::size_t copies);

  const PairEffectInfo* info;
  std::unique_ptr<PairEffect> effect;
  std::vector<SlotRange> ranges;

  const char* name() const { return info->description.name.c_str(); }
  bool acts_on(std::size_t group) const;
  /// All bodies in the state itself.
  PairBodies in_state(const std::vector<Group>& groups, Workers& workers);
  /// Adds the forces in the trial state of these copies to the sums of the groups.
  void add_forces(const std::vector<Group>& groups, const CopyRange& range, Workers& workers);
  double energy(const std::vector<Group>& groups, Workers& workers);
  double power(const std::vector<Group>& groups, Workers& workers);  ///< but for what its energy keeps [W]
  void explain(const std::vector<Group>& groups, int calls, Explanation& all) const;
  std::size_t count() const { return count_; }  ///< bodies of a copy
  std::size_t copies() const { return copies_; }

 private:
  PairBodies look(const std::vector<Group>& groups, StateColumns StepGroup::*columns, const CopyRange& range,
                  Workers& workers);
  /// Calls act(range of slots) for all of these copies.
  template <class Act>
  void for_ranges(const CopyRange& range, Workers& workers, Act act) const;

  std::size_t count_ = 0, copies_ = 1;  ///< bodies of a copy
  bool alone_;                          ///< one group has them all: its rows are the slots
  std::size_t woven_ = 0;               ///< copies
  bool reads_velocity_;
  AlignedArray<Real> mass_, position_[3], velocity_[3], force_[3];  ///< by slot; only masses if `alone_`
};

}  // namespace ballpark::BALLPARK_PRECISION
