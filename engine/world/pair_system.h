// One effect between bodies in a world: state columns to slots, forces back into the sums of the groups.
#pragma once

#include "engine/effects/pair_effects.h"
#include "engine/kernels/body.h"
#include "engine/world/slots.h"

namespace ballpark {
struct Explanation;
}

namespace ballpark::BALLPARK_PRECISION {

class PairSystem {
 public:
  const PairEffectInfo* info = nullptr;
  std::unique_ptr<PairEffect> effect;
  std::vector<SlotRange> ranges;
  PairBodies bodies;

  const char* name() const { return info->description.name.c_str(); }
  bool acts_on(std::size_t group) const;
  /// The state itself, from the state columns.
  void read_state(const std::vector<Group>& groups, Workers& workers);
  /// Adds the forces in the trial state to the sums of the groups.
  void add_forces(const std::vector<Group>& groups, Workers& workers);
  double energy(const std::vector<Group>& groups, Workers& workers);
  void explain(const std::vector<Group>& groups, int calls, Explanation& all) const;

 private:
  template <class Columns>
  void read(const std::vector<Group>& groups, Workers& workers, Columns columns);
};

}  // namespace ballpark::BALLPARK_PRECISION
