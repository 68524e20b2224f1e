// Where bodies have been: lines through the frames up to now, brighter where it was lately.

import * as THREE from "three";
import { css, groupColour, runColour } from "./colours.js";
import { periods, present, span } from "./data.js";

export const mostWithPaths = 64;

const vertex = /* glsl */ `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec3 boxFrom, boxSize;
uniform float now, lately;
uniform int bodies;
in vec3 position;
in vec3 tint;
out float age;
out vec3 colour;
void main() {
  age = (now - float(gl_VertexID / bodies)) / lately;
  colour = tint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(boxFrom + boxSize * position, 1.0);
}
`;
const fragment = /* glsl */ `
precision highp float;
in float age;
in vec3 colour;
out vec4 seen;
void main() {
  if (age < 0.0) discard;
  seen = vec4(colour, 0.16 + 0.64 * exp(-age));
}
`;

/// Pairs of neighbouring frames of each body, without those between which space repeats.
function pieces(run) {
  const { values } = run.columns.position;
  const { size } = span(run);
  const half = periods(run).map((length, axis) => (length > 0 ? (0.5 * length * 65535) / size[axis] : Infinity));
  const index = [];
  for (let from = 0; from < (run.frames - 1) * run.bodies; ++from) {
    const to = from + run.bodies;
    if (!present(values, from) || !present(values, to)) continue;
    if (half.every((limit, axis) => Math.abs(values[3 * to + axis] - values[3 * from + axis]) < limit)) {
      index.push(from, to);
    }
  }
  return index;
}

/// {object, show(frame, mix), colour(by)}
export function paths(run) {
  const { from, size } = span(run);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(run.columns.position.values, 3, true));
  const tint = new THREE.BufferAttribute(new Uint8Array(3 * run.frames * run.bodies), 3, true);
  geometry.setAttribute("tint", tint);
  geometry.setIndex(pieces(run));
  const uniforms = {
    boxFrom: { value: new THREE.Vector3(...from) },
    boxSize: { value: new THREE.Vector3(...size) },
    now: { value: 0 },
    lately: { value: Math.max(run.frames / 12, 2) },
    bodies: { value: run.bodies },
  };
  const object = new THREE.LineSegments(
    geometry,
    new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms,
      transparent: true,
      depthWrite: false,
    }),
  );
  object.frustumCulled = false;
  return {
    object,
    show: (frame, mix) => (uniforms.now.value = frame + mix),
    colour(by) {
      run.header.groups.forEach(({ first, count }, index) => {
        const colour = css(by === "run" ? runColour(run.index) : by === "group" ? groupColour(index) : "--plain");
        for (let f = 0; f < run.frames; ++f) {
          for (let i = first; i < first + count; ++i) tint.array.set(colour, 3 * (f * run.bodies + i));
        }
      });
      tint.needsUpdate = true;
    },
  };
}
