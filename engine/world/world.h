// A scene as columns and passes. build.cpp decides what exists, step.cpp moves it, the other files of this folder read.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/clock.h"
#include "engine/core/flush_denormals.h"
#include "engine/core/workers.h"
#include "engine/effects/step_effect.h"
#include "engine/integrators/rows.h"
#include "engine/integrators/step_control.h"
#include "engine/kernels/exponential_motion.h"
#include "engine/store/columns.h"
#include "engine/world/contact_step.h"
#include "engine/world/fixed_point.h"
#include "engine/world/group.h"
#include "engine/world/implicit_step.h"
#include "engine/world/inertia.h"
#include "engine/world/interface.h"
#include "engine/world/kernel_table.h"
#include "engine/world/ledger.h"
#include "engine/world/pair_system.h"

namespace ballpark::BALLPARK_PRECISION {

class World : public WorldInterface {
 public:
  World(const Scene& scene, const Options& options, std::vector<UserEffect> user_effects);

  void step(std::uint64_t n) override;
  void advance_to(double t, std::uint64_t most_steps) override;
  bool approach(double t, double end, std::uint64_t most_steps) override;
  void look_ahead(double t, FunctionRef<void()> look) override;
  double step_size() const override { return adaptive_ ? control_.step : step_; }
  double time() const override {
    return adaptive_ ? elapsed_.time : static_cast<double>(counters_.steps) * step_ + part_;
  }
  const Status& status() const override { return status_; }
  Counters counters() const override;
  std::size_t body_count() const override { return per_copy_ * copies_; }
  std::size_t row_of(std::size_t id) const override;
  RawView view(const std::string& column) const override;
  double constant(const std::string& name, const std::string& group) const override;
  BodyState body(std::size_t id) const override;
  void set(std::size_t id, const BodyState& state) override;
  void apply_impulse(std::size_t id, const Vector3d& J, const Vector3d& offset) override;
  void schedule_impulse(const Impulse& impulse) override;
  void apply_load(const std::string& kind, std::size_t id, const Vector3d& load, double at, double until) override;
  std::vector<ContactLoad> contact_loads() const override;
  Totals totals() const override;
  void keep_ledger(bool on) override;
  Ledger ledger() const override;
  std::uint64_t state_hash() const override;
  Explanation explain() const override;
  Snapshot snapshot() const override;
  void restore(const Snapshot& snapshot) override;
  void profile(bool on) override;
  std::vector<PassTime> pass_times() const override { return pass_times_; }
  Precision precision() const override;
  std::string target() const override { return kernels_->target; }
  int threads() const override { return workers_.threads(); }

 private:
  friend class Builder;
  struct Place {
    std::size_t group, row;  ///< row in the group
  };

  // step.cpp
  void run(std::uint64_t most_steps, double until);
  int steps_at_once(std::uint64_t most) const;
  void many_steps(int n);
  void one_step();
  void part_of_step(double length);
  void advance(double from, double h);
  void take_effect(const Event& event);
  Moved smooth_motion(const Method& method, double from);
  Method method_over(double h) const;
  // between_steps.cpp
  struct BetweenSteps {
    const StepEffectInfo* info;
    std::unique_ptr<StepEffect> effect;
    std::vector<std::size_t> groups;
    const char* name() const { return info->description.name.c_str(); }
    bool acts_on(std::size_t group) const;
  };
  void act_between_steps();
  struct Crossings {
    std::uint64_t entered = 0, left = 0;
  };
  void act_between(const BetweenSteps& between, const EndedStep& step);
  void report_full(const BetweenSteps& between, const EndedStep& step);
  void explain_between_steps(std::vector<PassReport>& passes) const;

  // implicit_step.cpp
  Moved implicit_step(const Method& method);
  void count_iterations(const StageTally& tally, int stages);
  void report_unconverged(const StageTally& tally);
  void contact_substeps(double from, double h);
  void watch_contact_stiffness();
  // stability.cpp
  void judge_contacts(const Stiffness& of_contacts);
  Stiffness beside_contacts() const;
  StepLimit limit_of(const Stiffness& per_mass) const;
  void activate_windows(double from, double h);
  void set_time(double from);
  const FamilyKernels& kernels_of(const Group& group, const Method& method) const;
  Moved fused_pass(const Method& method, int steps);
  template <class Action>
  void timed(const char* name, Action action);
  template <class Task>
  void pass(const Part& part, const char* name, Task task);
  template <class Move>
  Moved moving_pass(Part& part, const char* name, Move move);
  void record(const char* name, double seconds);
  void report_non_finite(const Moved& moved);
  void add_event(const Event& event);

