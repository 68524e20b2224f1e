// Boundaries as faint lines: planes as finite grids, boxes by their edges, tubes by rings; they move as they did.

import * as THREE from "three";
import { css } from "./colours.js";

const vertex = /* glsl */ `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
in float strength;
out float shown;
void main() {
  shown = strength;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`;
const fragment = /* glsl */ `
precision highp float;
uniform vec3 colour;
in float shown;
out vec4 seen;
void main() { seen = vec4(colour, shown); }
`;

const sides = ["x", "y", "z"];
const v3 = (list) => new THREE.Vector3(...list);

/// 1, 2 or 5 times a power of ten, at least that large.
export function roundUp(least) {
  const size = 10 ** Math.floor(Math.log10(least));
  return size * [1, 2, 5, 10].find((factor) => factor * size >= least * 0.9999);
}

/// Lines, each end with its strength.
class Drawing {
  points = [];
  strengths = [];

  line(from, to, strength = 0.8, other = strength) {
    this.points.push(...from, ...to);
    this.strengths.push(strength, other);
  }

  object(uniforms) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(this.points, 3));
    geometry.setAttribute("strength", new THREE.Float32BufferAttribute(this.strengths, 1));
    const material = new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms,
      transparent: true,
      depthWrite: false,
    });
    const object = new THREE.LineSegments(geometry, material);
    object.frustumCulled = false;
    return object;
  }
}

/// Two directions across a normal; along the axes of space where they can be.
function across(normal) {
  const n = v3(normal).normalize();
  const axis = [n.x, n.y, n.z].map(Math.abs);
  const first = v3([1, 0, 0]);
  if (axis[0] > 0.9) first.set(0, 1, 0);
  const u = first.addScaledVector(n, -first.dot(n)).normalize();
  return { n, u, v: new THREE.Vector3().crossVectors(n, u) };
}

/// Half of how far a box reaches along a direction.
const reach = (size, way) => 0.5 * (Math.abs(size.x * way.x) + Math.abs(size.y * way.y) + Math.abs(size.z * way.z));

/// A grid under or beside the motion, on round coordinates, that fades towards its edge.
function plane(drawing, { point = [0, 0, 0], normal = [0, 0, 1] }, room) {
  const { n, u, v } = across(normal);
  const size = room.getSize(new THREE.Vector3());
  const middle = room.getCenter(new THREE.Vector3());
  middle.addScaledVector(n, v3(point).sub(middle).dot(n));
  const whole = Math.max(size.x, size.y, size.z);
  const step = roundUp(whole / 16);
  const half = [u, v].map((way) => Math.max(1.3 * reach(size, way), 0.3 * whole));
  const range = [u, v].map((way, i) => {
    const at = middle.dot(way);
    return [Math.floor((at - half[i]) / step), Math.ceil((at + half[i]) / step)];
  });
  const base = n.clone().multiplyScalar(middle.dot(n));
  const at = (a, b) =>
    base
      .clone()
      .addScaledVector(u, a * step)
      .addScaledVector(v, b * step);
  const fade = (x, [low, high]) => Math.min(1, (2.2 * Math.min(x - low, high - x)) / (high - low));
  const faint = (a, b) => 0.55 * Math.min(fade(a, range[0]), fade(b, range[1]));
  for (let a = range[0][0]; a <= range[0][1]; ++a) {
    for (let b = range[1][0]; b <= range[1][1]; ++b) {
      if (a < range[0][1]) drawing.line(at(a, b), at(a + 1, b), faint(a, b), faint(a + 1, b));
      if (b < range[1][1]) drawing.line(at(a, b), at(a, b + 1), faint(a, b), faint(a, b + 1));
    }
  }
}

/// The least and the highest corner of a box, given by them or by its centre and edges. On its open sides it is drawn
/// as far as the motion goes: walls without a lid say nothing by their height.
function corners({ min, max, point = [0, 0, 0], size, open = [] }, room) {
  const low = min ?? point.map((p, i) => p - size[i] / 2);
  const high = max ?? point.map((p, i) => p + size[i] / 2);
  return [
    low.map((x, i) => (open.includes(`-${sides[i]}`) ? Math.max(x, room.min.getComponent(i)) : x)),
    high.map((x, i) => (open.includes(`+${sides[i]}`) ? Math.min(x, room.max.getComponent(i)) : x)),
  ];
}

function box(drawing, boundary, room, strength = 0.8, dashes = 0) {
  const [low, high] = corners(boundary, room);
  const open = boundary.open ?? [];
  for (let axis = 0; axis < 3; ++axis) {
    const others = [0, 1, 2].filter((i) => i !== axis);
    for (let corner = 0; corner < 4; ++corner) {
      const from = [...low];
      const faces = others.map((i, bit) => {
        const upper = Boolean((corner >> bit) & 1);
        from[i] = upper ? high[i] : low[i];
        return `${upper ? "+" : "-"}${sides[i]}`;
      });
      if (faces.every((face) => open.includes(face))) continue;
      const to = [...from];
      to[axis] = high[axis];
      segment(drawing, from, to, strength, dashes);
    }
  }
}

