// Forces of your own, without rebuilding the library: a function over a block of columns.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ballpark {

/// Columns of up to one block of bodies of one group, at one evaluation. Arrays have `count` rows; an array whose
/// quantity the group does not carry is null. Add to `force` and `torque`; write nothing else.
template <class Real>
struct BodyBlock {
  std::size_t count = 0;
  double time = 0;                       ///< of this evaluation [s]
  const Real* mass = nullptr;            ///< [kg]
  const Real* position[3] = {};          ///< [m]
  const Real* velocity[3] = {};          ///< [m/s]
  const Real* orientation[4] = {};       ///< w, x, y, z
  const Real* angular_velocity[3] = {};  ///< world frame [rad/s]
  Real* force[3] = {};                   ///< [N]
  Real* torque[3] = {};                  ///< about the centre of mass [N m]; null for bodies without rotation
};

/// A scene with a user effect takes the staged path; implicit integrators then solve by fixed-point iteration. Called
/// from several threads at once, on different blocks; must not throw. Build it with -ffp-contract=off (the
/// ballpark::ballpark target sets it), else equal bits are not promised.
struct UserEffect {
  std::string name;
  std::vector<std::string> groups = {};  ///< all if empty
  bool reads_velocity = true;            ///< false: splitting methods stay symplectic
  bool needs_rotation = false;           ///< true: spheres carry spin for it
  std::function<void(const BodyBlock<double>&)> run_double = {};
  std::function<void(const BodyBlock<float>&)> run_single = {};
};

}  // namespace ballpark
