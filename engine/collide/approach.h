// Continuous collision: where two surfaces first meet while one moves, or are nearest if they do not. The contact is
// then a half-space with the normal of that moment, so that a step of any length neither passes through what it meets
// nor is stopped by what it passes.
#pragma once

#include "engine/collide/gap.h"

namespace ballpark::BALLPARK_PRECISION {

/// Distance along the normal at the start: the surfaces meet within a motion if distance + normal . moved < 0, and then
/// after a share `moment` of it.
struct Approach {
  Real distance;
  Vector3<Real> normal;
  Real moment;
};

/// How far along a straight motion (0 to 1) a point comes within `reach` of the origin; else, of its nearest moment.
/// `apart`: where it starts.
inline Real moment_within(const Vector3<Real>& apart, const Vector3<Real>& moved, Real reach, bool& meets) {
  const Real outside = dot(apart, apart) - reach * reach, towards = -dot(apart, moved), square = dot(moved, moved);
  meets = outside <= 0;
  if (meets || !(towards > 0)) return 0;
  const Real under_root = towards * towards - square * outside;
  const bool crosses = under_root >= 0;
  const Real moment = crosses ? outside / (towards + square_root(under_root)) : towards / square;
  meets = crosses && moment <= 1;
  return moment < 1 ? moment : Real(1);
}

/// How far along its motion a point that starts within `reach` of the origin leaves it; 1 if it does not.
inline Real moment_beyond(const Vector3<Real>& from, const Vector3<Real>& moved, Real reach) {
  const Real inside = reach * reach - dot(from, from), outwards = dot(from, moved), square = dot(moved, moved);
  if (!(square > 0)) return 1;
  if (!(inside > 0)) return outwards > 0 ? Real(0) : Real(1);
  const Real root = square_root(outwards * outwards + square * inside);
  const Real moment = outwards > 0 ? inside / (outwards + root) : (root - outwards) / square;
  return moment < 1 ? moment : Real(1);
}

/// Do two balls come within `reach` of each other's centres?
inline bool come_within(const Vector3<Real>& apart, const Vector3<Real>& moved, Real reach) {
  bool meets = false;
  moment_within(apart, moved, reach, meets);
  return meets;
}

/// Ball 2 seen from ball 1: `apart` = x2 - x1 at the start, `moved` = its relative motion; reach: sum of the radii.
inline Approach approach_between(const Vector3<Real>& apart, const Vector3<Real>& moved, Real reach) {
  bool meets = false;
  const Real moment = moment_within(apart, moved, reach, meets);
  const Vector3<Real> there = apart + moment * moved, normal = direction(there, length(there), {0, 0, 1});
  return {dot(normal, apart) - reach, normal, moment};
}

inline Approach approach_to(const Plane& plane, const Vector3<Real>& x, const Vector3<Real>& moved, Real radius) {
  const Gap<Real> gap = gap_to(plane, x, radius);
  const Real closing = -dot(gap.normal, moved);
  const Real moment = !(gap.distance > 0) ? Real(0) : closing > gap.distance ? gap.distance / closing : Real(1);
  return {gap.distance, gap.normal, moment};
}

/// From inside: the wall is met where the distance from the axis reaches that of the surface.
inline Approach approach_to(const Tube& tube, const Vector3<Real>& x, const Vector3<Real>& moved, Real radius) {
  const Vector3<Real> from = x - tube.centre;
  const Vector3<Real> off = from - dot(tube.axis, from) * tube.axis;
  const Vector3<Real> across = moved - dot(tube.axis, moved) * tube.axis;
  const Real free = tube.radius - radius;
  const Real moment = dot(off, off) < free * free ? moment_beyond(off, across, free) : Real(0);
  const Vector3<Real> normal = gap_to(tube, x + moment * moved, radius).normal;
  return {dot(normal, off) + free, normal, moment};
}

/// From outside, by conservative advancement: the box lies behind the plane through its nearest point, which bounds
/// each step (Mirtich 1996). The distance from a convex body is convex along the way: once it grows, it goes on
/// growing.
inline Approach approach_to(const Box& box, const Vector3<Real>& x, const Vector3<Real>& moved, Real radius) {
  constexpr int most_steps = 64;
  const Real near = Real(1e-6) * radius;
  Real moment = 0;
  Gap<Real> gap = gap_to(box, x, radius);
  for (int i = 0; i < most_steps && gap.distance > near && moment < 1; ++i) {
    const Real closing = -dot(gap.normal, moved);
    if (!(closing > 0)) break;
    const Real next = moment + gap.distance / closing;
    moment = next < 1 ? next : Real(1);
    gap = gap_to(box, x + moment * moved, radius);
  }
  return {gap.distance - moment * dot(gap.normal, moved), gap.normal, moment};
}

}  // namespace ballpark::BALLPARK_PRECISION
