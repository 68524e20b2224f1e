// Compiled once for each precision and target.
#include "engine/world/local_step.h"

#define BALLPARK_JOIN_(a, b) a##b
#define BALLPARK_JOIN(a, b) BALLPARK_JOIN_(a, b)
#define BALLPARK_TEXT_(a) #a
#define BALLPARK_TEXT(a) BALLPARK_TEXT_(a)

namespace ballpark::BALLPARK_PRECISION {

const KernelTable& BALLPARK_JOIN(kernel_table_, BALLPARK_TARGET)() {
  static constexpr KernelTable table = table_of_all_motions<LanesOf>(BALLPARK_TEXT(BALLPARK_TARGET));
  return table;
}

}  // namespace ballpark::BALLPARK_PRECISION
