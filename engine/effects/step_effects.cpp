#include "engine/effects/absorbing_wall.h"
#include "engine/effects/emitter.h"
#include "engine/effects/outlet.h"
#include "engine/effects/reflecting_wall.h"
#include "engine/effects/thermostat.h"

namespace ballpark::BALLPARK_PRECISION {

const std::vector<StepEffectInfo>& step_effects() {
  static const std::vector<StepEffectInfo> all = {step_effect_info<Emitter>(), step_effect_info<ReflectingWall>(),
                                                  step_effect_info<Thermostat>(), step_effect_info<AbsorbingWall>(),
                                                  step_effect_info<Outlet>()};
  return all;
}

int step_effect_index(const std::string& name) {
  for (std::size_t i = 0; i < step_effects().size(); ++i) {
    if (step_effects()[i].description.name == name) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace ballpark::BALLPARK_PRECISION
