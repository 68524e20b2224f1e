// What `ballpark cost` finds: every way to run a scene that was tried, how wrong it was and how long it took.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ballpark/scene.h"
#include "perf/cost/event_times.h"
#include "perf/cost/statistics.h"

namespace ballpark::cost {

/// Not named where a setting is told.
inline constexpr const char* usual_rotation = "renormalise";

/// How bodies touch.
struct ContactChoice {
  std::string kind = {};             ///< of the formulation; "": they do not, or as the scene has it
  int iterations = 0, substeps = 0;  ///< of impulse contacts, else 0
  double stiffness = 0;              ///< of penalty contacts [N/m], else 0

  bool operator==(const ContactChoice&) const = default;
};

/// One way to run a scene.
struct Setting {
  std::string integrator;
  double step = 0;       ///< [s]; 0: as `tolerance` allows
  double tolerance = 0;  ///< 0: the step is given
  Precision precision = Precision::double_;
  ContactChoice contact = {};
  std::string rotation = {};  ///< how bodies turn; "" where none does
  double opening_angle = -1;  ///< of the tree of mutual_gravity [rad]; 0: every pair; -1: too few bodies for one

  bool operator==(const Setting&) const = default;
};
/// Do they differ by their step or tolerance alone?
bool same_curve(const Setting& a, const Setting& b);

/// What is held against the reference: positions [m], velocities [m/s], orientations as angles [rad], spins [rad/s].
enum class Quantity { position, velocity, orientation, spin };
inline constexpr std::size_t quantity_count = 4;
const char* name(Quantity quantity);
const char* unit(Quantity quantity);

/// Distance from the reference, of the body that is farthest off (rms: over bodies and times).
struct Distance {
  double end = 0;      ///< at the end of the run
  double maximum = 0;  ///< along the path, the end included
  double rms = 0;      ///< along the path
};

struct Errors {
  std::array<Distance, quantity_count> of{};  ///< by Quantity
  double energy = 0;                          ///< |change| over the largest energy along the path; conserved or not
  double momentum = 0;                        ///< |change| over the largest sum of |p|
  double angular_momentum = 0;                ///< |change| over the largest sum of |l|
  double quaternion_norm = 0;                 ///< largest | |q| - 1 |
  double penetration = 0;                     ///< deepest overlap [m]
  EventErrors events;
  const Distance& operator[](Quantity q) const { return of[static_cast<std::size_t>(q)]; }
  Distance& operator[](Quantity q) { return of[static_cast<std::size_t>(q)]; }
};

/// Wall time of whole runs [s].
struct Seconds {
  double minimum = 0, median = 0, maximum = 0;
  int runs = 0;
};

/// A setting that was run.
struct Point {
  Setting setting;
  std::size_t curve = 0;  ///< settings that differ by their step or tolerance alone
  Errors errors;
  double error = 0;      ///< the one of Result::measure
  bool claimed = false;  ///< far enough above the reference's own error
  bool front = false;    ///< on the Pareto front: none is as accurate and faster
  Seconds seconds;
  std::uint64_t steps = 0, rejected_steps = 0, force_evaluations = 0;
  std::string state_hash;
  std::string trouble;  ///< why it does not count ("a step of ... exceeds ..."); "" if it does
};

/// Settings that differ by their step or tolerance alone: indices of their points, by falling step.
struct Curve {
  std::string label;  ///< "rk4", "rk4, single"
  std::string integrator, family;
  int order = 0;
  Precision precision = Precision::double_;
  std::vector<std::size_t> points;
};

struct Reference {
  std::string kind;  ///< "closed form", "extrapolation in extended precision", "two finest runs"
  std::string what;  ///< "Kepler's equation (Danby, Fundamentals of Celestial Mechanics, 6)"
  std::array<double, quantity_count> error_bar{};  ///< of itself
  std::array<double, quantity_count> scale{};      ///< largest value along the path
  double event_bar = 0;                 ///< of the times of events [s]; infinite: it is not sure of their count
  std::optional<Setting> setting = {};  ///< that it was run with, if it was run
  double seconds = 0;                   ///< that this took
};

/// Errors of trajectories mean something up to `time` [s].
struct Horizon {
  double time = 0, lyapunov_time = 0, uncertainty = 0;
  double growth = 1;  ///< of the distance of twins until then
  std::string sentence;
};

/// What is seen of every copy of an ensemble at its end.
struct Observable {
  std::string name, unit;
};

/// Runs of one setting that start a little apart.
struct EnsembleRuns {
  Setting setting;
  double seconds = 0;            ///< a run, measured once
  std::vector<Mean> means = {};  ///< by observable
  std::vector<Difference> from_reference = {};
};

/// Beyond the horizon: what means over runs tell, as no path does.
struct Ensemble {
  int copies = 0;
  double perturb = 0, time = 0;  ///< relative change of the start; when it is looked at [s]
  std::vector<Observable> observables;
  EnsembleRuns reference;
  std::string why_reference;  ///< "the most accurate inside the horizon"
  std::vector<EnsembleRuns> settings;
};

/// The cheapest setting that is accurate enough, or the most accurate that is cheap enough.
struct Recommendation {
  std::size_t point = 0;
  double limit = 0;            ///< what was asked for: an error, or seconds a simulated second
  double margin = 1;           ///< the error was to be so many times smaller
  double confirmed_error = 0;  ///< of a run of its own
  std::string sentence;
};

/// A path to be drawn: of body `body`, by a setting or by the reference.
struct Path {
  std::string label;
  std::size_t body = 0;
  std::vector<std::array<double, 4>> points;  ///< t, x, y, z
};

struct Result {
  std::string scenario, doc, machine, command;
  std::size_t bodies = 0, compared = 0;  ///< bodies whose paths were held against the reference
  double duration = 0;                   ///< [s]
  int threads = 1;
  Quantity quantity = Quantity::position;
  std::string which = "maximum";      ///< of the quantity's distances: "end", "maximum" or "rms"
  std::string measure, measure_unit;  ///< "largest position error along the path, of all bodies", "m"
  Reference reference;
  std::vector<scenes::EventTimes> events;  ///< of the reference
  std::vector<std::string> remarks;        ///< what else errors hold, and what was taken for it
  double floor = 0;                        ///< no error below this is claimed: ten times the reference's own
  double ceiling = 0;                      ///< larger errors are no answer: a tenth of how far things go
  std::optional<Horizon> horizon;
  std::optional<Ensemble> ensemble;
  std::vector<Curve> curves;
  std::vector<Point> points;
  std::vector<std::string> crossovers;
  std::vector<std::string> left_out;  ///< what was not tried, or does not count, and why
  std::optional<Recommendation> recommended;
  std::optional<Setting> scene_setting;  ///< as the scene file has it
  std::vector<Path> paths;

  /// No smaller error of an event's time is claimed [s].
  double event_floor() const { return 10 * reference.event_bar; }
};

}  // namespace ballpark::cost
