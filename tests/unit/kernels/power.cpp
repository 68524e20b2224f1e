#include "tests/unit/kernels/power.h"

TEST_CASE("Power: of numbers of any size, to its roundings, in double", "[kernels]") {
  ballpark::f64::check_power(1000);
}

TEST_CASE("Wave: sine and cosine of phases of many turns, in double", "[kernels]") {
  ballpark::f64::check_wave();
}
