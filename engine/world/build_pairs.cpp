// Effects between bodies: slots of their bodies and what they make of their parameters.
#include <algorithm>
#include <tuple>

#include "engine/world/build.h"
#include "engine/world/pair_neighbours.h"

namespace ballpark::BALLPARK_PRECISION {

const Effect* pair_effect_of(const Scene& scene) {
  for (const Effect& effect : scene.effects) {
    if (pair_effect_index(effect.kind) >= 0) return &effect;
  }
  return nullptr;
}

bool has_pair_effect(const Scene& scene, const BodyGroup& group) {
  return std::any_of(scene.effects.begin(), scene.effects.end(), [&](const Effect& effect) {
    return pair_effect_index(effect.kind) >= 0 && acts_on(effect, group);
  });
}

/// Few bodies that only others of their copy act on, beside what is local: lanes can run over copies.
void Builder::weave() {
  if (world_.fused_ || world_.groups_.size() != 1 || !scene_.contact.kind.empty()) return;
  if (world_.row_->family == Family::implicit_runge_kutta) return;
  for (const Effect& effect : scene_.effects) {
    const int pair = pair_effect_index(effect.kind);
    if (pair >= 0 && !pair_effects()[static_cast<std::size_t>(pair)].weaves) return;
  }
  CopyRows& copies = world_.groups_[0].copies;
  if (!pair_effect_of(scene_) || copies.per_copy > most_woven) return;
  copies.woven = world_.copies_ / CopyRows::width * CopyRows::width;
  if (copies.woven > 0) world_.path_reason_ += "; " + std::to_string(copies.woven) + " copies side by side in lanes";
}

/// In an order that does not depend on the scene's: by kind, then by parameters.
void Builder::add_pair_systems() {
  std::vector<Effect> effects;
  for (const Effect& effect : scene_.effects) {
    if (pair_effect_index(effect.kind) >= 0) effects.push_back(effect);
  }
  std::stable_sort(effects.begin(), effects.end(), [](const Effect& a, const Effect& b) {
    const auto key = [](const Effect& effect) {
      std::vector<std::string> groups = effect.groups;
      std::sort(groups.begin(), groups.end());
      return std::tuple(pair_effect_index(effect.kind), numbers_of(effect), groups);
    };
    return key(a) < key(b);
  });
  for (const Effect& effect : effects) add_pair_system(effect);
}

void Builder::add_pair_system(const Effect& effect) {
  std::vector<std::size_t> chosen;
  std::size_t count = 0;
  for (std::size_t g = 0; g < world_.groups_.size(); ++g) {
    const Group& group = world_.groups_[g];
    if (group.copies.per_copy == 0 || !acts_on(effect, scene_.bodies[group.scene_index])) continue;
    chosen.push_back(g);
    count += group.copies.per_copy;
  }
  if (count == 0) return;
  const PairEffectInfo& info = pair_effects()[static_cast<std::size_t>(pair_effect_index(effect.kind))];
  PairSystem system(info, world_.groups_, chosen, world_.copies_);
  const PairBodies bodies = system.in_state(world_.groups_, world_.workers_);
  const auto slot_of = [&](std::size_t id) {
    for (const SlotRange& range : system.ranges) {  // those of copy 0 come first
      const Group& group = world_.groups_[range.group];
      const std::size_t first = group.id_offset + range.first_row;
      if (id >= first && id < first + range.count) return range.first_slot + (id - first);
    }
    return count;  // refused by check()
  };
  const auto parameters = complete_parameters(effect, info.description);
  const EffectInput input{parameters, 0, {}};
  Period period;
  for (const Boundary& boundary : scene_.boundaries) {
    for (int c = 0; c < 3 && boundary.shape == "periodic"; ++c) {
      period.length[c] = static_cast<Real>(boundary.size[c]);
    }
  }
  const auto neighbours = [&](Real reach) -> std::unique_ptr<Neighbours> {
    return std::make_unique<PairNeighbours>(reach, count, world_.copies_, period);
  };
  system.effect = info.make({input, bodies, slot_of, world_.kernels_->pair, period, neighbours, world_.workers_});
  world_.pair_systems_.push_back(std::move(system));
}

}  // namespace ballpark::BALLPARK_PRECISION
