#include "perf/cost/timing_rounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "perf/cost/cost.h"
#include "perf/timing.h"

namespace ballpark::cost {

namespace {

using perf::seconds_now;

constexpr double short_run = 1e-4;  ///< shorter ones are repeated within a turn [s]
constexpr int most_repeats = 20;

/// A run's world and its times so far.
struct Runner {
  TimedRun* run;
  Subject subject;
  int repeats = 1;
  std::vector<double> seconds = {};

  void warm_up() {
    const double expected = std::max(subject.run(), 1e-7);
    repeats = std::clamp(static_cast<int>(short_run / expected), 1, most_repeats);
  }

  void take_turn() {
    for (int i = 0; i < repeats; ++i) seconds.push_back(subject.run());
  }

  void finish() {
    const perf::Samples samples(std::move(seconds));
    run->seconds = {samples.minimum(), samples.median(), samples.maximum(), static_cast<int>(samples.count())};
    run->trouble = subject.trouble();
    const std::string hash = fmt::format("{:016x}", subject.world().state_hash());
    if (!run->state_hash.empty() && hash != run->state_hash) {
      run->trouble = "the timed run ended in other bits than the one looked at";
    }
  }
};

using Runners = std::vector<std::unique_ptr<Runner>>;

/// As many of the runs from `first` on as memory holds at once.
Runners next_runners(std::vector<TimedRun>& runs, const Options& options, std::size_t& first) {
  Runners runners;
  std::size_t memory = 0;
  for (; first < runs.size() && memory < most_memory; ++first) {
    TimedRun& run = runs[first];
    runners.push_back(std::unique_ptr<Runner>(new Runner{&run, Subject(*run.scene, run.setting, options)}));
    memory += memory_of(runners.back()->subject.world());
  }
  return runners;
}

}  // namespace

std::size_t memory_of(const World& world) {
  return 2 * world.explain().column_bytes + 10'000;  // and its start, to return to
}

bool time_in_turns(std::vector<TimedRun>& runs, const Options& options, const SweepTime& time,
                   const std::function<bool(double)>& go_on) {
  for (std::size_t first = 0; first < runs.size();) {
    const double part = static_cast<double>(first);
    Runners runners = next_runners(runs, options, first);
    const double whole = static_cast<double>(runs.size()), share = (static_cast<double>(first) - part) / whole;
    const double begin = seconds_now();
    for (const auto& runner : runners) runner->warm_up();
    for (int round = 0; round < time.rounds || seconds_now() - begin < time.seconds * share; ++round) {
      for (std::size_t turn = 0; turn < runners.size(); ++turn) {
        runners[(turn + static_cast<std::size_t>(round)) % runners.size()]->take_turn();
        if (!go_on(part / whole + share * std::min(1.0, double(round) / time.rounds))) return false;
      }
      if (round > 100 * time.rounds) break;
    }
    for (const auto& runner : runners) runner->finish();
  }
  return true;
}

bool time_points(const Ground& ground, const std::vector<std::size_t>& which, const SweepTime& time, Result& result,
                 const std::function<bool(double)>& go_on) {
  std::vector<std::size_t> timed;
  std::vector<TimedRun> runs;
  for (const std::size_t i : which) {
    const Point& point = result.points[i];
    if (!point.trouble.empty() || point.seconds.runs == 0) continue;
    timed.push_back(i);
    runs.push_back({&ground.scene, point.setting, point.state_hash});
  }
  if (!time_in_turns(runs, ground.options, time, go_on)) return false;
  for (std::size_t i = 0; i < timed.size(); ++i) {
    result.points[timed[i]].seconds = runs[i].seconds;
    result.points[timed[i]].trouble = runs[i].trouble;
  }
  return true;
}

}  // namespace ballpark::cost
