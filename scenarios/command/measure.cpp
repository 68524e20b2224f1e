#include "scenarios/command/measure.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "ballpark/world.h"
#include "perf/bandwidth.h"
#include "perf/timing.h"
#include "scenarios/command/terminal.h"

namespace ballpark::command {
namespace {

constexpr int round_count = 7;

double ratio(double a, double b) {
  return b > 0 ? a / b : 0;
}

/// A world, and its start to return to.
struct Runner {
  World world;
  Snapshot start;
  std::vector<double> seconds;
  std::uint64_t completed = 0;  // repetitions of the last measurement

  Runner(const Scene& scene, Options options, int threads) : world((options.threads = threads, scene), options) {
    start = world.snapshot();
  }
  /// Stepping alone is timed, not the way back to the start. An interrupt ends it early.
  double timed(std::uint64_t steps, std::uint64_t repetitions = 1) {
    double total = 0;
    for (completed = 0; completed < repetitions && !command::interrupted(); ++completed) {
      world.restore(start);
      const double begin = now();
      world.step(steps);
      total += now() - begin;
    }
    return total;
  }
};

/// Of a whole run; with a tolerance, of one to look at.
std::uint64_t steps_of(const Scene& scene, Runner& runner) {
  if (scene.run.tolerance > 0) {
    runner.world.advance_to(scene.run.duration, 100000);
    return std::max<std::uint64_t>(1, runner.world.steps());
  }
  return static_cast<std::uint64_t>(std::max(1.0, std::floor(scene.run.duration / scene.run.step + 1e-9)));
}

/// Wall time of a step: more steps until the clock sees them well. Warms the world up too.
double seconds_per_step(Runner& runner, std::uint64_t most) {
  constexpr double long_enough = 0.02;
  std::uint64_t steps = 1;
  double taken = runner.timed(steps);
  while (taken < long_enough && steps < most && !interrupted()) {
    steps = std::min(2 * steps, most);
    taken = runner.timed(steps);
  }
  return taken / static_cast<double>(steps);
}

/// How much one repeat does, so that all of them take the time that is given.
void plan(ProfileFigures& figures, Runner& runner, const Scene& scene, const ProfileEffort& effort, std::size_t tasks) {
  figures.rounds = round_count;
  figures.repetitions = 1;
  figures.steps = effort.steps.value_or(steps_of(scene, runner));
  const double each = std::max(seconds_per_step(runner, figures.steps), 1e-9);
  if (effort.steps) return;
  const double slice = effort.seconds / static_cast<double>(tasks * round_count);
  figures.steps = std::clamp<std::uint64_t>(static_cast<std::uint64_t>(slice / each), 1, figures.steps);
  const double repetitions = slice / (each * static_cast<double>(figures.steps));
  figures.repetitions = static_cast<std::uint64_t>(std::max(1.0, std::round(repetitions)));
}

void measure_passes(ProfileFigures& figures, Runner& runner) {
  runner.world.profile(true);
  figures.wall_seconds = runner.timed(figures.steps, figures.repetitions * round_count);
  const std::vector<PassTime> times = runner.world.pass_times();
  runner.world.profile(false);
  figures.status = runner.world.status();
  figures.counters = runner.world.counters();
  const double body_steps = static_cast<double>(figures.bodies) * static_cast<double>(figures.steps * runner.completed);
  figures.outside_passes = figures.wall_seconds;
  for (const PassTime& time : times) {
    const double per_second = ratio(time.bytes, time.seconds);
    figures.passes.push_back({time, ratio(time.seconds, figures.wall_seconds), ratio(1e9 * time.seconds, body_steps),
                              ratio(time.bytes, body_steps), per_second, ratio(per_second, figures.streaming)});
    figures.outside_passes -= time.seconds;
  }
}

/// 1..8, then doubling, then all: more would take long and show no more.
std::vector<int> thread_counts(int most) {
  std::vector<int> counts;
  for (int n = 1; n < most; n = n < 8 ? n + 1 : 2 * n) counts.push_back(n);
  counts.push_back(most);
  return counts;
}

using Runners = std::vector<std::unique_ptr<Runner>>;

/// In turns, each round starting one later, so that a busy machine slows all alike.
void run_rounds(ProfileFigures& figures, const Runners& runners, Progress& progress) {
  for (int round = 0; round < round_count; ++round) {
    for (std::size_t turn = 0; turn < runners.size(); ++turn) {
      Runner& runner = *runners[(turn + static_cast<std::size_t>(round)) % runners.size()];
      runner.seconds.push_back(runner.timed(figures.steps, figures.repetitions));
      const auto done_so_far = static_cast<double>(static_cast<std::size_t>(round) * runners.size() + turn + 1);
      progress.show(done_so_far / static_cast<double>(runners.size() * round_count));
      if (interrupted()) return;
    }
  }
}

void summarise(ProfileFigures& figures, const Runners& runners) {
  const double body_steps =
      static_cast<double>(figures.bodies) * static_cast<double>(figures.steps * figures.repetitions);
  for (const auto& runner : runners) {
    const perf::Samples samples(runner->seconds);
    ThreadFigure figure;
    figure.threads = runner->world.threads();
    figure.best_seconds = samples.minimum();
    figure.median_seconds = samples.median();
    figure.best_rate = ratio(body_steps, figure.best_seconds);
    figure.median_rate = ratio(body_steps, figure.median_seconds);
    const bool known = runner == runners.back();
    figure.streaming = known ? figures.streaming : perf::streaming_bandwidth(figure.threads).bytes_per_second;
    figures.threads.push_back(figure);
  }
  for (ThreadFigure& figure : figures.threads) {
    figure.speed_up = ratio(figures.threads.front().best_seconds, figure.best_seconds);
    figure.streaming_speed_up = ratio(figure.streaming, figures.threads.front().streaming);
  }
}

}  // namespace

ProfileFigures measure(const Scene& scene, const Options& options, const ProfileEffort& effort, bool show_progress) {
  ProfileFigures figures;
  Progress progress("profiling", show_progress);
  auto all_threads = std::make_unique<Runner>(scene, options, options.threads);
  figures.bodies = all_threads->world.body_count();
  figures.explanation = all_threads->world.explain();
  const std::vector<int> counts = thread_counts(all_threads->world.threads());
  figures.streaming = perf::streaming_bandwidth(counts.back()).bytes_per_second;
  plan(figures, *all_threads, scene, effort, counts.size() + 1);
  measure_passes(figures, *all_threads);
  Runners runners;
  for (int n : counts) {
    runners.push_back(n == counts.back() ? std::move(all_threads) : std::make_unique<Runner>(scene, options, n));
    runners.back()->timed(1);
  }
  if (!interrupted()) run_rounds(figures, runners, progress);
  figures.interrupted = interrupted();
  if (!figures.interrupted) summarise(figures, runners);
  return figures;
}

}  // namespace ballpark::command
