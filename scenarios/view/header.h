// What the page is told of a run, as JSON.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/view/recording.h"

namespace ballpark::view {

/// How a column's values are stored.
struct HeaderColumn {
  std::string name;
  std::size_t components = 1, bits = 8, differences = 1;
  std::optional<std::pair<double, double>> range;  ///< what the least and the largest value stand for
  std::string unit;
};

/// `box`: of all positions [m].
std::string header(const Recording& recording, const Box& box, const std::vector<HeaderColumn>& columns,
                   const std::vector<std::string>& notes);

}  // namespace ballpark::view
