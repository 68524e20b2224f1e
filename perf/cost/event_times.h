// When events were: on an exact trajectory, and how far two runs differ in it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ballpark/scenes.h"

namespace ballpark::cost {

/// The k-th event of each name against the k-th of the other's.
struct EventErrors {
  double time = 0;        ///< largest difference [s]; infinite where counts differ
  std::string different;  ///< "landing: 3 times instead of 2"; "" if both have as many
};
EventErrors event_errors(const std::vector<scenes::EventTimes>& events,
                         const std::vector<scenes::EventTimes>& reference);

/// Rounding of a time that a bracket has found [s].
double rounding_of(const std::vector<scenes::EventTimes>& events);

/// Times at which the event's value passes 0, where `state` tells the body's at any time up to the duration [s]; looked
/// for in so many equal parts of it.
scenes::EventTimes exact_times(const scenes::BodyEvent& event, const BodyState& start,
                               const std::function<BodyState(long double)>& state, double duration, std::size_t parts);

}  // namespace ballpark::cost