function segment(drawing, from, to, strength, dashes) {
  if (!dashes) return drawing.line(from, to, strength);
  const at = (share) => from.map((x, i) => x + share * (to[i] - x));
  for (let i = 0; i < dashes; ++i) drawing.line(at((i + 0.2) / dashes), at((i + 0.8) / dashes), strength);
}

/// Where space repeats, as a box; along an axis where it does not, as far as the motion goes.
const repeated = ({ point = [0, 0, 0], size }, room) => ({
  min: size.map((length, i) => (length > 0 ? point[i] - length / 2 : room.min.getComponent(i))),
  max: size.map((length, i) => (length > 0 ? point[i] + length / 2 : room.max.getComponent(i))),
});

/// A place on a tube, by an angle and how far along the motion it is, -1 to 1.
function tubePlace({ point = [0, 0, 0], normal = [0, 0, 1], radius }, room) {
  const { n, u, v } = across(normal);
  const along = room.getCenter(new THREE.Vector3()).sub(v3(point)).dot(n);
  const half = Math.max(1.02 * reach(room.getSize(new THREE.Vector3()), n), 0.5 * radius);
  return (angle, share) =>
    v3(point)
      .addScaledVector(u, radius * Math.cos(angle))
      .addScaledVector(v, radius * Math.sin(angle))
      .addScaledVector(n, along + share * half);
}

/// Rings and lines along a tube.
function tube(drawing, boundary, room) {
  const at = tubePlace(boundary, room);
  const [rings, pieces] = [5, 96];
  for (let i = 0; i < pieces; ++i) {
    const [angle, next] = [i, i + 1].map((k) => (2 * Math.PI * k) / pieces);
    for (let ring = 0; ring < rings; ++ring) {
      const share = (2 * ring) / (rings - 1) - 1;
      drawing.line(at(angle, share), at(next, share), Math.abs(share) === 1 ? 0.8 : 0.4);
    }
    if (i % 12 === 0) drawing.line(at(angle, -1), at(angle, 1), 0.4);
  }
}

/// How far a boundary has moved from where the scene has it.
function displacement({ velocity = [0, 0, 0], amplitude = [0, 0, 0], frequency = 0, phase = 0 }, t) {
  const swing = Math.sin(2 * Math.PI * frequency * t + phase) - Math.sin(phase);
  return velocity.map((v, i) => v * t + amplitude[i] * swing);
}

/// Those of one run; room: a box around the motion with its bodies.
export function boundaries(run, room) {
  const object = new THREE.Group();
  const uniforms = { colour: { value: new THREE.Vector3() } };
  const moving = [];
  for (const boundary of run.header.boundaries) {
    const drawing = new Drawing();
    if (boundary.shape === "plane") plane(drawing, boundary, room);
    else if (boundary.shape === "box") box(drawing, boundary, room);
    else if (boundary.shape === "tube") tube(drawing, boundary, room);
    else if (boundary.shape === "periodic") box(drawing, repeated(boundary, room), room, 0.7, 24);
    const lines = drawing.object(uniforms);
    object.add(lines);
    if (boundary.motion) moving.push({ lines, motion: boundary.motion });
  }
  return {
    object,
    show(time) {
      for (const { lines, motion } of moving) lines.position.set(...displacement(motion, time));
    },
    recolour: () => uniforms.colour.value.set(...css("--boundary").map((v) => v / 255)),
  };
}

function pointsOf(b, room, reachable) {
  if (b.shape === "plane") {
    const { n } = across(b.normal ?? [0, 0, 1]);
    const middle = room.getCenter(new THREE.Vector3());
    return [
      middle.addScaledVector(
        n,
        v3(b.point ?? [0, 0, 0])
          .sub(middle)
          .dot(n),
      ),
    ];
  }
  if (b.shape === "tube") {
    const at = tubePlace(b, room);
    return Array.from({ length: 16 }, (_, i) => at((i * Math.PI) / 4, i < 8 ? -1 : 1));
  }
  const [low, high] = corners(b.shape === "periodic" ? repeated(b, room) : b, room);
  const near = new THREE.Box3(v3(low), v3(high)).intersect(reachable);
  if (near.isEmpty()) return [];
  return Array.from({ length: 8 }, (_, i) =>
    v3(sides.map((side, bit) => ((i >> bit) & 1 ? near.max : near.min)[side])),
  );
}

/// What the first view should hold beside the motion, of boundaries that are not far larger or away.
export function boundaryPoints(run, room) {
  const size = room.getSize(new THREE.Vector3());
  const reachable = room.clone().expandByScalar(0.75 * Math.max(size.x, size.y, size.z));
  return run.header.boundaries
    .filter(({ shape }) => ["plane", "box", "tube", "periodic"].includes(shape))
    .flatMap((b) => pointsOf(b, room, reachable))
    .filter((point) => reachable.containsPoint(point));
}