  // staged.cpp
  Moved staged_step(const Method& method, double from);
  Moved staged_passes(Part& part, const Method& method, double from);
  void staged_phase(const Part& part, const Method& method, int phase, double from);
  void sum_forces(const Part& part, const Method& method, int phase, double time);
  void run_users(const Group& group, const Block& block, double time);
  static BodyBlock<Real> block_of(const Group& group, const StateColumns& columns, const Block& block);

  // look_ahead.cpp
  void go_aside(double t);
  void return_to(const Snapshot& snapshot);

  // ledger.cpp
  bool books() const { return book_ && looks_ == 0; }
  EnergyReading read_energy() const;
  void booked_step(double until);
  void book_path(double from, double to);
  double power_of_user(std::size_t user) const;
  template <class Act>
  void booked_jump(ExactSum LedgerBook::*cause, Act act);

  // fixed_point.cpp
  Moved fixed_point_step(const Method& method, double from);
  void find_stages(const Part& part, const Method& method, double from);
  StepLimitReport hardest_to_iterate() const;
  std::string how_solved() const;

  // adaptive.cpp
  void adaptive_step(double limit);
  double overstep();
  void due_events();
  void accept_try();
  void keep_carries();
  void take_back();
  void get_stuck(bool finite);
  double planned_step();
  double first_step();
  void evaluate_start();

  // kept_rates.cpp
  void turn_rates();
  void arrange_rates();
  void forget_rates();
  std::vector<double> pace() const;
  std::size_t load_count() const;
  void set_pace(const std::vector<double>& pace);

  // bodies.cpp
  std::uint64_t structure() const;
  Place place_of(std::size_t id) const;
  Place known_place(std::size_t id, const char* call) const;
  Place place_to_change(std::size_t id, const char* call) const;
  void put(const Place& place, const BodyState& state, const BodyState& now);
  void kick(const Place& place, const Vector3d& J, const Vector3d& offset);
  std::size_t id_of(const Group& group, std::size_t row) const;

