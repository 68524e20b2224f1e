#include "scenarios/command/expectation_text.h"

#include <algorithm>
#include <cmath>

#include "scenarios/command/text.h"

namespace ballpark::command {

int digits_of(const scenes::Expectation& expectation) {
  constexpr int usual = 6, exact = 12, most = 15;
  const double size = std::abs(expectation.value.value_or(0)), tolerance = expectation.tolerance.value_or(0);
  if (size == 0) return usual;
  if (tolerance == 0) return exact;
  return std::clamp(static_cast<int>(std::ceil(std::log10(size / tolerance))) + 2, usual, most);
}

std::string wanted(const scenes::Expectation& expectation) {
  if (expectation.value) {
    return number(*expectation.value, digits_of(expectation)) + " +- " + number(expectation.tolerance.value_or(0), 3);
  }
  if (expectation.minimum && expectation.maximum) {
    return number(*expectation.minimum) + " to " + number(*expectation.maximum);
  }
  return expectation.minimum ? ">= " + number(*expectation.minimum) : "<= " + number(expectation.maximum.value_or(0));
}

}  // namespace ballpark::command
