// Measurements behind `ballpark profile`. Each one starts from the scene's start, so that all do the same work.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ballpark/options.h"
#include "ballpark/report.h"
#include "ballpark/scene.h"

namespace ballpark::command {

struct PassFigure {
  PassTime time;
  double share = 0;  ///< of the wall time
  double ns_per_body_step = 0, bytes_per_body_step = 0, bytes_per_second = 0;
  double streaming_share = 0;  ///< of the machine's streaming bandwidth
};

struct ThreadFigure {
  int threads = 1;
  double best_seconds = 0, median_seconds = 0;   ///< of one repeat
  double best_rate = 0, median_rate = 0;         ///< [body-steps/s]
  double speed_up = 1;                           ///< best against best, one thread
  double streaming = 0, streaming_speed_up = 1;  ///< of the triad [B/s]
};

struct ProfileFigures {
  std::size_t bodies = 0;
  std::uint64_t steps = 0, repetitions = 0;  ///< a repeat steps `steps`, `repetitions` times from the start
  int rounds = 0;
  double wall_seconds = 0;    ///< of the pass clocks' run
  double outside_passes = 0;  ///< [s] of it
  double streaming = 0;       ///< [B/s], on all threads
  Explanation explanation;
  std::vector<PassFigure> passes;
  std::vector<ThreadFigure> threads;
  Counters counters;  ///< of the pass clocks' run
  Status status;
  bool interrupted = false;
};

struct ProfileEffort {
  double seconds = 5;                  ///< in all, about
  std::optional<std::uint64_t> steps;  ///< of each repeat
};

/// `options.threads` is the largest number of threads (0: all cores).
ProfileFigures measure(const Scene& scene, const Options& options, const ProfileEffort& effort, bool show_progress);

}  // namespace ballpark::command
