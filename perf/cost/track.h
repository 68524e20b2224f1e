// Where bodies were at a few times of a run, and how far two such tracks are apart.
#pragma once

#include <cstdint>
#include <vector>

#include "ballpark/scenes.h"
#include "ballpark/world.h"
#include "perf/cost/result.h"

namespace ballpark::cost {

/// When and whom to look at.
struct Samples {
  std::vector<double> times;  ///< [s], ascending, the last one the end
  std::vector<std::size_t> ids;
  std::vector<BodyState> start;  ///< of these bodies
  std::vector<scenes::BodyEvent> events = {};
};
/// `count` equal parts of the duration; all bodies of one copy, or as many as `most`, evenly spread.
Samples samples_of(double duration, std::size_t bodies, std::size_t count, std::size_t most);

struct Track {
  std::vector<char> known;        ///< by time: was the run there?
  std::vector<BodyState> states;  ///< time by time, in the order of the ids
  std::vector<Totals> totals;     ///< by time, of all bodies
  double penetration = 0;         ///< deepest overlap of the run [m]
  std::vector<scenes::EventTimes> events = {};

  explicit Track(const Samples& samples = {});
  /// As the world is now.
  void look(const World& world, const Samples& samples, std::size_t time);
};

/// The largest value along the path: what rounding is relative to.
std::array<double, quantity_count> size_of(const Track& track);
/// The same, but of positions how far bodies go from their start (as large as they are, if they stay).
std::array<double, quantity_count> scale_of(const Track& track, const Samples& samples);

/// Of `track` from `reference`, at the times that both know; energies and momenta from those of `start`.
Errors errors_of(const Track& track, const Track& reference, const Totals& start);

/// One of the values of the errors, by quantity and by "end", "maximum" or "rms".
double value_of(const Errors& errors, Quantity quantity, const std::string& which);

}  // namespace ballpark::cost
