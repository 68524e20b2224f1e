// Scene files (target ballpark::scenes): load a TOML file, run it with its outputs, judge its expectations.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ballpark/options.h"
#include "ballpark/report.h"
#include "ballpark/scene.h"
#include "ballpark/state.h"
#include "ballpark/watch.h"
#include "ballpark/world.h"

namespace ballpark::scenes {

/// `--set key=value`: key is a path with tables addressed by name, else kind, else index ("bodies.balls.radius"); value
/// is TOML.
struct Override {
  std::string key, value;
};

/// [[output]]: the state over time into a file, whose ending says in which format.
struct OutputRequest {
  std::optional<double> every;  ///< [s]
  std::vector<double> at;       ///< [s]
  std::string file;
  std::vector<std::string> columns;  ///< "position", "velocity", ...; empty: all that bodies carry
  std::string precision;             ///< of the numbers: "single", "double"; "": as the format has it
};

/// [[event]]: the times at which a number of a body's state passes a value.
struct EventRequest {
  std::string name;      ///< unique, a word
  std::string quantity;  ///< state.ID.COLUMN
  double value = 0;
  std::string crossing = "any";  ///< "rising", "falling" or "any"
};

/// [[expect]]: a number of the run, and what it must be: [min, max], or value within tolerance (absolute).
struct Expectation {
  std::string quantity;      ///< a path in the run's JSON ("energy.drift_relative") or state.ID.COLUMN
  std::optional<double> at;  ///< [s]; the end if none
  std::optional<double> minimum, maximum, value, tolerance;
};

/// [[stress.owed]] and [[stress.shown]]: one way to run a hard case.
struct StressCell {
  std::string name;              ///< "": said by its integrator, contact and precision
  std::vector<std::string> set;  ///< KEY=VALUE, as `--set` takes them
  std::string refused;           ///< part of what the engine must say as it refuses the scene or reports the run
  std::string reported;          ///< part of what the run's status must say, while all expectations are met
};

/// [stress]: what makes a scene a hard case of `ballpark stress`.
struct StressRequest {
  std::string length = "quick";               ///< its class, "quick" or "long"
  std::string what;                           ///< one sentence: what is measured
  std::string waits_for;                      ///< a formulation that does not exist yet; "": it can be run
  std::vector<std::string> compare;           ///< what the run is compared with, of "threads", "targets", "resume", ...
  Vector3d shift = Vector3d::Zero();          ///< of "shift" [m]
  double from = 0;                            ///< of "start": the time to compare with [s]
  std::vector<double> frames = {1e-2, 1e-5};  ///< of "frame_pattern": lengths in turn [s]
  std::vector<StressCell> owed, shown;
};

/// Where a value stands. `file` is "--set" for an override; line 0: no such place.
struct Location {
  std::string file;
  std::size_t line = 0, column = 0;
};

struct SceneFile {
  std::string path;
  std::vector<std::string> body_files;  ///< what `file` of the body groups named, where it was read
  Scene scene;
  std::vector<OutputRequest> outputs;
  std::vector<EventRequest> events;
  std::vector<Expectation> expectations;
  std::optional<StressRequest> stress;
  std::map<std::string, Location> locations;  ///< by problem path: "bodies[0].mass"
};

struct LocatedProblem {
  Location location;
  std::string key, message;
};

/// Every problem of a scene file; what() has a line for each: "file:line:column: key: message".
class SceneFileError : public std::runtime_error {
 public:
  explicit SceneFileError(std::vector<LocatedProblem> problems);
  const std::vector<LocatedProblem>& problems() const { return problems_; }

 private:
  std::vector<LocatedProblem> problems_;
};

/// Reads and checks; nothing is run. Throws SceneFileError.
SceneFile load(const std::string& path, const std::vector<Override>& overrides = {});
/// The same from text, named `name` in messages.
SceneFile parse(const std::string& text, const std::string& name, const std::vector<Override>& overrides = {});

/// The scene file's keys as a JSON Schema, for editors; and as help text.
std::string json_schema();
std::string key_help();

/// An event in terms of a world.
struct BodyEvent {
  std::string name;
  std::size_t body = 0;                           ///< its id
  std::function<double(const BodyState&)> value;  ///< passes 0 at the event
  bool rising = true, falling = true;             ///< which ways of passing count
};
/// When an event was.
struct EventTimes {
  std::string name;
  std::uint64_t count = 0;
  std::vector<double> times = {};  ///< the first `most_event_times` [s]
  double last = 0;                 ///< [s]; 0 if there was none
};
inline constexpr std::size_t most_event_times = 1000;

/// The file's events. Throws SceneFileError if one names a quantity that no body's state has.
std::vector<BodyEvent> events_of(const SceneFile& file, const World& world);
/// For advance_watching: notes in `into` when the event is; all three must outlive it. A time that `into` has already
/// is not noted again.
Watch watch_for(const BodyEvent& event, const World& world, EventTimes& into);

/// Verdict on one expectation. A measured value that is not finite is never met.
struct Verdict {
  Expectation expectation;
  double measured = 0;
  double time = 0;  ///< at which it was measured [s]
  bool met = false;
  std::string sentence;
};

/// All that a run has to tell.
struct RunReport {
  std::string scenario;
  Status status;
  std::size_t bodies = 0;
  double time = 0;  ///< [s]
  Counters counters;
  std::string integrator;
  std::string contact;      ///< kind of formulation; "" if bodies do not touch
  double largest_step = 0;  ///< penalty: stable for the contacts of the run [s]; 0: none is
  double step = 0;          ///< [s]; 0: chosen by the tolerance
  double tolerance = 0;     ///< 0: the step was given
  double wall_seconds = 0;  ///< stepping only
  double body_steps_per_second = 0;
  int threads = 1;
  std::string precision, target, path;
  std::string state_hash;  ///< 16 hex digits
  Totals initial, final;
  double energy_drift_relative = 0;  ///< (final - initial) / largest of |initial|, |final|, initial and final kinetic
  double momentum_drift = 0;         ///< |dP| / largest sum of |p| at start or end
  double angular_momentum_drift = 0;
  std::vector<EventTimes> events;
  std::optional<Ledger> ledger;  ///< if it was asked for
  std::vector<std::string> warnings;
  std::vector<Verdict> verdicts;
  bool interrupted = false;
};

/// The report as the JSON of `ballpark run --json`.
std::string to_json(const RunReport& report);

/// A frame is due: called between steps with the world as it is.
using FrameWriter = std::function<void(const World&)>;
struct RunHooks {
  std::function<bool(double fraction)> progress;  ///< now and then; false interrupts
  std::vector<FrameWriter> writers;               ///< one for each of the file's outputs, in order
  FrameWriter last = {};                          ///< at the end of the run, wherever that is
  bool ledger = false;                            ///< keep the energy ledger
};

/// Builds the world, steps it to the scene's duration, samples outputs and expectations at the steps nearest to their
/// times, finds the times of events between steps, and judges. Throws SceneFileError if an expectation or an event
/// names a quantity that does not exist (before stepping).
RunReport run(const SceneFile& file, const Options& options = {}, const RunHooks& hooks = {});

}  // namespace ballpark::scenes
