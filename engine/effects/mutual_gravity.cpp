#include "engine/effects/mutual_gravity.h"

#include <algorithm>
#include <vector>

#include "engine/core/aligned_array.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

constexpr std::size_t task_slots = 128;
constexpr std::size_t small_scene = 1 << 14;  // pairs below which one thread is faster than two
constexpr int flops_of_pair = 18;

}  // namespace

MutualGravity::MutualGravity(const PairInput& input)
    : strength_(input.effect.number("strength")),
      softening_(input.effect.number("softening")),
      kernels_(input.kernels),
      count_(input.bodies.count),
      masses_(input.bodies.mass, input.bodies.mass + input.bodies.count) {}

/// For bodies [first, last) of each of these copies; their slots end at `end`.
MutualGravity::Task MutualGravity::task_of(const PairBodies& bodies, const CopyRange& range, std::size_t first,
                                           std::size_t last, std::size_t end) const {
  const std::size_t start = range.first * count_;
  Task task{{{}, bodies.mass + start, count_, range.last - range.first, end - start, strength_, 0},
            start,
            first,
            last,
            range.first < bodies.woven};
  task.of.softening_squared = softening_ * softening_;
  for (int c = 0; c < 3; ++c) task.of.position[c] = bodies.position[c] + start;
  return task;
}

/// A task is some whole copies, which begin with a cache line, or a part of one; so each has slots for a vector. Woven
/// copies and those behind them are tasks apart.
template <class Act>
void MutualGravity::for_tasks(const PairBodies& bodies, Workers& workers, Act act) const {
  const std::size_t parts = std::max<std::size_t>(1, count_ / task_slots);  // the last one takes what is left
  const std::size_t copies = bodies.copies.last - bodies.copies.first;
  if (copies == 1 && parts == 1) {  // divisions would take as long as the pull of few bodies
    return act(task_of(bodies, bodies.copies, 0, count_, bodies.end));
  }
  const std::size_t length = parts > 1 ? 1 : woven_width * std::max<std::size_t>(1, task_slots / woven_width / count_);
  const std::size_t woven = std::clamp(bodies.woven, bodies.copies.first, bodies.copies.last) - bodies.copies.first;
  const std::size_t woven_tasks = (woven + length - 1) / length;
  const auto task = [&](std::size_t t) {
    const bool is_woven = t < woven_tasks;
    const std::size_t rest = t - woven_tasks, begin = is_woven ? t * length : woven + rest / parts * length;
    const std::size_t end = std::min(begin + length, is_woven ? woven : copies), part = is_woven ? 0 : rest % parts;
    const std::size_t first = part * task_slots, last = part + 1 < parts ? first + task_slots : count_;
    const CopyRange range{bodies.copies.first + begin, bodies.copies.first + end};
    const bool ends = end == copies && last == count_;
    act(task_of(bodies, range, first, last, ends ? bodies.end : (range.last - 1) * count_ + last));
  };
  const bool small = copies * count_ * count_ < small_scene;
  const std::size_t tasks = woven_tasks + (copies - woven + length - 1) / length * parts;
  workers.for_each(tasks, task, small ? 1 : workers.threads());
}

void MutualGravity::add_forces(const PairBodies& bodies, Workers& workers) {
  for_tasks(bodies, workers, [&](const Task& task) {
    Real* const force[3] = {bodies.force[0] + task.start, bodies.force[1] + task.start, bodies.force[2] + task.start};
    if (task.woven) return kernels_.attract_woven(task.of, force);
    kernels_.attract(task.of, task.first, task.last, force);
  });
}

double MutualGravity::energy(const PairBodies& bodies, Workers& workers) {
  std::vector<Real> energies(bodies.end);
  for_tasks(bodies, workers, [&](const Task& task) {
    Real* of_task = energies.data() + task.start;
    if (task.woven) return kernels_.woven_attraction_energy(task.of, of_task);
    kernels_.attraction_energy(task.of, task.first, task.last, of_task);
  });
  double sum = 0;
  for (const Real energy : energies) sum += static_cast<double>(energy);
  return sum;
}

LinkForce MutualGravity::force_of(std::size_t, const Link& link, const Vector3<Real>& apart,
                                  const Vector3<Real>&) const {
  using V = Dual<6>;
  const LinkForce r = as_variables(apart, 0);
  const V square = dot(r, r) + V(softening_ * softening_), zero = V(Real(0));
  const V pull = V(strength_ * masses_[link.a] * masses_[link.b]) / (square * square_root(square));
  return select(square > zero, -pull, zero) * r;
}

PairCost MutualGravity::cost() const {
  return {static_cast<double>(7 * sizeof(Real)), static_cast<double>(flops_of_pair) * static_cast<double>(count_)};
}

EffectDescription MutualGravity::description() {
  return {
      .name = "mutual_gravity",
      .doc = "inverse-square attraction of all bodies by each other, F = G m_i m_j r / (r^2 + s^2)^(3/2), r to j",
      .source = "Newton, Principia III; G of CODATA 2018; softening after Plummer 1911",
      .parameters = {{.name = "strength", .unit = "m^3/(kg s^2)", .fallback = 6.6743e-11, .doc = "G; negative repels"},
                     {.name = "softening", .unit = "m", .fallback = 0.0, .minimum = 0, .doc = "s"}},
      .reads = {"position"},
      .exerts = {"force"},
      .has_energy = true,
      .flops = flops_of_pair,
      .between_bodies = true};
}

}  // namespace ballpark::BALLPARK_PRECISION
