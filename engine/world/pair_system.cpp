#include "engine/world/pair_system.h"

#include <algorithm>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

template <class Act>
void for_ranges(const std::vector<SlotRange>& ranges, Workers& workers, Act act) {
  workers.for_each(
      ranges.size(), [&](std::size_t r) { act(ranges[r]); }, ranges.size() < 4 ? 1 : workers.threads());
}

void copy(const Real* from, const SlotRange& range, const AlignedArray<Real>& to) {
  std::copy_n(from + range.first_row, range.count, to.data() + range.first_slot);
}

}  // namespace

bool PairSystem::acts_on(std::size_t group) const {
  return std::any_of(ranges.begin(), ranges.end(), [&](const SlotRange& range) { return range.group == group; });
}

/// columns(group): the state columns to read.
template <class Columns>
void PairSystem::read(const std::vector<Group>& groups, Workers& workers, Columns columns) {
  for_ranges(ranges, workers, [&](const SlotRange& range) {
    const StateColumns& state = columns(groups[range.group]);
    for (int c = 0; c < 3; ++c) {
      copy(state.position[c], range, bodies.position[c]);
      copy(state.velocity[c], range, bodies.velocity[c]);
    }
  });
}

void PairSystem::read_state(const std::vector<Group>& groups, Workers& workers) {
  read(groups, workers, [](const Group& group) -> const StateColumns& { return group.kernel.state; });
}

void PairSystem::add_forces(const std::vector<Group>& groups, Workers& workers) {
  read(groups, workers, [](const Group& group) -> const StateColumns& { return group.kernel.trial; });
  effect->find_forces(bodies, workers);
  for_ranges(ranges, workers, [&](const SlotRange& range) {
    for (int c = 0; c < 3; ++c) {
      Real* sum = groups[range.group].force_sums[c] + range.first_row;
      const Real* force = bodies.force[c].data() + range.first_slot;
      for (std::size_t i = 0; i < range.count; ++i) sum[i] += force[i];
    }
  });
}

double PairSystem::energy(const std::vector<Group>& groups, Workers& workers) {
  read_state(groups, workers);
  return effect->energy(bodies, workers);
}

void PairSystem::explain(const std::vector<Group>& groups, int calls, Explanation& all) const {
  const PairCost cost = effect->cost();
  constexpr double gathered = 2 * 6 * sizeof(Real), scattered = 3 * 3 * sizeof(Real);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!acts_on(g)) continue;
    all.passes.push_back({name(),
                          groups[g].name,
                          {"trial_position", "trial_velocity", "mass", "force"},
                          {"force"},
                          gathered + scattered + cost.bytes,
                          cost.flops,
                          calls,
                          "forces between bodies, by id"});
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
