#include "scenarios/view/frame_times.h"

#include <algorithm>
#include <cmath>

#include "scenarios/files/timetable.h"

namespace ballpark::view {

std::vector<double> frame_times(double end, std::size_t frames, std::optional<double> every) {
  std::vector<double> times;
  const double nearly = 1e-9;  // of an interval: rounding shall not lose the last
  const std::size_t intervals =
      every ? static_cast<std::size_t>(end / *every + nearly) : std::max<std::size_t>(frames, 1) - 1;
  const double distance = every ? *every : end / static_cast<double>(std::max<std::size_t>(intervals, 1));
  for (std::size_t k = 0; k <= intervals; ++k) times.push_back(std::min(end, static_cast<double>(k) * distance));
  return times;
}

std::size_t frames_of(const RunSettings& run, const std::vector<double>& times) {
  const scenes::Pace pace(run);
  std::size_t count = 0;
  double last = -1;
  for (const double time : times) {
    const double place = pace.at(time);
    count += place != last;
    last = place;
  }
  return count;
}

}  // namespace ballpark::view
