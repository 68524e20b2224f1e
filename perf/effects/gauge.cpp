#include "perf/effects/gauge.h"

#include <limits>

namespace ballpark::cost {

Gauge::Gauge(const Scene& scene, const Options& options)
    : world_(scene, options), at_end_(samples_of(scene.run.duration, world_.body_count(), 1, world_.body_count())) {
  for (const std::size_t id : at_end_.ids) at_end_.start.push_back(world_.body(id));
  world_.advance_to(scene.run.duration);  // for what depends on time
}

/// What its run does not carry, because nothing changes it there, is as at the start.
void Gauge::place(std::size_t id, BodyState state) {
  const BodyState& start = at_end_.start[id];
  if (!state.has_angular_velocity) state.angular_velocity = start.angular_velocity;
  if (!state.has_orientation) state.orientation = start.orientation;
  state.has_angular_velocity = start.has_angular_velocity;
  state.has_orientation = start.has_orientation;
  world_.set(id, state);
}

double Gauge::energy(const Track& end) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN(), rounding = 1e-5;
  try {
    for (std::size_t id = 0; id < end.states.size(); ++id) {
      place(id, end.states[id]);
      const Vector3d wanted = end.states[id].position, there = world_.body(id).position;
      if ((there - wanted).norm() > rounding * (1 + wanted.norm())) return unknown;  // held, by a pivot
    }
  } catch (const SceneError&) {
    return unknown;
  }
  return world_.totals().energy();
}

}  // namespace ballpark::cost
