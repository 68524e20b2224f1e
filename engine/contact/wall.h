// Boundaries: what does not move by forces. A wall may move as prescribed, and its surface may run like a belt.
#pragma once

#include <cmath>
#include <cstdint>
#include <variant>

#include "engine/collide/approach.h"
#include "engine/core/maths.h"

namespace ballpark::BALLPARK_PRECISION {

/// Displacement V t + A sin(2 pi f t + phase) - A sin(phase), A along a direction: no jump at the start.
struct WallMotion {
  double velocity[3] = {};   ///< V [m/s]
  double amplitude[3] = {};  ///< A [m]
  double frequency = 0;      ///< f [Hz]
  double phase = 0;          ///< [rad]

  bool any() const {
    for (int c = 0; c < 3; ++c) {
      if (velocity[c] != 0 || (amplitude[c] != 0 && frequency != 0)) return true;
    }
    return false;
  }
  Vector3<double> displacement(double t) const {
    const double swing = maths::sin(angle(t)) - maths::sin(phase);
    return {velocity[0] * t + amplitude[0] * swing, velocity[1] * t + amplitude[1] * swing,
            velocity[2] * t + amplitude[2] * swing};
  }
  Vector3<double> velocity_at(double t) const {
    const double rate = turn * frequency * maths::cos(angle(t));
    return {velocity[0] + amplitude[0] * rate, velocity[1] + amplitude[1] * rate, velocity[2] + amplitude[2] * rate};
  }
  /// No speed is ever larger [m/s].
  double top_speed() const {
    const auto size = [](const double(&a)[3]) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); };
    return size(velocity) + turn * frequency * size(amplitude);
  }

 private:
  static constexpr double turn = 6.283185307179586;
  double angle(double t) const { return turn * frequency * t + phase; }
};

struct Wall {
  std::variant<Plane, Box, Tube> shape;
  std::uint16_t material = 0;
  WallMotion motion;
  Vector3<Real> belt;  ///< speed of the surface over the wall [m/s]

  Real distance(const Vector3<Real>& x, Real radius) const {
    return std::visit([&](const auto& s) { return gap_to(s, x, radius).distance; }, shape);
  }
  Approach approach(const Vector3<Real>& x, const Vector3<Real>& moved, Real radius) const {
    return std::visit([&](const auto& s) { return approach_to(s, x, moved, radius); }, shape);
  }
};

/// A wall during one substep.
struct WallMoment {
  Vector3<Real> offset;    ///< how far it has moved at the start [m]
  Vector3<Real> moved;     ///< and moves during the substep [m]
  Vector3<Real> velocity;  ///< of its surface at the start [m/s]
  Vector3<Real> end_velocity;
};

}  // namespace ballpark::BALLPARK_PRECISION
