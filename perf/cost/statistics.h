// Means of a few independent runs: how well they are known, and whether two of them differ.
#pragma once

#include <vector>

namespace ballpark::cost {

/// How often |t| is larger than this by chance: Student's t with so many degrees of freedom, both tails.
double student_tails(double t, double freedom);
/// The t that is not exceeded with this probability, from 1/2 up.
double student_quantile(double probability, double freedom);

/// The mean of independent values.
struct Mean {
  double value = 0;
  double error = 0;  ///< standard error
  int count = 0;
  /// The interval of 95 % reaches so far to either side.
  double margin() const;
};
Mean mean_of(const std::vector<double>& values);

/// Two means that are independent of each other (Welch 1947, Biometrika 34, 28).
struct Difference {
  double value = 0;   ///< a - b
  double error = 0;   ///< standard error
  double chance = 1;  ///< how often means of the same are as far apart
  double sigmas() const;
};
Difference difference_of(const Mean& a, const Mean& b);

}  // namespace ballpark::cost
