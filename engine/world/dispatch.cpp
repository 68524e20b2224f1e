#include "engine/core/targets.h"
#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

const KernelTable* kernel_table(const std::string& target) {
  const std::string name = resolve_target(target);
  if (name.empty()) return nullptr;
#if BALLPARK_TARGETS > 1
  if constexpr (!std::is_same_v<Real, long double>) {  // extended precision has base kernels only
    if (name == "v3") return &kernel_table_v3();
    if (name == "v4") return &kernel_table_v4();
  }
#endif
  return &kernel_table_base();
}

const char* name(MotionKind kind) {
  switch (kind) {
    case MotionKind::point:
      return "point";
    case MotionKind::spinning:
      return "spinning";
    case MotionKind::oriented:
    case MotionKind::oriented_exponential:
      return "oriented";
    case MotionKind::rigid:
    case MotionKind::rigid_exponential:
    case MotionKind::body_frame:
      return "rigid";
    case MotionKind::pivoted:
    case MotionKind::pivoted_exponential:
      return "pivoted";
  }
  return "";
}

int state_size(MotionKind kind) {
  return with_motion(kind, []<class M>() { return M::size; });
}

}  // namespace ballpark::BALLPARK_PRECISION
