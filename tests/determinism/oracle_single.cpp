#undef BALLPARK_PRECISION
#define BALLPARK_PRECISION f32
#include "tests/determinism/oracle.h"

TEST_CASE("Oracle: vectors of every target give the bits of scalar code, in single", "[bits]") {
  ballpark::f32::oracle::compare_everything();
}

TEST_CASE("Oracle: the same with denormals flushed, in single", "[bits]") {
  const ballpark::FlushDenormals flush;
  ballpark::f32::oracle::compare_everything();
}
