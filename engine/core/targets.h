// Instruction sets that kernels are compiled for, and which of them this machine runs.
#pragma once

#include <string>
#include <vector>

namespace ballpark {

struct Target {
  std::string name, doc;
  bool available = true;  ///< this machine can run it
};

/// Slowest first.
const std::vector<Target>& known_targets();
/// "auto" becomes the fastest available; "" if the name is unknown or this machine cannot run it.
std::string resolve_target(const std::string& name);

}  // namespace ballpark
