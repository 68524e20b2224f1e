// A scene being simulated. Build once, step many times, read without copies.
//
//   ballpark::World world(scene);
//   world.step(1000);
//   ballpark::View<double> x = world.view<double>("position");
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ballpark/options.h"
#include "ballpark/report.h"
#include "ballpark/scene.h"
#include "ballpark/state.h"
#include "ballpark/user_effect.h"

namespace ballpark {

class WorldInterface;

/// A tenth of the largest step at which the scene's springs, dampers and penalty contacts are stable under its
/// integrator, shortened so that whole steps fill the duration [s]. Throws SceneError if nothing limits the step, or no
/// step is stable.
double automatic_step(const Scene& scene);

class World {
 public:
  /// Builds columns and passes. Throws SceneError with every problem of the scene, before anything is allocated.
  explicit World(const Scene& scene, const Options& options = {}, std::vector<UserEffect> user_effects = {});
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// n whole steps of the scene's step; with a tolerance, n accepted ones. Never throws; what goes wrong is in
  /// status().
  void step(std::uint64_t n = 1);
  /// Whole steps while the next one does not pass t (to 1e-9 of a step); the remainder is kept for the next call. With
  /// a tolerance: to t exactly, unless no step is small enough (Status::Code::accuracy). No more than `most_steps`.
  void advance_to(double t, std::uint64_t most_steps = std::numeric_limits<std::uint64_t>::max());
  /// Steps of a run to `end`, as advance_to(end) takes them, while the next one does not pass t. True once it would, or
  /// t is reached: then look_ahead(t) shows the world at t. False after `most_steps`, or where no step is small enough.
  bool approach(double t, double end, std::uint64_t most_steps = std::numeric_limits<std::uint64_t>::max());
  /// Calls `look`, for which the world is as it will be at t (for one where no step is small enough: where it ends). It
  /// gets there aside, by steps of the same method, and returns with every bit: the run takes its steps as if nobody
  /// had looked. Costs these steps, mostly one, and a copy of the state. Throws SceneError if t is over, and what look
  /// does.
  void look_ahead(double t, const std::function<void()>& look);
  double time() const;  ///< t0 + n h [s], never a running sum; with a tolerance, the compensated sum of steps
  std::uint64_t steps() const;
  const Status& status() const;
  Counters counters() const;

  std::size_t body_count() const;            ///< over all copies
  std::size_t row_of(std::size_t id) const;  ///< row of a body in every view; throws std::out_of_range
  /// Names: "position", "velocity", "orientation" (w, x, y, z), "angular_momentum" (about the centre of mass, or the
  /// pivot), or "body_angular_momentum" (in the body's axes, of groups that carry it so: run.rotation = "body"). Throws
  /// SceneError if the column does not exist or Real is not the world's precision.
  template <class Real>
  View<Real> view(const std::string& column) const;
  /// A value that is equal over a group ("mass", "radius"); throws SceneError if it is a column or absent.
  double constant(const std::string& name, const std::string& group) const;
  BodyState body(std::size_t id) const;

  /// Changes of one body between steps. Throw SceneError on an unknown id, a value that is not finite, or what the
  /// group does not carry.
  void set(std::size_t id, const BodyState& state);
  /// J [N s] at `offset` from the centre of mass [m]; at once, or at a later time [s].
  void apply_impulse(std::size_t id, const Vector3d& J, const Vector3d& offset = Vector3d::Zero());
  void apply_impulse_at(double at, std::size_t id, const Vector3d& J, const Vector3d& offset = Vector3d::Zero());
  /// F [N], torque [N m], world frame, from `at` until `until` [s]. Steps are split at both times.
  void apply_force(std::size_t id, const Vector3d& F, double at, double until);
  void apply_torque(std::size_t id, const Vector3d& torque, double at, double until);

  /// Contacts of each body, by id, and their force; found when asked for, which changes no bit of the motion.
  /// `penalty`: now. `impulse`: those of the last substep, with their mean force in it; impacts, which take no time,
  /// are no force. Throws SceneError where bodies do not touch.
  std::vector<ContactLoad> contact_loads() const;
  Totals totals() const;  ///< energy and momenta now; one pass over all bodies
  /// Opens the energy ledger, or closes it. Steps take several times as long while it is open, and end in the same
  /// bits. A snapshot holds it; restore() of one that does not opens it anew.
  void keep_ledger(bool on);
  Ledger ledger() const;             ///< throws SceneError if it is closed
  std::uint64_t state_hash() const;  ///< over the state columns, by id
  Explanation explain() const;
  Snapshot snapshot() const;
  void restore(const Snapshot& snapshot);

  void profile(bool on);  ///< clears and starts, or stops, the pass clocks
  std::vector<PassTime> pass_times() const;
  Precision precision() const;
  std::string target() const;
  int threads() const;

 private:
  std::unique_ptr<WorldInterface> world_;
};

}  // namespace ballpark
