#include "tests/determinism/oracle.h"

TEST_CASE("Oracle: vectors of every target give the bits of scalar code, in double", "[bits]") {
  ballpark::f64::oracle::compare_everything();
}

TEST_CASE("Oracle: the same with denormals flushed, in double", "[bits]") {
  const ballpark::FlushDenormals flush;
  ballpark::f64::oracle::compare_everything();
}
