// Any effect of the catalogue, as a scene may have it.
#pragma once

#include "ballpark/catalogue.h"

namespace ballpark::perf {

/// With its default parameters, and small values for those that have none; pairs chain all bodies.
Effect sample_of(const EffectDescription& description, std::size_t bodies);

}  // namespace ballpark::perf
