// The rotation of a body without torque, whose angular momentum L stands still in space.
#pragma once

#include "engine/kernels/rotation_vector.h"

namespace ballpark::BALLPARK_PRECISION {

/// Of a tensor of inertia: unit vectors in the body frame, and 1 / the moment about each [1/(kg m^2)].
template <class V>
struct PrincipalAxes {
  Vector3<V> axis[3];
  V rate[3];
};

template <class V>
BALLPARK_INLINE V median(const V& a, const V& b, const V& c) {
  const V low = select(a > b, b, a), high = select(a > b, a, b), rest = select(high > c, c, high);
  return select(low > rest, low, rest);
}

/// Strang splitting of H = sum of b_i^2 / (2 I_i), b the angular momentum in the body's axes: each term turns the body
/// about its axis at the steady rate b_i / I_i. What turns alike about all axes is one turn about L, exactly, so that
/// balls and bodies with an axis of symmetry have no error. (Touma & Wisdom 1994, Astron. J. 107, 1189; Hairer, Lubich
/// & Wanner, Geometric Numerical Integration, VII.5.3.) `shares` of the step, one after the other, raise its order.
template <class V>
BALLPARK_INLINE void turn_freely(const PrincipalAxes<V>& p, const Vector3<V>& L, Real step, const Real* shares,
                                 int count, V* q) {
  const V common = median(p.rate[0], p.rate[1], p.rate[2]);
  for (int s = 0; s < count; ++s) {
    for (int part = 0; part < 5; ++part) {  // half, half, whole, half, half
      const int i = part < 3 ? part : 4 - part;
      const V time = V((i < 2 ? Real(0.5) : Real(1)) * (step * shares[s]));
      const V own = dot(Rotation<V>(q[0], q[1], q[2], q[3]).to_world(p.axis[i]), L);
      V by[4], turned[4];
      exponential((time * (p.rate[i] - common) * own) * p.axis[i], by);
      product(q, by, turned);
      for (int c = 0; c < 4; ++c) q[c] = turned[c];
    }
  }
  turn((V(step) * common) * L, q);
}

}  // namespace ballpark::BALLPARK_PRECISION
