// How to run a scene: nothing here changes what is simulated, and nothing but precision, copies and perturb changes a
// bit.
#pragma once

#include <optional>
#include <string>

#include "ballpark/scene.h"

namespace ballpark {

/// fused: one kernel does the whole step in registers (scenes whose effects are all local). staged: a pass per stage.
enum class Path { automatic, fused, staged };

struct Options {
  int threads = 0;                          ///< 0: all cores
  std::string target = "auto";              ///< a name of `targets()`; auto: the fastest that this machine has
  std::optional<Precision> precision = {};  ///< instead of the scene's
  int copies = 1;                           ///< independent copies as one batch; copy k has ids from k n and seed + k
  double perturb = 0;                       ///< relative change of each copy's initial position and velocity
  Path path = Path::automatic;
};

}  // namespace ballpark
