// Curves over time as SVG, for reports and README files: panels one below the other, on one axis of time.
#pragma once

#include <string>
#include <vector>

#include "scenarios/view/recording.h"

namespace ballpark::view {

struct Figure {
  std::string title;
  std::vector<std::string> paragraphs;  ///< below the title
  std::vector<double> times;            ///< ascending [s]
  std::vector<Series> series;           ///< a value for each time; neighbours of one unit share a panel
};

/// Curves are told apart by colour and dash, on light and on dark ground. Where values barely change, a panel shows how
/// far they are from the first one; of several curves on one scale, the first has such a panel besides if it is flat
/// there. What is not finite is left out.
std::string svg(const Figure& figure);

}  // namespace ballpark::view
