#undef BALLPARK_PRECISION
#define BALLPARK_PRECISION f32
#include "tests/unit/kernels/power.h"

TEST_CASE("Power: of numbers of any size, to its roundings, in single", "[kernels]") {
  ballpark::f32::check_power(125);
}

TEST_CASE("Wave: sine and cosine of phases of many turns, in single", "[kernels]") {
  ballpark::f32::check_wave();
}
