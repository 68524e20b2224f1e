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
  for (std::size_t g = 0; g < world_.groups_.size(); ++g) open_group(g);
}

/// Of a group that bodies enter or leave: who is there at the start.
void Builder::open_group(std::size_t g) {
  Group& group = world_.groups_[g];
  std::string why;
  const StepEffect* source = nullptr;
  for (const World::BetweenSteps& between : world_.between_steps_) {
    if (!between.info->opens() || !between.acts_on(g)) continue;
    if (why.find(between.name()) == std::string::npos) why += (why.empty() ? "" : ", ") + std::string(between.name());
    if (between.info->enters()) source = between.effect.get();
  }
  if (why.empty() || group.live == 0) return;
  Column& column = world_.columns_.add({"present", "1", 1, Role::kept, why}, group.first_row, padded(group.live));
  group.presence.begin(group, world_.columns_, column.at(0, group.first_row), source != nullptr);
  for (std::size_t row = 0; source && row < group.live; ++row) {
    if (source->entry(group.copies.index_of(row)) > 0) group.presence.wait(row);
  }
}

bool World::BetweenSteps::acts_on(std::size_t group) const {
  return std::find(groups.begin(), groups.end(), group) != groups.end();
}

void World::act_between_steps() {
  for (std::size_t i = 0; i < between_steps_.size(); ++i) {
    const BetweenSteps& between = between_steps_[i];
    const EndedStep step{step_, counters_.steps + 1};
    if (!books()) {
      act_between(between, step);
      continue;
    }
    const double before = read_energy().energy();
    act_between(between, step);
    book_->between_steps[i].add(read_energy().energy() - before);
  }
}

void World::act_between(const BetweenSteps& between, const EndedStep& step) {
  std::vector<Crossings> crossings(between.info->opens() ? whole_.blocks.size() : 0);
  pass(whole_, between.name(), [&](const Group& group, const Block& block) {
    if (!between.acts_on(block.group)) return;
    const StateColumns& state = group.kernel.state;
    Presence& presence = groups_[block.group].presence;
    Crossings* crossed =
        crossings.empty() ? nullptr : &crossings[static_cast<std::size_t>(&block - whole_.blocks.data())];
    const auto name_of = [&](std::size_t row) {
      const std::size_t index = group.copies.index_of(row);
      return BodyName{group.copies.copy_of(row), group.id_offset + index, index};
    };
    const auto leave = [&](std::size_t row) { presence.leave(row), ++crossed->left; };
    const auto enter = [&](std::size_t row, double flight) { presence.enter(row, flight), ++crossed->entered; };
    between.effect->act(
        {block.first, block.last, state.position, state.velocity, group.kernel.constants.mass, name_of, leave, enter},
        step);
  });
  for (const Crossings& block : crossings) {
    counters_.entered += block.entered;
    counters_.left += block.left;
  }
  if (between.info->enters()) report_full(between, step);
}

/// A source that has run out of bodies.
void World::report_full(const BetweenSteps& between, const EndedStep& step) {
  if (status_.code != Status::Code::ok) return;
  for (const std::size_t g : between.groups) {
    const std::size_t room = groups_[g].copies.per_copy;
    if (between.effect->entries(step.end()) <= static_cast<double>(room)) continue;
    status_ = {
        Status::Code::full,
        "the emitter of group " + groups_[g].name + " has no body left: all " + std::to_string(room) + " have entered",
        groups_[g].id_offset + room - 1, step.number, step.end()};
    return;
  }
}

void World::explain_between_steps(std::vector<PassReport>& passes) const {
  for (const BetweenSteps& between : between_steps_) {
    for (const std::size_t g : between.groups) {
      if (groups_[g].live == 0) continue;
      const std::vector<std::string>& writes = between.info->description.exerts;
      std::vector<std::string> reads = between.info->description.reads;
      reads.insert(reads.end(), writes.begin(), writes.end());
      passes.push_back({between.name(), groups_[g].name, std::move(reads), writes,
                        static_cast<double>(between.info->values) * sizeof(Real),
                        static_cast<double>(between.info->description.flops), 1, "between steps"});
    }
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
