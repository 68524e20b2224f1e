// What `ballpark::check` is to the scene, for what a scene file asks beside it: its outputs and expectations.
#pragma once

#include <vector>

#include "ballpark/scenes.h"

namespace ballpark::scenes {

std::vector<Problem> check_requests(const SceneFile& file);

}  // namespace ballpark::scenes
