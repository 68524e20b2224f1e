// From where a motion is looked at first, and how near.

import * as THREE from "three";
import { present, radii, span } from "./data.js";

export const fieldOfView = 32; // degrees
const mostSamples = 20000;

/// A box around all positions with their bodies.
export function motionBox(run) {
  const largest = radii(run).reduce((a, b) => Math.max(a, b), 0);
  const room = new THREE.Box3(new THREE.Vector3(...run.header.box.min), new THREE.Vector3(...run.header.box.max));
  room.expandByScalar(largest);
  const size = room.getSize(new THREE.Vector3());
  return Math.max(size.x, size.y, size.z) > 0 ? room : room.expandByScalar(0.3);
}

export const moves = ({ header: { box } }) => box.min.some((low, axis) => low < box.max[axis]);

/// Bodies at evenly chosen frames, as far as there is time for: [x, y, z, radius] one after the other. A point has the
/// radius that its axes reach.
export function samples(run, pointRadius) {
  const { values } = run.columns.position;
  const { from, size } = span(run);
  const radius = radii(run);
  const all = run.frames * run.bodies;
  const stride = Math.max(1, Math.ceil(all / mostSamples));
  const found = [];
  for (let i = 0; i < all; i += stride) {
    if (!present(values, i)) continue;
    for (let axis = 0; axis < 3; ++axis) found.push(from[axis] + (size[axis] * values[3 * i + axis]) / 65535);
    found.push(radius[i % run.bodies] || pointRadius);
  }
  return found;
}

/// Azimuth and elevation in degrees: flat motions are seen from before their plane.
export function firstLook(box) {
  const size = box.getSize(new THREE.Vector3());
  const most = Math.max(size.x, size.y, size.z);
  if (size.y < 0.06 * most && size.z >= 0.06 * most) return [-80, 10];
  if (size.x < 0.06 * most && size.z >= 0.06 * most) return [10, 10];
  if (size.z < 0.06 * most) return [-90, 52];
  return [-62, 22];
}

/// Sets the camera so that all points, [x, y, z, radius] each, are just in view; closer for a zoom above 1. Returns what
/// it looks at.
export function fit(camera, points, middle, aspect, [azimuth, elevation, zoom = 1]) {
  const [a, e] = [azimuth, elevation].map((angle) => (angle * Math.PI) / 180);
  const back = new THREE.Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
  const target = middle.clone();
  camera.position.copy(target).add(back);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  const [right, up] = [0, 1].map((column) => new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, column));
  const steep = Math.tan((fieldOfView * Math.PI) / 360);
  const at = new THREE.Vector3();
  let distance = 0;
  for (let round = 0; round < 3; ++round) {
    const need = { distance: 0, left: 0, right: 0, below: 0, above: 0 };
    const grow = (name, value) => (need[name] = Math.max(need[name], value));
    for (let i = 0; i < points.length; i += 4) {
      at.set(points[i], points[i + 1], points[i + 2]).sub(target);
      const [x, y, near, r] = [at.dot(right), at.dot(up), at.dot(back), points[i + 3]];
      grow("distance", near + Math.max((Math.abs(x) + r) / (steep * aspect), (Math.abs(y) + r) / steep));
      if (!distance) continue;
      grow("left", (r - x) / (distance - near));
      grow("right", (r + x) / (distance - near));
      grow("below", (r - y) / (distance - near));
      grow("above", (r + y) / (distance - near));
    }
    if (round === 1) {
      // To the middle of what is seen; the last round comes as near as that allows.
      target.addScaledVector(right, 0.5 * (need.right - need.left) * distance);
      target.addScaledVector(up, 0.5 * (need.above - need.below) * distance);
    } else {
      distance = need.distance || 1;
    }
  }
  camera.position.copy(target).addScaledVector(back, (1.08 * distance) / zoom);
  return target;
}
