// Multistep methods. HNW: Hairer, Norsett & Wanner, Solving ODEs I.
#include "engine/integrators/rows.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

Row adams_bashforth(const char* name, const char* doc, int order) {
  return {.name = name,
          .doc = doc,
          .source = "Bashforth & Adams 1883; HNW III.1, eq. 1.4",
          .family = Family::multistep,
          .order = order,
          .history = order - 1};
}

/// Weights over a common denominator.
Row with(Row row, std::initializer_list<long double> weights, long double denominator) {
  int j = 0;
  for (const long double weight : weights) row.past[j++] = weight / denominator;
  return row;
}

}  // namespace

std::vector<Row> multistep_rows() {
  Row moulton = with({.name = "abm4",
                      .doc = "Adams-Bashforth-Moulton of order 4: predicted by ab4, evaluated, corrected",
                      .source = "Moulton 1926; HNW III.1, eq. 1.9",
                      .family = Family::multistep,
                      .order = 4,
                      .phases = 2,
                      .history = 3},
                     {55, -59, 37, -9}, 24);
  const long double corrector[] = {9.0L / 24, 19.0L / 24, -5.0L / 24, 1.0L / 24, 0};
  for (int j = 0; j < 5; ++j) moulton.corrector[j] = corrector[j];
  return {
      with(adams_bashforth("ab2", "Adams-Bashforth of order 2: one evaluation, and the rates of the step before", 2),
           {3, -1}, 2),
      with(adams_bashforth("ab3", "Adams-Bashforth of order 3: one evaluation, and the rates of two steps before", 3),
           {23, -16, 5}, 12),
      with(adams_bashforth("ab4", "Adams-Bashforth of order 4: one evaluation, and the rates of three steps before", 4),
           {55, -59, 37, -9}, 24),
      with(adams_bashforth("ab5", "Adams-Bashforth of order 5: one evaluation, and the rates of four steps before", 5),
           {1901, -2774, 2616, -1274, 251}, 720),
      moulton};
}

}  // namespace ballpark::BALLPARK_PRECISION
