// States of a world, read in place or by value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ballpark/report.h"
#include "ballpark/scene.h"

namespace ballpark {

/// One body's state, by value. What its group does not carry is identity or zero.
struct BodyState {
  Vector3d position = Vector3d::Zero();          ///< [m]
  Vector3d velocity = Vector3d::Zero();          ///< [m/s]
  Quaternion orientation;                        ///< body to world
  Vector3d angular_velocity = Vector3d::Zero();  ///< world frame [rad/s]
  bool has_orientation = false;
  bool has_angular_velocity = false;
  bool present = true;  ///< false: it has not entered yet or is gone, and every value is NaN
};

/// What contacts do to one body.
struct ContactLoad {
  std::uint32_t contacts = 0;         ///< bodies and faces of boundaries that press on it
  Vector3d force = Vector3d::Zero();  ///< of all of them [N]
};

/// A column read in place: component c of the body in row r is `view[c][r - first_row]`. Valid until the next step.
/// It ends with the last body. Between groups there may be rows of no body, whose values mean nothing.
template <class Real>
struct View {
  std::size_t first_row = 0;
  std::vector<std::span<const Real>> components;
  std::span<const Real> operator[](std::size_t c) const { return components[c]; }
};

/// A state to return to: the columns, the time and the step count. Only for worlds of the same scene and options.
struct Snapshot {
  double time = 0;              ///< [s]
  std::uint64_t structure = 0;  ///< of the world it is from: groups, copies, precision
  std::vector<int> motions;     ///< how each group moves: a call may have set one turning
  Counters counters;
  Status status;
  std::vector<std::vector<std::byte>> columns;
  std::vector<double> pace;         ///< what multistep and adaptive methods carry from step to step
  std::vector<std::byte> contacts;  ///< impulses that the contacts of the last step bore
  std::vector<double> ledger;       ///< what the energy ledger holds, if it is kept
};

}  // namespace ballpark
