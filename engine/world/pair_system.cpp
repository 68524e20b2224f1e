#include "engine/world/pair_system.h"

#include <algorithm>
#include <array>

#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

PairSystem::PairSystem(const PairEffectInfo& effect_info, const std::vector<Group>& groups,
                       std::vector<std::size_t> chosen, std::size_t copies)
    : info(&effect_info), copies_(copies), alone_(chosen.size() == 1) {
  for (const std::size_t g : chosen) count_ += groups[g].copies.per_copy;
  ranges = slot_ranges(groups, std::move(chosen), copies);
  const auto& reads = info->description.reads;
  reads_velocity_ = std::find(reads.begin(), reads.end(), "velocity") != reads.end();
  const std::size_t slots = padded(count_ * copies);
  mass_ = AlignedArray<Real>(slots);
  for (const SlotRange& range : ranges) {  // rows are the slots of woven copies: it is all the same
    const Group& group = groups[range.group];
    for (std::size_t i = 0; i < range.count; ++i) {
      mass_.data()[range.first_slot + i] = group.kernel.constants.mass.at<Real>(range.first_row + i);
    }
    if (alone_) woven_ = group.copies.woven;
  }
  for (int c = 0; !alone_ && c < 3; ++c) {
    position_[c] = AlignedArray<Real>(slots);
    if (reads_velocity_) velocity_[c] = AlignedArray<Real>(slots);
    force_[c] = AlignedArray<Real>(slots);
  }
}

bool PairSystem::acts_on(std::size_t group) const {
  return std::any_of(ranges.begin(), ranges.end(), [&](const SlotRange& range) { return range.group == group; });
}

template <class Act>
void PairSystem::for_ranges(const CopyRange& range, Workers& workers, Act act) const {
  const std::size_t of_copy = ranges.size() / copies_, first = range.first * of_copy;
  const std::size_t count = (range.last - range.first) * of_copy;
  workers.for_each(
      count, [&](std::size_t r) { act(ranges[first + r]); }, count < 4 ? 1 : workers.threads());
}

/// Bodies of several groups are gathered.
PairBodies PairSystem::look(const std::vector<Group>& groups, StateColumns StepGroup::*columns, const CopyRange& range,
                            Workers& workers) {
  PairBodies bodies{.count = count_, .copies = range, .woven = woven_, .end = range.last * count_};
  if (range.last == copies_) bodies.end = padded(bodies.end);
  bodies.mass = mass_.data();
  const auto gather = [](Real* const(&from)[3], const SlotRange& slots, const AlignedArray<Real>(&to)[3]) {
    for (int c = 0; c < 3; ++c) std::copy_n(from[c] + slots.first_row, slots.count, to[c].data() + slots.first_slot);
  };
  if (!alone_) {
    for_ranges(range, workers, [&](const SlotRange& slots) {
      const StateColumns& state = groups[slots.group].kernel.*columns;
      gather(state.position, slots, position_);
      if (reads_velocity_) gather(state.velocity, slots, velocity_);
      for (int c = 0; c < 3; ++c) std::fill_n(force_[c].data() + slots.first_slot, slots.count, Real(0));
    });
  }
  const Group& group = groups[ranges.front().group];
  const StateColumns& state = group.kernel.*columns;
  for (int c = 0; c < 3; ++c) {
    bodies.position[c] = alone_ ? state.position[c] : position_[c].data();
    bodies.velocity[c] = alone_ ? state.velocity[c] : velocity_[c].data();
    bodies.force[c] = alone_ ? group.force_sums[c] : force_[c].data();
  }
  return bodies;
}

PairBodies PairSystem::in_state(const std::vector<Group>& groups, Workers& workers) {
  return look(groups, &StepGroup::state, {0, copies_}, workers);
}

void PairSystem::add_forces(const std::vector<Group>& groups, const CopyRange& range, Workers& workers) {
  effect->add_forces(look(groups, &StepGroup::trial, range, workers), workers);
  if (alone_) return;
  for_ranges(range, workers, [&](const SlotRange& slots) {
    for (int c = 0; c < 3; ++c) {
      Real* sum = groups[slots.group].force_sums[c] + slots.first_row;
      const Real* force = force_[c].data() + slots.first_slot;
      for (std::size_t i = 0; i < slots.count; ++i) sum[i] += force[i];
    }
  });
}

double PairSystem::energy(const std::vector<Group>& groups, Workers& workers) {
  return effect->energy(in_state(groups, workers), workers);
}

double PairSystem::power(const std::vector<Group>& groups, Workers& workers) {
  const bool keeps = info->description.has_energy;
  if (keeps && !reads_velocity_) return 0;
  PairBodies bodies = in_state(groups, workers);
  std::array<AlignedArray<Real>, 3> force;
  AlignedArray<Real> rest(padded(count_ * copies_));
  const auto power_now = [&] {
    for (std::size_t c = 0; c < 3; ++c) {
      force[c] = AlignedArray<Real>(padded(count_ * copies_));
      bodies.force[c] = force[c].data();
    }
    effect->add_forces(bodies, workers);
    double sum = 0;
    for (const SlotRange& range : ranges) {
      const auto& velocity = groups[range.group].kernel.state.velocity;
      for (std::size_t i = 0; i < range.count; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          sum += static_cast<double>(force[c].data()[range.first_slot + i]) *
                 static_cast<double>(velocity[c][range.first_row + i]);
        }
      }
    }
    return sum;
  };
  const double all = power_now();
  if (!keeps) return all;
  for (const Real*& velocity : bodies.velocity) velocity = rest.data();
  return all - power_now();  // what it would do at rest as well comes back
}

void PairSystem::explain(const std::vector<Group>& groups, int calls, Explanation& all) const {
  const PairCost cost = effect->cost();
  const double reads = reads_velocity_ ? 6 : 3, gathered = alone_ ? reads : 2 * reads + 3, scattered = alone_ ? 6 : 9;
  std::vector<std::string> columns{"trial_position", "mass", "force"};
  if (reads_velocity_) columns.insert(columns.begin() + 1, "trial_velocity");
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!acts_on(g)) continue;
    all.passes.push_back({name(),
                          groups[g].name,
                          columns,
                          {"force"},
                          (gathered + scattered) * sizeof(Real) + cost.bytes,
                          cost.flops,
                          calls,
                          "forces between bodies, by id"});
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
