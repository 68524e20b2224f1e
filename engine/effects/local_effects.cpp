#include "engine/effects/local_effects.h"

#include "engine/effects/pair_effects.h"
#include "engine/effects/step_effect.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

template <class... E>
std::vector<EffectInfo> infos(EffectList<E...>) {
  return {effect_info<E>()...};
}

}  // namespace

const std::vector<EffectInfo>& local_effects() {
  static const std::vector<EffectInfo> all = infos(LocalEffects{});
  return all;
}

int local_effect_index(const std::string& name) {
  for (int i = 0; i < LocalEffects::count; ++i) {
    if (local_effects()[static_cast<std::size_t>(i)].description.name == name) return i;
  }
  return -1;
}

std::vector<EffectDescription> describe_effects() {
  std::vector<EffectDescription> all;
  for (const EffectInfo& info : local_effects()) all.push_back(info.description);
  all.push_back(Pivot::description());
  for (const PairEffectInfo& info : pair_effects()) all.push_back(info.description);
  for (const StepEffectInfo& info : step_effects()) all.push_back(info.description);
  return all;
}

}  // namespace ballpark::BALLPARK_PRECISION
