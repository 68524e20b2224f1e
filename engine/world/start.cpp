#include "engine/world/start.h"

#include <cmath>

#include "engine/core/maths.h"
#include "engine/core/random.h"
#include "engine/world/check.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

/// What a random number is for: each use has a stream of its own.
enum class Purpose {
  position,
  velocity,
  angular_velocity,
  orientation,
  perturb_position,
  perturb_velocity,
  speed,
  heading
};

random::Draw draw(std::uint64_t seed, std::size_t group, Purpose purpose, std::uint64_t counter) {
  return {seed, 16 * group + static_cast<std::uint64_t>(purpose), counter};
}

/// Three numbers uniform in [-1, 1].
Vector3<Wide> random_vector(std::uint64_t seed, std::size_t group, std::size_t body, Purpose purpose) {
  Vector3<Wide> v;
  Wide* components[3] = {&v.x, &v.y, &v.z};
  for (std::uint64_t c = 0; c < 3; ++c) {
    *components[c] = random::uniform<double>(draw(seed, group, purpose, 3 * body + c), -1.0, 1.0);
  }
  return v;
}

Vector3<Wide> scaled(const Vector3<Wide>& a, const Vector3<Wide>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// Of this length, in any direction.
Vector3<Wide> random_direction(double length, const random::Draw& at) {
  constexpr double two_pi = 6.283185307179586;
  const auto bits = random::bits(at);
  const double up = 1 - 2 * random::fraction<53>(bits[0]), around = two_pi * random::fraction<53>(bits[1]);
  const double out = length * std::sqrt(1 - up * up);
  return {out * maths::cos(around), out * maths::sin(around), length * up};
}

/// Aarseth, Henon and Wielen 1974, A comparison of numerical methods for the study of star cluster dynamics: the radius
/// that holds a share of the mass, and a speed that has the density q^2 (1 - q^2)^(7/2) as a share q of what escapes.
double plummer_radius(const Generate& g, double share) {
  const double root = maths::cbrt(share);
  return g.scale * root / std::sqrt(1 - root * root);
}
double plummer_speed(const Generate& g, double radius, std::size_t group, std::size_t body, std::uint64_t seed) {
  constexpr std::uint64_t tries = 256;  // each succeeds with 0.3 to 0.5
  double q = 0;
  for (std::uint64_t t = 0; t < tries; ++t) {
    const auto bits = random::bits(draw(seed, group, Purpose::speed, tries * body + t));
    q = random::fraction<53>(bits[0]);
    const double left = 1 - q * q;
    if (0.1 * random::fraction<53>(bits[1]) < q * q * left * left * left * std::sqrt(left)) break;
  }
  return q * std::sqrt(2 * g.strength / std::sqrt(radius * radius + g.scale * g.scale));
}
void place_in_plummer(const Generate& g, std::size_t group, std::size_t body, std::uint64_t seed, Start& start) {
  constexpr double inner = 0.99;
  const double share = inner * random::uniform<double>(draw(seed, group, Purpose::position, 2 * body));
  const double radius = plummer_radius(g, share);
  start.position = wide(g.origin) + random_direction(radius, draw(seed, group, Purpose::position, 2 * body + 1));
  if (g.strength == 0) return;
  const double speed = plummer_speed(g, radius, group, body, seed);
  start.velocity += random_direction(speed, draw(seed, group, Purpose::heading, body));
}

Vector3<Wide> generated_position(const Generate& g, std::size_t group, std::size_t i, std::uint64_t seed) {
  if (g.kind == "lattice") {
    const std::size_t nx = g.count[0], ny = g.count[1];
    const Vector3<Wide> steps = {static_cast<Wide>(i % nx), static_cast<Wide>(i / nx % ny),
                                 static_cast<Wide>(i / nx / ny)};
    return wide(g.origin) + Wide(g.spacing) * steps;
  }
  if (g.kind == "rack") {
    std::size_t row = 0, before = 0;  // bodies of earlier rows
    while (before + row + 1 <= i) before += ++row;
    constexpr Wide root3_over_2 = 0.866025403784438646763723170753L;
    const Wide across = static_cast<Wide>(i - before) - static_cast<Wide>(row) / 2;
    return wide(g.origin) + Wide(g.spacing) * Vector3<Wide>{root3_over_2 * static_cast<Wide>(row), across, 0};
  }
  const Vector3<Wide> u = random_vector(seed, group, i, Purpose::position), lower = wide(g.lower);
  const Vector3<Wide> half = Wide(0.5) * (wide(g.upper) - lower);
  return lower + half + scaled(half, u);
}

Quaternion unit(const Quaternion& q) {
  const double scale = 1 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
}

}  // namespace

Start start_of(const Scene& scene, std::size_t g, std::size_t i, std::uint64_t seed, double perturb) {
  const BodyGroup& group = scene.bodies[g];
  const Vector3d zero(0, 0, 0);
  Start start;
  start.position = wide(row_or(group.position, i, zero));
  start.velocity = wide(row_or(group.velocity, i, zero));
  start.angular_velocity = wide(row_or(group.angular_velocity, i, zero));
  start.orientation = unit(row_or(group.orientation, i, Quaternion{}));
  if (group.generate) {
    const Generate& made = *group.generate;
    if (made.kind == "plummer") place_in_plummer(made, g, i, seed, start);
    if (made.kind != "plummer") start.position = generated_position(made, g, i, seed);
    start.velocity += scaled(wide(made.velocity_spread), random_vector(seed, g, i, Purpose::velocity));
    start.angular_velocity +=
        scaled(wide(made.angular_velocity_spread), random_vector(seed, g, i, Purpose::angular_velocity));
    if (made.random_orientation) {
      const auto q = random::rotation(draw(seed, g, Purpose::orientation, i));
      start.orientation = {q[0], q[1], q[2], q[3]};
    }
  }
  if (group.angular_velocity_frame == "body") {
    start.angular_velocity = rotation_of(start.orientation).to_world(start.angular_velocity);
  }
  if (perturb != 0) {
    const Wide e = perturb;
    start.position += e * scaled(start.position, random_vector(seed, g, i, Purpose::perturb_position));
    start.velocity += e * scaled(start.velocity, random_vector(seed, g, i, Purpose::perturb_velocity));
  }
  return start;
}

}  // namespace ballpark::BALLPARK_PRECISION
