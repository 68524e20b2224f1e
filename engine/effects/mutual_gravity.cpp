#include "engine/effects/mutual_gravity.h"

#include <algorithm>

namespace ballpark::BALLPARK_PRECISION {

namespace {

constexpr std::size_t task_slots = 128;       // a multiple of any vector
constexpr std::size_t small_scene = 1 << 14;  // pairs below which one thread is faster than two
constexpr int flops_of_pair = 18;

}  // namespace

MutualGravity::MutualGravity(const PairInput& input)
    : strength_(input.effect.number("strength")),
      softening_(input.effect.number("softening")),
      kernels_(input.kernels),
      count_(input.bodies.count) {}

template <class Act>
void MutualGravity::for_tasks(const PairBodies& bodies, Workers& workers, Act act) const {
  const std::size_t of_copy = (bodies.stride + task_slots - 1) / task_slots;
  const auto task = [&](std::size_t t) {
    const std::size_t start = t / of_copy * bodies.stride, first = t % of_copy * task_slots;
    Attraction a{{}, bodies.mass.data() + start, bodies.count, strength_, softening_ * softening_};
    for (int c = 0; c < 3; ++c) a.position[c] = bodies.position[c].data() + start;
    act(a, start, first, std::min(first + task_slots, bodies.stride));
  };
  const bool small = bodies.copies * bodies.count * bodies.count < small_scene;
  workers.for_each(bodies.copies * of_copy, task, small ? 1 : workers.threads());
}

void MutualGravity::find_forces(PairBodies& bodies, Workers& workers) {
  for_tasks(bodies, workers, [&](const Attraction& a, std::size_t start, std::size_t first, std::size_t last) {
    Real* const force[3] = {bodies.force[0].data() + start, bodies.force[1].data() + start,
                            bodies.force[2].data() + start};
    kernels_.attract(a, first, last, force);
  });
}

double MutualGravity::energy(const PairBodies& bodies, Workers& workers) {
  const AlignedArray<Real> energies(bodies.copies * bodies.stride);
  for_tasks(bodies, workers, [&](const Attraction& a, std::size_t start, std::size_t first, std::size_t last) {
    kernels_.attraction_energy(a, first, last, energies.data() + start);
  });
  double sum = 0;
  for (std::size_t i = 0; i < energies.size(); ++i) sum += static_cast<double>(energies.data()[i]);
  return sum;
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
