// The narrow phase: how far a ball is from what it may touch, and in which direction. Templates on the vector type, so
// that lanes run over contacts. Normals are unit vectors that point at the ball.
#pragma once

#include "engine/kernels/vector3.h"

namespace ballpark::BALLPARK_PRECISION {

/// A negative gap is an overlap. The contact is at radius * normal behind the ball's centre.
template <class V>
struct Gap {
  V distance;         ///< between the surfaces [m]
  Vector3<V> normal;  ///< towards the ball
};

/// n . x = offset; the ball is in front of it.
struct Plane {
  Vector3<Real> normal;  ///< of length 1
  Real offset = 0;       ///< [m]
};

/// Axis-aligned, as seen from outside. (From inside a box is six planes.)
struct Box {
  Vector3<Real> centre, half;  ///< [m]
};

/// Round an axis through `centre`, without ends (planes close it), as seen from inside: a drum or a tube.
struct Tube {
  Vector3<Real> centre;
  Vector3<Real> axis;  ///< of length 1
  Real radius = 0;     ///< [m]
};

template <class V>
BALLPARK_INLINE Vector3<V> spread(const Vector3<Real>& a) {
  return {V(a.x), V(a.y), V(a.z)};
}

/// a / |a|, or `otherwise` where a is zero.
template <class V>
BALLPARK_INLINE Vector3<V> direction(const Vector3<V>& a, const V& size, const Vector3<Real>& otherwise) {
  const V zero = V(Real(0)), one = V(Real(1));
  const auto some = size > zero;
  const V inverse = one / select(some, size, one);
  return {select(some, inverse * a.x, V(otherwise.x)), select(some, inverse * a.y, V(otherwise.y)),
          select(some, inverse * a.z, V(otherwise.z))};
}

/// From ball 1 to ball 2, `apart` = x2 - x1. Balls in one point are pushed apart along z.
template <class V>
BALLPARK_INLINE Gap<V> gap_between(const Vector3<V>& apart, const V& radius1, const V& radius2) {
  const V size = length(apart);
  return {size - (radius1 + radius2), direction(apart, size, {0, 0, 1})};
}

template <class V>
BALLPARK_INLINE Gap<V> gap_to(const Plane& plane, const Vector3<V>& x, const V& radius) {
  const Vector3<V> normal = spread<V>(plane.normal);
  return {dot(normal, x) - V(plane.offset) - radius, normal};
}

/// Nearest point of the surface: a face, an edge or a corner. A centre inside is pushed through the nearest face.
template <class V>
BALLPARK_INLINE Gap<V> gap_to(const Box& box, const Vector3<V>& x, const V& radius) {
  const V zero = V(Real(0)), one = V(Real(1));
  const Vector3<V> from = x - spread<V>(box.centre);
  const V at[3] = {from.x, from.y, from.z}, half[3] = {V(box.half.x), V(box.half.y), V(box.half.z)};
  V beyond[3], side[3], depth[3];  // outside of the faces, on which side, distance to the nearer of both
  for (int c = 0; c < 3; ++c) {
    side[c] = select(zero > at[c], -one, one);
    depth[c] = half[c] - side[c] * at[c];
    beyond[c] = select(zero > depth[c], -side[c] * depth[c], zero);
  }
  const Vector3<V> out{beyond[0], beyond[1], beyond[2]};
  const V distance = length(out);
  const V nearest = select(depth[1] > depth[0], depth[0], depth[1]);
  const V least = select(depth[2] > nearest, nearest, depth[2]);
  const V to_x = select(depth[0] > least, zero, one), to_y = select(depth[1] > least, zero, one - to_x);
  const Vector3<V> face{to_x * side[0], to_y * side[1], (one - to_x - to_y) * side[2]};
  const Vector3<V> outwards = direction(out, distance, {0, 0, 1});
  const auto outside = distance > zero;
  return {
      select(outside, distance, -least) - radius,
      {select(outside, outwards.x, face.x), select(outside, outwards.y, face.y), select(outside, outwards.z, face.z)}};
}

/// A ball on the axis is pushed along a fixed direction across it.
template <class V>
BALLPARK_INLINE Gap<V> gap_to(const Tube& tube, const Vector3<V>& x, const V& radius) {
  const Vector3<V> axis = spread<V>(tube.axis), from = x - spread<V>(tube.centre);
  const Vector3<V> across = dot(axis, from) * axis - from;  // towards the axis
  const V off = length(across);
  const bool steep = tube.axis.x * tube.axis.x > Real(0.5);
  const Vector3<Real> other = steep ? Vector3<Real>{0, 1, 0} : Vector3<Real>{1, 0, 0};
  const Vector3<Real> anywhere = cross(tube.axis, other);
  return {V(tube.radius) - off - radius, direction(across, off, (Real(1) / length(anywhere)) * anywhere)};
}

}  // namespace ballpark::BALLPARK_PRECISION
