// Which integrators can run a scene, and scenes made so that an integrator can.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "ballpark/catalogue.h"
#include "ballpark/scene.h"

namespace ballpark::tests {

/// Does build accept this integrator for this scene?
inline bool accepts(Scene scene, const std::string& integrator) {
  scene.run.integrator = integrator;
  const std::vector<Problem> problems = check(scene);
  return std::none_of(problems.begin(), problems.end(), [](const Problem& p) { return p.path == "run.integrator"; });
}

inline std::vector<IntegratorDescription> integrators_for(const Scene& scene) {
  std::vector<IntegratorDescription> list;
  for (const IntegratorDescription& row : integrators()) {
    if (accepts(scene, row.name)) list.push_back(row);
  }
  return list;
}

/// The scene under this integrator, without the effects that it refuses.
inline Scene run_by(Scene scene, const std::string& integrator) {
  scene.run.integrator = integrator;
  std::erase_if(scene.effects, [&](const Effect& effect) {
    Scene alone = scene;
    alone.effects = {effect};
    return !accepts(alone, integrator);
  });
  return scene;
}

}  // namespace ballpark::tests
