// What kernels see of bodies: pointers to columns in memory, and a body's quantities in registers.
#pragma once

#include <cstddef>

#include "engine/kernels/vector3.h"

namespace ballpark::BALLPARK_PRECISION {

/// A constant of a group: one value, or a row for each body.
struct PerBody {
  const Real* rows = nullptr;
  Real value = 0;

  template <class V>
  BALLPARK_INLINE V at(std::size_t row) const {
    return rows ? load<V>(rows + row) : V(value);
  }
  template <class V>
  BALLPARK_INLINE V inverse_at(std::size_t row) const {
    return rows ? V(Real(1)) / load<V>(rows + row) : V(Real(1) / value);
  }
};

template <class V>
BALLPARK_INLINE Vector3<V> vector_at(const PerBody (&c)[3], std::size_t row) {
  return {c[0].at<V>(row), c[1].at<V>(row), c[2].at<V>(row)};
}

/// State columns of one group from its first row on; null where the group does not carry the quantity.
struct StateColumns {
  Real* position[3] = {};
  Real* velocity[3] = {};
  Real* orientation[4] = {};
  Real* momentum[3] = {};  ///< angular, about the centre of mass (pivoted bodies: about the pivot)
  Real* turn[3] = {};      ///< trial states of exponential motions: rotation vector since the step's start
};

/// Constants of one group that motion needs.
struct BodyConstants {
  PerBody mass;
  PerBody effective_mass;      ///< what resists a force: with the mass of the fluid that moves along
  PerBody inverse_inertia[6];  ///< body frame: xx, yy, zz, then (pivoted bodies, about the pivot) xy, xz, yz
  PerBody arm[3];              ///< pivoted bodies: pivot to centre of mass, body frame
  PerBody pivot[3];            ///< pivoted bodies: the fixed point, world frame
  PerBody principal[12];       ///< pivoted bodies that turn by splitting: each principal axis, then 1 / its moment
  Real* orientation[4] = {};   ///< exponential motions: at the step's start
};

/// A body (or one in each lane) as effects see it.
template <class V>
struct Body {
  std::size_t row;  ///< of the first lane, in the group
  V mass;
  Vector3<V> position, velocity;
  Vector3<V> spin;  ///< angular velocity, world frame
};

/// Sum of what acts on a body. Torque is about the centre of mass.
template <class V>
struct Loads {
  Vector3<V> force, torque;
};

/// Rates of velocity and spin: what a force derivative needs beside the body itself.
template <class V>
struct Acceleration {
  Vector3<V> linear, angular;
};

/// Force and torque that passes before an evaluation sum (user effects, effects between bodies); null: none.
struct SumColumns {
  Real* force[3] = {};
  Real* torque[3] = {};
};

}  // namespace ballpark::BALLPARK_PRECISION
