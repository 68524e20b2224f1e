// What [stress] asks for, checked with the rest of the file; and the names of what it measures.
#pragma once

#include <string>
#include <vector>

#include "ballpark/scenes.h"

namespace ballpark::scenes {

/// A comparison, and the quantity stress.MEASURE that comes of it.
struct ComparisonInfo {
  std::string name, measure, doc;
};
const std::vector<ComparisonInfo>& comparisons();

/// "run.integrator=rk4" in two. Nothing if it is not of that form.
std::optional<Override> override_of(const std::string& text);

std::vector<Problem> check_stress(const SceneFile& file);

}  // namespace ballpark::scenes