  Columns columns_;
  std::vector<Real> before_;   ///< scratch: the state when many steps at once began
  std::vector<Group> groups_;  ///< by row; those that carry more columns last
  Part whole_;                 ///< all copies
  std::vector<Moved> moved_;   ///< of each part
  std::vector<Part> parts_;    ///< staged path: what goes through a step on its own; none: pass by pass, all bodies
  Workers one_thread_{1};      ///< of a part among others
  std::vector<UserEffect> users_;
  mutable std::vector<PairSystem> pair_systems_;  ///< whose slots are scratch
  std::vector<BetweenSteps> between_steps_;
  std::vector<std::string> narrowed_;
  std::vector<Event> events_;  ///< by time
  std::size_t next_event_ = 0;
  const Row* row_ = nullptr;
  RotationRule rotation_ = RotationRule::renormalise;
  Method method_;
  Method starter_;                 ///< multistep: of its first steps
  int known_sets_ = 0;             ///< multistep: rates of earlier steps at hand
  std::vector<std::size_t> ring_;  ///< sets of rates that take turns
  std::size_t turns_ = 0;          ///< how often kept rates took the place of older ones, see arrange_rates
  bool adaptive_ = false;          ///< steps as large as run.tolerance allows
  Method unit_;                    ///< adaptive: for a step of 1 s
  StepControl control_;
  Elapsed elapsed_;
  bool keeps_rates_ = false;               ///< adaptive: the last phase of a step serves as the first of the next
  bool stuck_ = false;                     ///< adaptive: no step is small enough
  Method contact_method_;                  ///< of a substep between contacts
  std::unique_ptr<ContactStep> contacts_;  ///< none: bodies do not touch
  ImpulseStep* impulse_ = nullptr;         ///< contacts_, as what it is
  PenaltyStep* penalty_ = nullptr;
  std::unique_ptr<ImplicitStep> implicit_;   ///< none: the method is explicit, or iterates
  std::unique_ptr<FixedPoint> fixed_point_;  ///< none: no need to iterate
  std::string not_differentiated_;           ///< why stages are iterated; "": they are not
  double step_ = 0, duration_ = 0;
  double part_ = 0;                   ///< of a step, where a look has gone [s]
  int looks_ = 0;                     ///< one in the other: how many this is the state of
  std::unique_ptr<LedgerBook> book_;  ///< none: no ledger is kept
  bool fused_ = true;
  std::string path_reason_;
  std::size_t per_copy_ = 0, copies_ = 1;
  Counters counters_;
  Status status_;
  std::vector<std::pair<std::string, Stiffness>> stiffnesses_;  ///< per mass, of groups and of what is between them
  Stiffness watched_stiffness_;  ///< of contacts, per mass: the most that was held against the step
  mutable Workers workers_;
  const KernelTable* kernels_ = nullptr;
  bool profiling_ = false;
  std::vector<PassTime> pass_times_;
  std::vector<double> bytes_per_call_;  ///< of the passes in pass_times_
};

/// What happens at once goes into the ledger, if one is kept.
template <class Act>
void World::booked_jump(ExactSum LedgerBook::*cause, Act act) {
  if (!books()) return act();
  const EnergyReading before = read_energy();
  act();
  book_->add_jump(before, read_energy(), cause);
}

/// Are those of the block's bodies finite that are there?
bool all_finite(const Group& group, const Block& block);

/// Runs the action, timed if asked for.
template <class Action>
void World::timed(const char* name, Action action) {
  const double begin = profiling_ ? seconds_now() : 0;
  action();
  if (profiling_) record(name, seconds_now() - begin);
}

/// One sweep over all blocks of the part, timed if asked for.
template <class Task>
void World::pass(const Part& part, const char* name, Task task) {
  const auto run = [&](std::size_t b) {
    const Block& block = part.blocks[b];
    task(groups_[block.group], block);
  };
  timed(name, [&] {
    if (!part.alone) return workers_.for_each(part.blocks.size(), run);
    const FlushDenormals flush;
    for (std::size_t b = 0; b < part.blocks.size(); ++b) run(b);
  });
}

/// Extended precision refuses user effects.
template <class R>
void run_user(const UserEffect& effect, const BodyBlock<R>& block) {
  if constexpr (std::is_same_v<R, float>) effect.run_single(block);
  if constexpr (std::is_same_v<R, double>) effect.run_double(block);
}

/// What the parts of a sweep tell, together.
inline Moved all_of(const std::vector<Moved>& parts) {
  Moved all;
  for (const Moved& part : parts) {
    all.finite = all.finite && part.finite;
    all.over = std::max(all.over, part.over);
  }
  return all;
}

/// A sweep that moves the bodies by move(group, block).
template <class Move>
Moved World::moving_pass(Part& part, const char* name, Move move) {
  pass(part, name, [&](const Group& group, const Block& block) {
    Moved& moved = part.moved[static_cast<std::size_t>(&block - part.blocks.data())];
    moved = group.presence.empty(block.first, block.last) ? Moved() : move(group, block);
    if (group.presence && !moved.finite) moved.finite = all_finite(group, block);
  });
  return all_of(part.moved);
}

/// Calls f with the type of a motion that groups carry, as `f.template operator()<M>()`.
template <class F>
decltype(auto) with_carried(MotionKind kind, F&& f) {
  switch (kind) {
    case MotionKind::spinning:
      return f.template operator()<FreeMotion<Spin::carried>>();
    case MotionKind::oriented:
      return f.template operator()<FreeMotion<Spin::oriented>>();
    case MotionKind::rigid:
      return f.template operator()<FreeMotion<Spin::rigid>>();
    case MotionKind::pivoted:
      return f.template operator()<PivotedMotion>();
    case MotionKind::body_frame:
      return f.template operator()<FreeMotion<Spin::body>>();
    default:
      return f.template operator()<FreeMotion<Spin::none>>();
  }
}

/// Likewise, of any that steps.
template <class F>
decltype(auto) with_motion(MotionKind kind, F&& f) {
  switch (kind) {
    case MotionKind::oriented_exponential:
      return f.template operator()<ExponentialMotion<FreeMotion<Spin::oriented>>>();
    case MotionKind::rigid_exponential:
      return f.template operator()<ExponentialMotion<FreeMotion<Spin::rigid>>>();
    case MotionKind::pivoted_exponential:
      return f.template operator()<ExponentialMotion<PivotedMotion>>();
    default:
      return with_carried(kind, f);
  }
}

/// What a group's column of angular momentum holds of a body that turns with `spin` (world frame) at an orientation:
/// L about its centre of mass or its pivot, world frame, or in the body's axes where they carry it.
Vector3<Wide> momentum_for(const Group& group, std::size_t row, const Quaternion& orientation,
                           const Vector3<Wide>& spin);
/// Position and velocity of a pivoted body follow from its rotation: writes them.
void place_pivoted(const Group& group, std::size_t row);
/// Is every value of the body's state finite? `row` in the group.
bool is_finite(const Group& group, std::size_t row);
/// In the state, as effects see it.
Body<Real> body_at(const Group& group, std::size_t row);

const char* name(MotionKind kind);
/// Of the column that holds angular momenta in the bodies' own axes.
inline constexpr const char* body_momentum = "body_angular_momentum";
/// Number of values of state that the motion integrates.
int state_size(MotionKind kind);
/// nullptr if this build or machine has no such target.
const KernelTable* kernel_table(const std::string& target);

}  // namespace ballpark::BALLPARK_PRECISION
