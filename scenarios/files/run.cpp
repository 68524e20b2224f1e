// run: builds the world, steps it from one occasion to the next, samples, judges and reports.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "scenarios/files/event_log.h"
#include "scenarios/files/judge.h"
#include "scenarios/files/timetable.h"

namespace ballpark::scenes {

namespace {

const char* word(Precision precision) {
  switch (precision) {
    case Precision::single_:
      return "single";
    case Precision::double_:
      return "double";
    case Precision::extended:
      return "extended";
  }
  return "";
}

double ratio(double difference, double scale) {
  return scale > 0 || !std::isfinite(difference) ? difference / scale : 0;
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Steps a world between occasions, asks for progress about every tenth of a second (whatever took it), and keeps the
/// time that the steps took.
class Driver {
 public:
  Driver(World& world, EventLog& events, const RunHooks& hooks, const Pace& pace)
      : world_(world), events_(events), hooks_(hooks), pace_(pace) {}

  /// On the axis of the pace.
  double now() const { return pace_.by_steps() ? static_cast<double>(world_.steps()) : world_.time(); }

  /// To the place, or where the next step would pass it. False if the run was interrupted on the way, or can go no
  /// farther.
  bool advance(double place) {
    for (bool there = false; !there;) {
      const std::uint64_t before = world_.steps();
      there = walk(place);
      if (!there && world_.steps() == before) return false;
      if (!hooks_.progress || seconds_since(last_progress_) < 0.1) continue;
      last_progress_ = Clock::now();
      interrupted_ = !hooks_.progress(now() / pace_.end());
      if (interrupted_) return false;
    }
    return true;
  }

  bool interrupted() const { return interrupted_; }
  double seconds() const { return seconds_; }

 private:
  /// Some steps: are they all?
  bool walk(double place) {
    constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();
    const std::uint64_t steps = hooks_.progress ? chunk_ : no_limit;
    const Clock::time_point start = Clock::now();
    const bool there = pace_.by_steps() ? walk_steps(place, steps) : walk_times(place, steps);
    const double taken = seconds_since(start);
    seconds_ += taken;
    if (taken < 0.02 && chunk_ < no_limit / 2) chunk_ *= 2;
    if (taken > 0.1) chunk_ = std::max<std::uint64_t>(1, chunk_ / 2);
    return there;
  }

  bool walk_steps(double place, std::uint64_t most) {
    const std::uint64_t n = std::min(most, static_cast<std::uint64_t>(place) - world_.steps());
    events_.empty() ? world_.step(n) : events_.step(n, pace_.step());
    return now() >= place;
  }

  bool walk_times(double place, std::uint64_t most) {
    return events_.empty() ? world_.approach(place, pace_.end(), most) : events_.approach(place, pace_.end(), most);
  }

  World& world_;
  EventLog& events_;
  const RunHooks& hooks_;
  const Pace& pace_;
  bool interrupted_ = false;
  std::uint64_t chunk_ = 1;
  double seconds_ = 0;
  Clock::time_point last_progress_ = Clock::now();
};

class Run {
 public:
  Run(const SceneFile& file, const Options& options, const RunHooks& hooks)
      : file_(file),
        hooks_(hooks),
        pace_(file.scene.run),
        world_(file.scene, options),
        initial_(opened(world_, hooks).totals()),
        path_(world_.explain().path),
        events_(file, world_),
        driver_(world_, events_, hooks, pace_),
        judge_(file, world_, report()) {
    plan();
  }

  RunReport finish() {
    serve();
    while (driver_.now() < pace_.end()) {
      const double place = next_stop();
      if (!driver_.advance(place) || !serve_at(place)) break;
    }
    if (hooks_.last) hooks_.last(world_);
    RunReport last = report();
    last.state_hash = fmt::format("{:016x}", world_.state_hash());
    last.verdicts = judge_.verdicts();
    last.warnings = warnings();
    last.interrupted = driver_.interrupted();
    return last;
  }

 private:
  /// With its ledger, if it is asked for: expectations may name it.
  static World& opened(World& world, const RunHooks& hooks) {
    world.keep_ledger(hooks.ledger);
    return world;
  }

  /// Something to do at some steps.
  struct Duty {
    Occasions occasions;
    std::function<void()> action;
  };

  void plan() {
    for (std::size_t i = 0; i < std::min(file_.outputs.size(), hooks_.writers.size()); ++i) {
      const OutputRequest& output = file_.outputs[i];
      const auto write = [this, i] { hooks_.writers[i](world_); };
      if (output.every) {
        duties_.push_back({Occasions(pace_.length(*output.every), pace_), write});
      } else {
        duties_.push_back({Occasions(places(output.at)), write});
      }
    }
    for (std::size_t i = 0; i < file_.expectations.size(); ++i) {
      const double at = file_.expectations[i].at.value_or(file_.scene.run.duration);
      const auto measure = [this, i] { judge_.measure(i, world_, [this] { return report(); }); };
      duties_.push_back({Occasions(places({at})), measure});
    }
  }

  std::vector<double> places(const std::vector<double>& times) const {
    std::vector<double> list;
    for (const double time : times) list.push_back(pace_.at(time));
    return list;
  }

  void serve() {
    for (Duty& duty : duties_) {
      if (duty.occasions.next() != driver_.now()) continue;
      duty.action();
      duty.occasions.pass();
    }
  }

  /// What is due at the place, which may be between two steps. False if the run does not get there.
  bool serve_at(double place) {
    if (driver_.now() == place) {
      serve();
      return true;
    }
    bool reached = false;
    world_.look_ahead(place, [&] {
      reached = driver_.now() == place;
      if (reached) serve();
    });
    if (!reached) world_.advance_to(place);  // as far as it goes, and why no farther
    return reached;
  }

  double next_stop() const {
    double stop = pace_.end();
    for (const Duty& duty : duties_) stop = std::min(stop, duty.occasions.next().value_or(stop));
    return stop;
  }

  /// The run as it stands; without what only its end can tell.
  RunReport report() const {
    RunReport now;
    now.scenario = file_.scene.name;
    now.status = world_.status();
    now.bodies = world_.body_count();
    now.time = world_.time();
    now.counters = world_.counters();
    now.integrator = file_.scene.run.integrator;
    now.contact = file_.scene.contact.kind;
    if (now.contact == "penalty") now.largest_step = world_.explain().contact.largest_step;
    now.step = file_.scene.run.step;
    now.tolerance = file_.scene.run.tolerance;
    now.wall_seconds = driver_.seconds();
    now.body_steps_per_second =
        ratio(static_cast<double>(now.bodies) * static_cast<double>(now.counters.steps), now.wall_seconds);
    now.threads = world_.threads();
    now.precision = word(world_.precision());
    now.target = world_.target();
    now.path = path_;
    now.initial = initial_;
    now.final = world_.totals();
    now.events = events_.until(now.time);
    if (hooks_.ledger) now.ledger = world_.ledger();
    add_drifts(now);
    return now;
  }

  static void add_drifts(RunReport& now) {
    const Totals &a = now.initial, &b = now.final;
    const double energy_scale = std::max({std::abs(a.energy()), std::abs(b.energy()), a.kinetic, b.kinetic});
    now.energy_drift_relative = ratio(b.energy() - a.energy(), energy_scale);
    now.momentum_drift = ratio((b.momentum - a.momentum).norm(), std::max(a.momentum_scale, b.momentum_scale));
    now.angular_momentum_drift = ratio((b.angular_momentum - a.angular_momentum).norm(),
                                       std::max(a.angular_momentum_scale, b.angular_momentum_scale));
  }

  void add_contact_warnings(std::vector<std::string>& list) const {
    const Counters now = world_.counters();
    if (now.unfinished_impacts > 0) {
      list.push_back(
          fmt::format("{} impacts still approached after the last round of reflections; they ended without restitution",
                      now.unfinished_impacts));
    }
    if (now.held_back > 0) {
      list.push_back(fmt::format(
          "{} motions were cut short where deflected bodies met others unforeseen; these bodies lag behind: a smaller "
          "step, more substeps or a larger contact.margin avoids it",
          now.held_back));
    }
    if (now.missed > 0 && file_.scene.contact.kind == "penalty") {
      list.push_back(
          fmt::format("{} motions of a step were longer than the body's radius beside a neighbour: contacts "
                      "may have been stepped over",
                      now.missed));
    } else if (now.missed > 0) {
      list.push_back(fmt::format("in {} substeps an overlap could not be prevented", now.missed));
    }
  }

  std::vector<std::string> warnings() const {
    std::vector<std::string> list;
    const RunSettings& run = file_.scene.run;
    if (pace_.remainder() > 0) {
      list.push_back(
          fmt::format("run.duration = {} s is not a whole number of steps of {} s: the last {:.6g} s are not run",
                      run.duration, run.step, pace_.remainder()));
    }
    for (std::size_t i = 0; i < file_.outputs.size(); ++i) {
      if (!pace_.by_steps() || file_.outputs[i].every.value_or(run.step) >= run.step * (1 - 1e-9)) continue;
      list.push_back(fmt::format("output[{}].every = {} s is shorter than a step: one frame is written each step", i,
                                 *file_.outputs[i].every));
    }
    const double end = run.duration * (1 - 1e-12);
    for (std::size_t i = 0; i < file_.scene.impulses.size(); ++i) {
      const double at = file_.scene.impulses[i].at;
      if (at >= end) list.push_back(fmt::format("impulse[{}].at = {} s is not before the end: it does not act", i, at));
    }
    for (std::size_t i = 0; i < file_.scene.effects.size(); ++i) {
      const auto& parameters = file_.scene.effects[i].parameters;
      const auto at = parameters.find("at");
      if (at == parameters.end() || std::get<double>(at->second) < end) continue;
      list.push_back(
          fmt::format("effects[{}].at = {} s is not before the end: it does not act", i, std::get<double>(at->second)));
    }
    add_contact_warnings(list);
    const Totals now = world_.totals();
    if (now.non_finite_bodies == 0 && !std::isfinite(now.energy())) {
      list.push_back(
          "energy is not finite, although all bodies are: forces or speeds are too large for this precision");
    }
    if (world_.status().code != Status::Code::ok) list.push_back(world_.status().sentence);
    if (const std::size_t lost = now.non_finite_bodies; lost > 0) {
      list.push_back(fmt::format("{} of {} bodies are not finite; they are left out of energy and momentum", lost,
                                 world_.body_count()));
    }
    return list;
  }

  const SceneFile& file_;
  const RunHooks& hooks_;
  Pace pace_;
  World world_;
  Totals initial_;
  std::string path_;
  EventLog events_;
  Driver driver_;
  Judge judge_;
  std::vector<Duty> duties_;
};

}  // namespace

RunReport run(const SceneFile& file, const Options& options, const RunHooks& hooks) {
  return Run(file, options, hooks).finish();
}

}  // namespace ballpark::scenes
