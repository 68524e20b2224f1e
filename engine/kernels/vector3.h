// Vectors, quaternions and rotations of bodies, lane by lane.
#pragma once

#include "engine/kernels/lanes.h"

namespace ballpark::BALLPARK_PRECISION {

template <class V>
struct Vector3 {
  V x = V(Real(0)), y = V(Real(0)), z = V(Real(0));

  BALLPARK_INLINE Vector3& operator+=(const Vector3& b) {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
  BALLPARK_INLINE Vector3& operator-=(const Vector3& b) {
    x -= b.x;
    y -= b.y;
    z -= b.z;
    return *this;
  }
};

template <class V>
BALLPARK_INLINE Vector3<V> operator+(const Vector3<V>& a, const Vector3<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
BALLPARK_INLINE Vector3<V> operator-(const Vector3<V>& a, const Vector3<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
BALLPARK_INLINE Vector3<V> operator*(const V& s, const Vector3<V>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class V>
BALLPARK_INLINE V dot(const Vector3<V>& a, const Vector3<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
BALLPARK_INLINE Vector3<V> cross(const Vector3<V>& a, const Vector3<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class V>
BALLPARK_INLINE V length(const Vector3<V>& a) {
  return square_root(dot(a, a));
}

/// Rotation matrix of a unit quaternion, body to world. (Of a quaternion of length s: s^2 times a rotation, but for the
/// diagonal; integrator stages leave the unit sphere by the order of their error only.)
template <class V>
struct Rotation {
  V xx, xy, xz, yx, yy, yz, zx, zy, zz;

  BALLPARK_INLINE Rotation(V w, V x, V y, V z) {
    const V one = V(Real(1)), x2 = x + x, y2 = y + y, z2 = z + z;
    xx = one - (y * y2 + z * z2), xy = x * y2 - w * z2, xz = x * z2 + w * y2;
    yx = x * y2 + w * z2, yy = one - (x * x2 + z * z2), yz = y * z2 - w * x2;
    zx = x * z2 - w * y2, zy = y * z2 + w * x2, zz = one - (x * x2 + y * y2);
  }
  BALLPARK_INLINE Vector3<V> to_world(const Vector3<V>& b) const {
    return {xx * b.x + xy * b.y + xz * b.z, yx * b.x + yy * b.y + yz * b.z, zx * b.x + zy * b.y + zz * b.z};
  }
  BALLPARK_INLINE Vector3<V> to_body(const Vector3<V>& a) const {
    return {xx * a.x + yx * a.y + zx * a.z, xy * a.x + yy * a.y + zy * a.z, xz * a.x + yz * a.y + zz * a.z};
  }
};

/// Half of (0, w) times q: the rate of a quaternion that turns with angular velocity w (world frame).
template <class V>
BALLPARK_INLINE void quaternion_rate(const Vector3<V>& w, const V* q, V* rate) {
  const V half = V(Real(0.5));
  rate[0] = -half * (w.x * q[1] + w.y * q[2] + w.z * q[3]);
  rate[1] = half * (w.x * q[0] + w.y * q[3] - w.z * q[2]);
  rate[2] = half * (w.y * q[0] + w.z * q[1] - w.x * q[3]);
  rate[3] = half * (w.z * q[0] + w.x * q[2] - w.y * q[1]);
}

template <class V>
BALLPARK_INLINE V inverse_length(const V* q) {
  return V(Real(1)) / square_root(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

}  // namespace ballpark::BALLPARK_PRECISION
