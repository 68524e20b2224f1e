// What acts on bodies between steps.
#include <algorithm>
#include <tuple>

#include "engine/world/build.h"

namespace ballpark::BALLPARK_PRECISION {

/// In an order that does not depend on the scene's: by kind, then by parameters.
void Builder::add_step_effects() {
  std::vector<const Effect*> effects;
  for (const Effect& effect : scene_.effects) {
    if (step_effect_index(effect.kind) >= 0) effects.push_back(&effect);
  }
  std::stable_sort(effects.begin(), effects.end(), [](const Effect* a, const Effect* b) {
    const auto key = [](const Effect& effect) {
      return std::tuple(step_effect_index(effect.kind), numbers_of(effect));
    };
    return key(*a) < key(*b);
  });
  for (const Effect* effect : effects) {
    const StepEffectInfo& info = step_effects()[static_cast<std::size_t>(step_effect_index(effect->kind))];
    const auto parameters = complete_parameters(*effect, info.description);
    World::BetweenSteps made{
        &info, info.make({{parameters, 0, {}}, scene_.run.seed, world_.between_steps_.size()}), {}};
    for (std::size_t g = 0; g < world_.groups_.size(); ++g) {
      if (acts_on(*effect, scene_.bodies[world_.groups_[g].scene_index])) made.groups.push_back(g);
    }
    world_.between_steps_.push_back(std::move(made));
  }
}

bool World::BetweenSteps::acts_on(std::size_t group) const {
  return std::find(groups.begin(), groups.end(), group) != groups.end();
}

void World::act_between_steps() {
  for (std::size_t i = 0; i < between_steps_.size(); ++i) {
    const BetweenSteps& between = between_steps_[i];
    const EndedStep step{step_, counters_.steps + 1};
    const auto act = [&] {
      pass(whole_, between.name(), [&](const Group& group, const Block& block) {
        if (!between.acts_on(block.group)) return;
        const auto name_of = [&](std::size_t row) {
          return BodyName{group.copies.copy_of(row), group.id_offset + group.copies.index_of(row)};
        };
        const StateColumns& state = group.kernel.state;
        between.effect->act(
            {block.first, block.last, state.position, state.velocity, group.kernel.constants.mass, name_of}, step);
      });
    };
    if (!books()) {
      act();
      continue;
    }
    const double before = read_energy().energy();
    act();
    book_->between_steps[i].add(read_energy().energy() - before);
  }
}

void World::explain_between_steps(std::vector<PassReport>& passes) const {
  for (const BetweenSteps& between : between_steps_) {
    for (const std::size_t g : between.groups) {
      if (groups_[g].live == 0) continue;
      std::vector<std::string> columns = between.info->description.exerts;
      passes.push_back({between.name(), groups_[g].name, columns, columns,
                        static_cast<double>(between.info->values) * sizeof(Real),
                        static_cast<double>(between.info->description.flops), 1, "between steps"});
    }
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
