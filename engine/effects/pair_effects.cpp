#include "engine/effects/pair_effects.h"

#include "engine/effects/bonds.h"
#include "engine/effects/lennard_jones.h"
#include "engine/effects/mutual_gravity.h"
#include "engine/effects/soft_repulsion.h"

namespace ballpark::BALLPARK_PRECISION {

const std::vector<PairEffectInfo>& pair_effects() {
  static const std::vector<PairEffectInfo> all = {pair_effect_info<MutualGravity>(), pair_effect_info<Bonds>(),
                                                  pair_effect_info<ShortRange<LennardJones>>(),
                                                  pair_effect_info<ShortRange<SoftRepulsion>>()};
  return all;
}

int pair_effect_index(const std::string& name) {
  for (std::size_t i = 0; i < pair_effects().size(); ++i) {
    if (pair_effects()[i].description.name == name) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace ballpark::BALLPARK_PRECISION
