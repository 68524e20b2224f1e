// Timing of many settings in turns.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "perf/cost/cost.h"
#include "perf/timing.h"

namespace ballpark::cost {

namespace {

using perf::seconds_now;

constexpr std::size_t most_memory = 2'000'000'000;  ///< of worlds that wait for their turns [B]
constexpr double short_run = 1e-4;                  ///< shorter ones are repeated within a turn [s]
constexpr int most_repeats = 20;

/// A point's world and its times so far.
struct Runner {
  Point* point;
  Subject subject;
  std::vector<double> seconds = {};

  void take_turn() {
    const double expected = std::max(point->seconds.minimum, 1e-7);
    const int repeats = std::clamp(static_cast<int>(short_run / expected), 1, most_repeats);
    for (int i = 0; i < repeats; ++i) seconds.push_back(subject.run());
  }

  void finish() {
    const perf::Samples samples(std::move(seconds));
    point->seconds = {samples.minimum(), samples.median(), samples.maximum(), static_cast<int>(samples.count())};
    const std::string hash = fmt::format("{:016x}", subject.world().state_hash());
    if (hash != point->state_hash) point->trouble = "the timed run ended in other bits than the one looked at";
  }
};

using Runners = std::vector<std::unique_ptr<Runner>>;

/// As many of the points from `first` on as memory holds at once.
Runners next_runners(const Ground& ground, const std::vector<std::size_t>& which, std::size_t& first, Result& result) {
  Runners runners;
  std::size_t memory = 0;
  for (; first < which.size() && memory < most_memory; ++first) {
    Point& point = result.points[which[first]];
    if (!point.trouble.empty() || point.seconds.runs == 0) continue;
    runners.push_back(
        std::unique_ptr<Runner>(new Runner{&point, Subject(ground.scene, point.setting, ground.options)}));
    memory += 2 * runners.back()->subject.world().explain().column_bytes + 10'000;
  }
  return runners;
}

}  // namespace

bool time_points(const Ground& ground, const std::vector<std::size_t>& which, const SweepTime& time, Result& result,
                 const std::function<bool(double)>& go_on) {
  for (std::size_t first = 0; first < which.size();) {
    const double part = static_cast<double>(first);
    Runners runners = next_runners(ground, which, first, result);
    const double whole = static_cast<double>(which.size()), share = (static_cast<double>(first) - part) / whole;
    const double begin = seconds_now();
    for (const auto& runner : runners) runner->subject.run();  // warm
    for (int round = 0; round < time.rounds || seconds_now() - begin < time.seconds * share; ++round) {
      for (std::size_t turn = 0; turn < runners.size(); ++turn) {
        runners[(turn + static_cast<std::size_t>(round)) % runners.size()]->take_turn();
        if (!go_on(part / whole + share * std::min(1.0, double(round) / time.rounds))) return false;
      }
      if (runners.empty() || round > 100 * time.rounds) break;
    }
    for (const auto& runner : runners) runner->finish();
  }
  return true;
}

}  // namespace ballpark::cost
