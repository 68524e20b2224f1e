#include "engine/effects/pair_effects.h"

#include "engine/effects/bonds.h"
#include "engine/effects/mutual_gravity.h"

namespace ballpark::BALLPARK_PRECISION {

const std::vector<PairEffectInfo>& pair_effects() {
  static const std::vector<PairEffectInfo> all = {pair_effect_info<MutualGravity>(), pair_effect_info<Bonds>()};
  return all;
}

int pair_effect_index(const std::string& name) {
  for (std::size_t i = 0; i < pair_effects().size(); ++i) {
    if (pair_effects()[i].description.name == name) return static_cast<int>(i);
  }
  return -1;
}

void PairBodies::resize() {
  const std::size_t slots = copies * stride;
  mass = AlignedArray<Real>(slots);
  for (int c = 0; c < 3; ++c) {
    for (AlignedArray<Real>* column : {&position[c], &velocity[c], &force[c]}) *column = AlignedArray<Real>(slots);
  }
}

}  // namespace ballpark::BALLPARK_PRECISION
