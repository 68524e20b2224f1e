// The controller of adaptive steps, by itself.
#include "engine/integrators/step_control.h"

#include <limits>

#include "tests/catch.h"

using ballpark::StepControl;

TEST_CASE("Step control: accepts what is within the tolerance, and grows no faster than five times", "[integrators]") {
  StepControl control;
  control.order = 5;
  CHECK(control.judge(0.1, 0));
  CHECK(control.step == 0.5);
  CHECK(control.judge(0.1, 1e-30));
  CHECK(control.step == 0.5);
  CHECK(control.judge(0.1, 1));
  CHECK(control.step > 0.02);
  CHECK(control.step < 0.1);
}

TEST_CASE("Step control: a rejected step shrinks with the root of its error, at most five times", "[integrators]") {
  StepControl control;
  control.order = 5;
  CHECK_FALSE(control.judge(0.1, 32));
  CHECK(std::abs(control.step - 0.1 * 0.9 / 2) < 1e-15);
  CHECK_FALSE(control.judge(0.1, 1e30));
  CHECK(std::abs(control.step - 0.02) < 1e-15);
  CHECK(control.judge(0.02, 1e-9));
  CHECK(control.step == 0.02);  // no growth right after
  CHECK(control.judge(0.02, 1e-9));
  CHECK(control.step > 0.02);
}

TEST_CASE("Step control: an error that is no number is rejected", "[integrators]") {
  StepControl control;
  for (const double error : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK_FALSE(control.judge(0.1, error));
    CHECK(control.step > 0);
    CHECK(control.step < 0.1);
  }
}

TEST_CASE("Step control: an error that falls as h^order leads to a step that meets it", "[integrators]") {
  for (const int order : {3, 5, 8}) {
    StepControl control;
    control.order = order;
    control.step = 1e-6;
    const double wanted = 0.37;  // at which the error is 1
    for (int i = 0; i < 60; ++i) control.judge(control.step, std::pow(control.step / wanted, order));
    CAPTURE(order);
    CHECK(control.step > 0.8 * wanted);
    CHECK(control.step < wanted);
  }
}
