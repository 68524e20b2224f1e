// The effects between bodies of this build. To add one: write its file beside the others and name it in
// pair_effects.cpp.
#pragma once

#include "engine/effects/pair_effect.h"

namespace ballpark::BALLPARK_PRECISION {

const std::vector<PairEffectInfo>& pair_effects();
/// Position of an effect in pair_effects() by its name; -1 if it is none.
int pair_effect_index(const std::string& name);

}  // namespace ballpark::BALLPARK_PRECISION
