// How large the next step of an embedded pair shall be: PI control. (Gustafsson 1991, ACM Trans. Math. Softw. 17, 533;
// Hairer, Norsett & Wanner, Solving ODEs I, II.4 and IV.2 of volume II, with the constants of their dopri5.)
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/core/maths.h"

namespace ballpark {

struct StepControl {
  static constexpr double safety = 0.9, least_factor = 0.2, most_factor = 5, integral_share = 0.2;

  double step = 0;          ///< to try next [s]
  double error_before = 1;  ///< of the last accepted step, over the tolerance
  bool was_rejected = false;
  int order = 1;  ///< the error shrinks as h^order

  /// After a try of length h whose error over the tolerance is `error`: is it accepted?
  bool judge(double h, double error) {
    if (!std::isfinite(error)) return reject(h * least_factor / 2);
    const double integral = integral_share / order, proportional = 1.0 / order - 0.75 * integral;
    if (error > 1) return reject(h * std::max(least_factor, safety * maths::pow(error, -1.0 / order)));
    double factor = most_factor;
    if (error > 0) factor = safety * maths::pow(error, -proportional) * maths::pow(error_before, integral);
    factor = std::clamp(factor, least_factor, was_rejected ? 1.0 : most_factor);
    step = h * factor;
    error_before = std::max(error, 1e-4);
    was_rejected = false;
    return true;
  }

 private:
  bool reject(double smaller) {
    step = smaller;
    was_rejected = true;
    return false;
  }
};

}  // namespace ballpark
