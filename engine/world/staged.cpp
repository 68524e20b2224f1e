// The step of bodies that more acts on than local effects: for each phase of the integrator prepare, forces, evaluate.
#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

/// Small parts go through all of a step while they are in cache, each on one thread.
Moved World::staged_step(const Method& method, double from) {
  if (parts_.empty() || profiling_) return staged_passes(whole_, method, from);  // clocks are of passes
  workers_.for_each(parts_.size(), [&](std::size_t p) { moved_[p] = staged_passes(parts_[p], method, from); });
  return all_of(moved_);
}

Moved World::staged_passes(Part& part, const Method& method, double from) {
  if (penalty_) timed("keep_neighbours", [&] { penalty_->begin(groups_, from, method.step, workers_); });
  if (fixed_point_) {
    find_stages(part, method, from);
  } else {
    for (int phase = method.first_known ? 1 : 0; phase < method.phases; ++phase)
      staged_phase(part, method, phase, from);
  }
  const Moved moved = moving_pass(part, "finish", [&](const Group& group, const Block& block) {
    Finish* finish = kernels_of(group, method).finish[static_cast<int>(group.motion)];
    return finish(group.kernel, method, block.first, block.last);
  });
  if (penalty_) {
    timed("finish_contacts", [&] { penalty_->finish(groups_, method, workers_); });
    if (!adaptive_) watch_contact_stiffness();
  }
  return moved;
}

void World::staged_phase(const Part& part, const Method& method, int phase, double from) {
  pass(part, "prepare", [&](const Group& group, const Block& block) {
    Prepare* prepare = kernels_of(group, method).prepare[static_cast<int>(group.motion)];
    prepare(group.kernel, method, phase, block.first, block.last);
  });
  sum_forces(part, method, phase, from + method.offset[phase]);
  pass(part, "evaluate", [&](const Group& group, const Block& block) {
    kernels_->evaluate[static_cast<int>(group.motion)](group.kernel, method, phase, block.first, block.last);
  });
}

/// Force and torque from user effects, effects between bodies and contacts, for the evaluation that follows, into sums
/// that prepare has cleared.
void World::sum_forces(const Part& part, const Method& method, int phase, double time) {
  if (!users_.empty()) {
    pass(part, "user_effects", [&](const Group& group, const Block& block) {
      if (!group.users.empty()) run_users(group, block, time);
    });
  }
  Workers& workers = &part == &whole_ ? workers_ : one_thread_;
  for (PairSystem& system : pair_systems_) {
    timed(system.name(), [&] { system.add_forces(groups_, part.copies, workers); });
  }
  if (penalty_) timed("press_contacts", [&] { penalty_->add_forces(groups_, method, phase, time, workers_); });
}

/// Rows of a group as a user effect sees them, but for the time.
BodyBlock<Real> World::block_of(const Group& group, const StateColumns& columns, const Block& block) {
  const StepGroup& k = group.kernel;
  BodyBlock<Real> view;
  view.count = block.last - block.first;
  view.mass = k.constants.mass.rows + block.first;
  for (int c = 0; c < 3; ++c) {
    view.position[c] = columns.position[c] + block.first;
    view.velocity[c] = columns.velocity[c] + block.first;
    view.force[c] = group.force_sums[c] + block.first;
    if (!k.trial_spin[0]) continue;
    view.angular_velocity[c] = k.trial_spin[c] + block.first;
    view.torque[c] = group.torque_sums[c] + block.first;
  }
  if (columns.orientation[0]) {
    for (int c = 0; c < 4; ++c) view.orientation[c] = columns.orientation[c] + block.first;
  }
  return view;
}

void World::run_users(const Group& group, const Block& block, double time) {
  BodyBlock<Real> view = block_of(group, group.kernel.trial, block);
  view.time = time;
  for (const std::size_t user : group.users) run_user(users_[user], view);
}

}  // namespace ballpark::BALLPARK_PRECISION
