// The fused RK4 loops that one would write by hand for one effect beside gravity, in vectors as wide as the machine's:
// what Ballpark's price of an effect is measured against.
#pragma once

#include <cstddef>
#include <span>

namespace ballpark::perf {

/// Of the bodies and effects that these loops know when they are compiled.
namespace hand {
inline constexpr double gravity = 9.81, mass = 0.5, radius = 0.05, inertia = 0.4 * mass * radius * radius;
inline constexpr double linear = 0.02, quadratic = 0.01, magnus = 0.003;
inline constexpr double stiffness = 2, damping = 0.1, rest_length = 1, anchor = 50;
inline constexpr double strength = 1000, softening = 1;
inline constexpr double charge = 0.5, field[3] = {0.1, 0.2, 0.3};
inline constexpr double turning[3] = {0.01, 0.02, 0.03};
inline constexpr double push[3] = {0.1, 0.2, 0.3}, twist[3] = {1e-4, 2e-4, 3e-4}, trap[3] = {1, 2, 3};
inline constexpr double air = 1.2, viscosity = 1.8e-5, spin_decay = 1e-4;
inline constexpr double wind[3] = {3, 1, 0}, shear[3] = {0.1, 0, 0};
inline constexpr double sliding = 0.2, rolling = 0.01, spinning = 0.0127, settling = 1e-3;
}  // namespace hand

/// One step of `count` bodies; columns x, y, z, vx, vy, vz, and of what spins the angular momentum. All start on 64
/// bytes, with room for a vector behind the last.
using HandWrittenStep = void (*)(double* const* columns, std::size_t count, double step);

struct HandWrittenEffect {
  const char* name;
  bool spins;
  bool drags;  ///< both have linear drag besides, for what flows
  HandWrittenStep without, with;
  bool same = true;  ///< computes what Ballpark does; else as much arithmetic of the same kind
};
std::span<const HandWrittenEffect> hand_written_effects();

}  // namespace ballpark::perf
