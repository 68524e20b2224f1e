#include "perf/cost/track.h"

#include <algorithm>
#include <cmath>

namespace ballpark::cost {

namespace {

/// Of a and b as a rotation from one to the other [rad]; exact for small ones, where acos is not.
double angle_between(const Quaternion& a, const Quaternion& b) {
  const auto chord = [&](double sign) {
    const double w = a.w - sign * b.w, x = a.x - sign * b.x, y = a.y - sign * b.y, z = a.z - sign * b.z;
    return std::sqrt(w * w + x * x + y * y + z * z);
  };
  return 4 * std::asin(std::min(1.0, std::min(chord(1), chord(-1)) / 2));
}

double norm(const Quaternion& q) {
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

/// By Quantity.
std::array<double, quantity_count> distances(const BodyState& a, const BodyState& b) {
  const bool turns = a.has_orientation && b.has_orientation, spins = a.has_angular_velocity && b.has_angular_velocity;
  return {(a.position - b.position).norm(), (a.velocity - b.velocity).norm(),
          turns ? angle_between(a.orientation, b.orientation) : 0,
          spins ? (a.angular_velocity - b.angular_velocity).norm() : 0};
}

/// The larger one, or the one that is not a number.
double worse(double a, double b) {
  return std::isnan(a) || a > b ? a : b;
}

double ratio(double difference, double scale) {
  return scale > 0 ? difference / scale : difference;
}

/// How far what should stay has gone from where it began.
void add_drifts(Errors& errors, const Track& track, const Totals& start) {
  double energy = std::max(std::abs(start.energy()), start.kinetic);
  double momentum = start.momentum_scale, turning = start.angular_momentum_scale;
  for (std::size_t t = 0; t < track.known.size(); ++t) {
    if (!track.known[t]) continue;
    const Totals& now = track.totals[t];
    energy = std::max({energy, std::abs(now.energy()), now.kinetic});
    momentum = std::max(momentum, now.momentum_scale);
    turning = std::max(turning, now.angular_momentum_scale);
    errors.energy = worse(std::abs(now.energy() - start.energy()), errors.energy);
    errors.momentum = worse((now.momentum - start.momentum).norm(), errors.momentum);
    errors.angular_momentum = worse((now.angular_momentum - start.angular_momentum).norm(), errors.angular_momentum);
  }
  errors.energy = ratio(errors.energy, energy);
  errors.momentum = ratio(errors.momentum, momentum);
  errors.angular_momentum = ratio(errors.angular_momentum, turning);
}

}  // namespace

const char* name(Quantity quantity) {
  constexpr const char* names[] = {"position", "velocity", "orientation", "spin"};
  return names[static_cast<std::size_t>(quantity)];
}

const char* unit(Quantity quantity) {
  constexpr const char* units[] = {"m", "m/s", "rad", "rad/s"};
  return units[static_cast<std::size_t>(quantity)];
}

Samples samples_of(double duration, std::size_t bodies, std::size_t count, std::size_t most) {
  Samples samples;
  const auto parts = static_cast<double>(count);
  for (std::size_t k = 1; k <= count; ++k) samples.times.push_back(duration * static_cast<double>(k) / parts);
  const std::size_t chosen = std::min(bodies, most);
  for (std::size_t b = 0; b < chosen; ++b) samples.ids.push_back(b * bodies / chosen);
  return samples;
}

Track::Track(const Samples& samples)
    : known(samples.times.size(), 0), states(samples.times.size() * samples.ids.size()), totals(samples.times.size()) {}

void Track::look(const World& world, const Samples& samples, std::size_t time) {
  known[time] = 1;
  for (std::size_t b = 0; b < samples.ids.size(); ++b) {
    states[time * samples.ids.size() + b] = world.body(samples.ids[b]);
  }
  totals[time] = world.totals();
  penetration = world.counters().max_penetration;
}

std::array<double, quantity_count> size_of(const Track& track) {
  std::array<double, quantity_count> size{};
  for (const BodyState& s : track.states) {
    const double turn = s.has_orientation ? 1 : 0;
    const double sizes[] = {s.position.norm(), s.velocity.norm(), turn, s.angular_velocity.norm()};
    for (std::size_t q = 0; q < quantity_count; ++q) size[q] = std::max(size[q], sizes[q]);
  }
  return size;
}

std::array<double, quantity_count> scale_of(const Track& track, const Samples& samples) {
  constexpr double at_rest = 1e-9, swing = 0.1;
  std::array<double, quantity_count> scale = size_of(track);
  const std::size_t bodies = samples.ids.size();
  double farthest = 0;
  for (std::size_t i = 0; i < track.states.size(); ++i) {
    const BodyState& begin = samples.start.empty() ? track.states[i % bodies] : samples.start[i % bodies];
    farthest = std::max(farthest, (track.states[i].position - begin.position).norm());
  }
  // Who is back at each look has moved in between.
  const double between = swing * scale[1] * samples.times.back() / static_cast<double>(samples.times.size());
  const double moved = farthest > at_rest * between ? farthest : between;
  if (moved > at_rest * scale[0]) scale[0] = moved;
  return scale;
}

Errors errors_of(const Track& track, const Track& reference, const Totals& start) {
  Errors errors;
  const std::size_t bodies = track.states.size() / track.known.size();
  std::array<double, quantity_count> squares{};
  double count = 0;
  for (std::size_t t = 0; t < track.known.size(); ++t) {
    if (!track.known[t] || !reference.known[t]) continue;
    std::array<double, quantity_count> largest{};
    for (std::size_t b = t * bodies; b < (t + 1) * bodies; ++b) {
      const auto apart = distances(track.states[b], reference.states[b]);
      for (std::size_t q = 0; q < quantity_count; ++q) {
        largest[q] = worse(apart[q], largest[q]);
        squares[q] += apart[q] * apart[q];
      }
      errors.quaternion_norm = worse(std::abs(norm(track.states[b].orientation) - 1), errors.quaternion_norm);
    }
    count += static_cast<double>(bodies);
    for (std::size_t q = 0; q < quantity_count; ++q) {
      errors.of[q].maximum = worse(largest[q], errors.of[q].maximum);
      errors.of[q].end = largest[q];
    }
  }
  for (std::size_t q = 0; q < quantity_count; ++q) errors.of[q].rms = std::sqrt(squares[q] / std::max(count, 1.0));
  add_drifts(errors, track, start);
  errors.penetration = track.penetration;
  errors.events = event_errors(track.events, reference.events);
  return errors;
}

double value_of(const Errors& errors, Quantity quantity, const std::string& which) {
  const Distance& distance = errors[quantity];
  return which == "end" ? distance.end : which == "rms" ? distance.rms : distance.maximum;
}

}  // namespace ballpark::cost
