#include "engine/core/targets.h"

namespace ballpark {

const std::vector<Target>& known_targets() {
  static const std::vector<Target> all = [] {
    std::vector<Target> list;
#if defined(__x86_64__)
    list.push_back({"base", "x86-64 with SSE2: runs everywhere", true});
#if BALLPARK_TARGETS > 1
    __builtin_cpu_init();
    const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
                    __builtin_cpu_supports("bmi2");
    const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
    list.push_back({"v3", "x86-64-v3: AVX2, 256-bit vectors", v3});
    list.push_back({"v4", "x86-64-v4: AVX-512, 512-bit vectors", v4});
#endif
#else
    list.push_back({"base", "this architecture's base instruction set", true});
#endif
    return list;
  }();
  return all;
}

std::string resolve_target(const std::string& name) {
  std::string best;
  for (const Target& target : known_targets()) {
    if (target.available && (name == "auto" || name == target.name)) best = target.name;
  }
  return best;
}

}  // namespace ballpark
