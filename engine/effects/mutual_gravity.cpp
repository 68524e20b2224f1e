#include "engine/effects/mutual_gravity.h"

#include <algorithm>
#include <vector>

#include "engine/core/aligned_array.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

constexpr std::size_t task_slots = 128;
constexpr std::size_t small_scene = 1 << 14;  // pairs below which one thread is faster than two
constexpr int flops_of_pair = 18;
constexpr std::size_t task_groups = 8;
constexpr double cell_share = 52.0 / flops_of_pair;  // of a cell's arithmetic
constexpr std::size_t tree_bytes = 40;               // of a body's key and its share in the cells

}  // namespace

MutualGravity::MutualGravity(const PairInput& input)
    : strength_(input.effect.number("strength")),
      softening_(input.effect.number("softening")),
      kernels_(input.kernels),
      count_(input.bodies.count),
      masses_(input.bodies.mass, input.bodies.mass + input.bodies.count) {
  const Real opening_angle = input.effect.number("opening_angle");
  if (opening_angle > 0 && count_ >= GravityTree::fewest) {
    for (std::size_t copy = 0; copy < input.bodies.copies.last; ++copy) trees_.emplace_back(opening_angle);
  }
  measure(input);
}

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

/// act(pull, tree, group, first slot) for all groups of these copies' trees, which are made anew.
template <class Act>
void MutualGravity::for_groups(const PairBodies& bodies, Workers& workers, Act act) {
  for (std::size_t copy = bodies.copies.first; copy < bodies.copies.last; ++copy) {
    GravityTree& tree = trees_[copy];
    const std::size_t start = copy * count_;
    const Real* const position[3] = {bodies.position[0] + start, bodies.position[1] + start,
                                     bodies.position[2] + start};
    tree.build(position, bodies.mass + start, count_);
    const std::size_t tasks = (tree.groups().size() + task_groups - 1) / task_groups;
    workers.for_each(tasks, [&](std::size_t t) {
      GravityTree::Sources sources;
      const std::size_t end = std::min((t + 1) * task_groups, tree.groups().size());
      for (std::size_t g = t * task_groups; g < end; ++g) {
        const GravityTree::Group& group = tree.groups()[g];
        sources.clear();
        tree.find_sources(group, sources);
        Pull pull{.position = {},
                  .bodies = group.last - group.first,
                  .points = {},
                  .point_count = sources.points[0].size(),
                  .cells = {},
                  .cell_count = sources.cells[0].size(),
                  .softening_squared = softening_ * softening_};
        for (int c = 0; c < 3; ++c) pull.position[c] = tree.place(c, group.first);
        for (int k = 0; k < 4; ++k) pull.points[k] = sources.points[k].data();
        for (int k = 0; k < 10; ++k) pull.cells[k] = sources.cells[k].data();
        act(pull, tree, group, start);
      }
    });
  }
}

/// Of the bodies at the start.
void MutualGravity::measure(const PairInput& input) {
  double pairs = static_cast<double>(count_), bytes = 7 * sizeof(Real);
  if (!trees_.empty()) {
    PairBodies one = input.bodies;
    one.copies = {0, 1};
    std::vector<double> of_body(count_);
    for_groups(one, input.workers,
               [&](const Pull& pull, const GravityTree&, const GravityTree::Group& group, std::size_t) {
                 const double sources =
                     static_cast<double>(pull.point_count) + cell_share * static_cast<double>(pull.cell_count);
                 for (std::size_t i = group.first; i < group.last; ++i) of_body[i] = sources;
               });
    pairs = 0;
    for (const double of_one : of_body) pairs += of_one / static_cast<double>(count_);
    bytes += 2 * (4 * sizeof(Real) + tree_bytes);
  }
  cost_ = {bytes, flops_of_pair * pairs};
}

void MutualGravity::add_forces(const PairBodies& bodies, Workers& workers) {
  if (!trees_.empty()) {
    return for_groups(
        bodies, workers,
        [&](const Pull& pull, const GravityTree& tree, const GravityTree::Group& group, std::size_t start) {
          alignas(cache_line) Real columns[3][GravityTree::group_size + cache_line];
          Real* const acceleration[3] = {columns[0], columns[1], columns[2]};
          kernels_.pull(pull, acceleration);
          for (std::size_t i = 0; i < pull.bodies; ++i) {
            const std::size_t slot = start + tree.slot(group.first + i);
            for (int c = 0; c < 3; ++c) bodies.force[c][slot] += (strength_ * bodies.mass[slot]) * columns[c][i];
          }
        });
  }
  for_tasks(bodies, workers, [&](const Task& task) {
    Real* const force[3] = {bodies.force[0] + task.start, bodies.force[1] + task.start, bodies.force[2] + task.start};
    if (task.woven) return kernels_.attract_woven(task.of, force);
    kernels_.attract(task.of, task.first, task.last, force);
  });
}

double MutualGravity::energy(const PairBodies& bodies, Workers& workers) {
  std::vector<Real> energies(bodies.end);
  if (!trees_.empty()) {
    for_groups(bodies, workers,
               [&](const Pull& pull, const GravityTree& tree, const GravityTree::Group& group, std::size_t start) {
                 alignas(cache_line) Real potential[GravityTree::group_size + cache_line];
                 kernels_.pull_potential(pull, potential);
                 for (std::size_t i = 0; i < pull.bodies; ++i) {
                   const std::size_t slot = start + tree.slot(group.first + i);
                   const Real mass = bodies.mass[slot],
                              of_others = potential[i] + (softening_ > 0 ? mass / softening_ : 0);
                   energies[slot] = Real(0.5) * strength_ * mass * of_others;
                 }
               });
  } else
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

EffectDescription MutualGravity::description() {
  return {
      .name = "mutual_gravity",
      .doc =
          "inverse-square attraction of all bodies by each other, F = G m_i m_j r / (r^2 + s^2)^(3/2), r to j; with "
          "an opening angle far bodies pull together, as a tree's cells to second order",
      .source = "Newton, Principia III; G of CODATA 2018; softening after Plummer 1911; tree after Barnes & Hut 1986",
      .parameters = {{.name = "strength", .unit = "m^3/(kg s^2)", .fallback = 6.6743e-11, .doc = "G; negative repels"},
                     {.name = "softening", .unit = "m", .fallback = 0.0, .minimum = 0, .doc = "s"},
                     {.name = "opening_angle",
                      .unit = "rad",
                      .fallback = 0.0,
                      .minimum = 0,
                      .maximum = 1,
                      .doc = "size over distance of the largest cells that pull as one, e.g. 0.5; 0, or fewer than 256 "
                             "bodies: every pair"}},
      .reads = {"position"},
      .exerts = {"force"},
      .has_energy = true,
      .flops = flops_of_pair,
      .between_bodies = true};
}

}  // namespace ballpark::BALLPARK_PRECISION
