// One setting as a world that can be run again and again from its start.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "ballpark/options.h"
#include "ballpark/world.h"
#include "perf/cost/track.h"

namespace ballpark::cost {

/// The scene under a setting.
Scene scene_with(const Scene& scene, const Setting& setting);
/// The scene's own.
Setting setting_of(const Scene& scene);
/// Do enough bodies attract each other for a tree?
bool may_use_tree(const Scene& scene);
/// The setting, with the usual rotation where its integrator cannot take the scene's.
Setting allowed(const Scene& scene, Setting setting);
/// Are moments of inertia unequal?
bool has_own_axes(const BodyGroup& group);
/// May bodies of it have orientations that change?
bool turns(const Scene& scene);
/// "rk4, step 0.001 s", "dormand_prince5, tolerance 1e-08, single"
std::string text(const Setting& setting);
/// "12 iterations x 4", "penalty 1e+06 N/m"
std::string text(const ContactChoice& contact);
std::string opening_text(double angle);
/// "49.4 us"
std::string time_text(double seconds);
/// Whole steps of the setting in the duration; 0: it has none, or they do not fill it.
std::uint64_t steps_in(double duration, double step);

/// Steps that may pass between two questions whether to go on.
std::uint64_t steps_at_once(std::size_t bodies);
/// Asked now and then; false: stop.
using GoOn = std::function<bool()>;

class Subject {
 public:
  /// Throws SceneError.
  Subject(const Scene& scene, const Setting& setting, const Options& options);

  /// The whole run as `ballpark run` does it, from the start: wall seconds of stepping alone.
  double run();
  /// The same run, looked at on the way, between its steps if need be. False if it was stopped.
  bool follow(const Samples& samples, Track& track, const GoOn& go_on);
  /// The same run once more, watched for events. False if it was stopped.
  bool find_events(const Samples& samples, Track& track, const GoOn& go_on);
  const World& world() const { return world_; }
  const Totals& start() const { return totals_; }
  /// Why its result does not count, "" if it does.
  std::string trouble() const;

 private:
  Scene scene_;
  World world_;
  Snapshot begin_;
  Totals totals_;
  std::uint64_t steps_;
};

}  // namespace ballpark::cost
