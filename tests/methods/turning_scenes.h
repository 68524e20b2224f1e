// Bodies that turn, freely or under loads, by one rotation update or another.
#pragma once

#include "tests/methods/rows.h"

namespace ballpark::tests {

inline const Vector3d asymmetric(1, 2, 3), start_spin(1, 0.5, -0.7);

inline Scene by(Scene made, const std::string& rule, const std::string& integrator) {
  made.run.rotation = rule;
  made.run.integrator = integrator;
  return made;
}

/// P-R1, and its orientation at 10 s.
inline Scene tumbling() {
  return scene(rigid_body(asymmetric, start_spin), {}, 10, 0.01);
}

/// A body with three moments that a force off its centre and a torque turn, held by a spring and by friction of the
/// air.
inline Scene loaded(bool drag) {
  BodyGroup group = rigid_body({0.2, 0.3, 0.4}, {1, 2, -1}, {0.6, 0, 0.8, 0});
  group.position = {{1, 0.5, 0.25}};
  group.velocity = {{0.5, -1, 2}};
  const Effect push{"force", {}, {{"force", Vector3d(0.3, 0.1, 0)}, {"offset", Vector3d(0, 0.1, 0.2)}}};
  const Effect twist{"torque", {}, {{"torque", Vector3d(0.1, -0.2, 0.3)}}};
  std::vector<Effect> effects = {gravity(), spring(4), push, twist};
  if (drag) effects.push_back(effect("quadratic_drag", 0.1));
  return scene(group, effects, 2, 1);
}

}  // namespace ballpark::tests
