#include "perf/throughput/bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "perf/baselines/effects.h"
#include "perf/machine.h"
#include "perf/throughput/bare_arrays.h"
#include "perf/throughput/scenes.h"

namespace ballpark::perf {

namespace {

constexpr double least_bar = 2, times_hand_written = 1.5;  // ns

Vector3d vector(const double (&a)[3]) {
  return {a[0], a[1], a[2]};
}

/// The effect that the hand-written loop of this name computes.
Effect effect_of(const std::string& name) {
  using namespace hand;
  const std::map<std::string, std::map<std::string, Value>> parameters = {
      {"linear_drag", {{"coefficient", linear}}},
      {"quadratic_drag", {{"coefficient", quadratic}}},
      {"magnus", {{"coefficient", hand::magnus}}},
      {"spring",
       {{"anchor", Vector3d(anchor, anchor, anchor)},
        {"stiffness", stiffness},
        {"damping", damping},
        {"rest_length", rest_length}}},
      {"central_gravity", {{"strength", strength}, {"softening", softening}}},
      {"electric_field", {{"charge", charge}, {"field", vector(field)}}},
      {"magnetic_field", {{"charge", charge}, {"field", vector(field)}}},
      {"rotating_frame", {{"angular_velocity", vector(turning)}}},
      {"force", {{"force", vector(push)}}},
      {"torque", {{"torque", vector(twist)}}},
      {"harmonic_trap", {{"stiffness", vector(trap)}}},
      {"buoyancy", {{"density", air}}},
      {"reynolds_drag", {{"density", air}, {"viscosity", viscosity}}},
      {"spin_decay", {{"coefficient", hand::spin_decay}}},
      {"wind", {{"velocity", vector(hand::wind)}, {"shear", vector(shear)}}},
      {"gusts", {{"speed", 1.0}}},
      {"table", {}}};
  return {.kind = name, .groups = {}, .parameters = parameters.at(name)};
}

StateColumns columns_of(const World& world, bool spins) {
  StateColumns columns = state_of(world);
  if (!spins) return columns;
  const auto view = world.view<double>("angular_momentum");
  for (const auto& component : view.components) {
    columns.emplace_back();
    for (std::size_t id = 0; id < world.body_count(); ++id) {
      columns.back().push_back(component[world.row_of(id) - view.first_row]);
    }
  }
  return columns;
}

/// Largest difference, of the largest value of each quantity.
double difference(const StateColumns& a, const StateColumns& b) {
  double worst = 0;
  for (std::size_t first = 0; first < a.size(); first += 3) {
    double largest = 0, most = 0;
    for (std::size_t c = first; c < first + 3; ++c) {
      for (std::size_t i = 0; i < a[c].size(); ++i) {
        largest = std::max(largest, std::abs(a[c][i]));
        most = std::max(most, std::abs(a[c][i] - b[c][i]));
      }
    }
    worst = std::max(worst, most / largest);
  }
  return worst;
}

struct Price {
  double minima, medians;  ///< [ns]
};
Price price_of(const Samples& with, const Samples& without, double body_steps) {
  return {1e9 * (with.minimum() - without.minimum()) / body_steps,
          1e9 * (with.median() - without.median()) / body_steps};
}

bool measure_one(const HandWrittenEffect& effect, const Settings& settings) {
  constexpr double agreement = 1e-9, step = 1e-4;
  Scene scene = falling_spheres(settings.bodies);
  if (effect.spins) scene.bodies[0].generate->angular_velocity_spread = Vector3d(10, 10, 10);
  if (effect.drags) scene.effects.push_back(effect_of("linear_drag"));
  World without(scene, {.threads = 1});
  scene.effects.push_back(effect_of(effect.name));
  World with(scene, {.threads = 1});
  const std::size_t bodies = settings.bodies, steps = steps_per_run(bodies);
  const BareArrays bare_without(columns_of(without, false)), bare_with(columns_of(with, effect.spins));
  const auto hand = [&](HandWrittenStep run, const BareArrays& bare) {
    return [run, &bare, bodies, steps] {
      for (std::size_t s = 0; s < steps; ++s) run(bare.data(), bodies, step);
    };
  };
  const Task tasks[] = {[&] { without.step(steps); }, [&] { with.step(steps); }, hand(effect.without, bare_without),
                        hand(effect.with, bare_with)};
  const std::vector<Samples> samples = time_interleaved(tasks, {.seconds = settings.seconds});
  const double body_steps = static_cast<double>(bodies * steps);
  const Price ours = price_of(samples[1], samples[0], body_steps),
              theirs = price_of(samples[3], samples[2], body_steps);
  const double bar = std::max(least_bar, times_hand_written * theirs.minima);
  const double off = effect.same ? difference(bare_with.columns(), columns_of(with, effect.spins)) : 0;
  const bool met = ours.minima <= bar, agrees = off < agreement;
  fmt::print("  {:<16}{:>9.2f} /{:>6.2f}{:>11.2f} /{:>6.2f}{:>9.2f}  {:<8}{}\n", effect.name, ours.minima, ours.medians,
             theirs.minima, theirs.medians, bar, met ? "met" : "MISSED",
             !effect.same ? "other numbers"
             : agrees     ? fmt::format("{:.0e}", off)
                          : fmt::format("{:.0e}: DISAGREE", off));
  std::fflush(stdout);
  return met && agrees;
}

}  // namespace

bool bars(const Settings& settings) {
  fmt::print(
      "What an effect adds beside gravity to a body-step of rk4, {} bodies, double, one thread [ns], {}\n"
      "  {:<16}{:>17}{:>19}{:>9}  {:<8}{}\n",
      settings.bodies, machine().processor, "", "Ballpark", "hand-written", "bar", "", "largest difference");
  bool all = true;
  for (const HandWrittenEffect& effect : hand_written_effects()) all = measure_one(effect, settings) && all;
  fmt::print(
      "  Least / median of runs in turns with runs without it; judged on the least. The bar: 1.5 times the "
      "hand-written\n"
      "  price, or 2 ns. Magnus, torque, spin_decay and table bring the spin's columns. wind and gusts: with "
      "linear_drag.\n");
  return all;
}

}  // namespace ballpark::perf
