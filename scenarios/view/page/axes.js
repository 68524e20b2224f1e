// The axes of turning bodies, as ribbons of even width on screen: red, green and blue for x, y and z of the body.

import * as THREE from "three";
import { motion } from "./shaders.js";
import { css } from "./colours.js";

const vertex = /* glsl */ `
precision highp float;
${motion}
in vec3 position;  // axis, end, side
in float radius;
in vec4 tint;
uniform vec2 screen;
uniform float reach, wide;
uniform vec3 axisColours[3];
flat out vec3 colour;

vec3 turnedBy(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

void main() {
  int axis = int(position.x);
  colour = axisColours[axis];
  vec3 way = turnedBy(turned(), vec3(equal(ivec3(axis), ivec3(0, 1, 2))));
  float length = radius > 0.0 ? 1.7 * radius : reach;
  vec4 root = projectionMatrix * modelViewMatrix * vec4(place(), 1.0);
  vec4 tip = projectionMatrix * modelViewMatrix * vec4(place() + length * way, 1.0);
  vec2 along = (tip.xy / tip.w - root.xy / root.w) * screen;
  vec2 across = dot(along, along) > 0.0 ? normalize(vec2(-along.y, along.x)) : vec2(1.0, 0.0);
  gl_Position = position.y > 0.5 ? tip : root;
  gl_Position.xy += across * position.z * wide / screen * gl_Position.w;
  if (tint.a < 0.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
`;
const fragment = /* glsl */ `
precision highp float;
flat in vec3 colour;
out vec4 seen;
void main() { seen = vec4(colour, 1.0); }
`;

/// Shares the columns of `balls`, which have corners and orientations.
export function axes(balls, reach) {
  const corners = [];
  const index = [];
  for (let axis = 0; axis < 3; ++axis) {
    for (const [end, side] of [
      [0, -1],
      [0, 1],
      [1, -1],
      [1, 1],
    ])
      corners.push(axis, end, side);
    index.push(...[0, 1, 2, 2, 1, 3].map((i) => 4 * axis + i));
  }
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.instanceCount = balls.run.bodies;
  for (const [name, attribute] of Object.entries(balls.geometry.attributes)) geometry.setAttribute(name, attribute);
  geometry.setAttribute("position", new THREE.BufferAttribute(new Int8Array(corners), 3));
  geometry.setIndex(index);
  const material = new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader: vertex,
    fragmentShader: fragment,
    uniforms: {
      ...balls.uniforms,
      reach: { value: reach },
      wide: { value: 3 },
      axisColours: { value: [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()] },
    },
    defines: { TURNS: 1 },
    side: THREE.DoubleSide,
  });
  const object = new THREE.Mesh(geometry, material);
  object.frustumCulled = false;
  const recolour = () =>
    ["--axis-x", "--axis-y", "--axis-z"].forEach((name, i) =>
      material.uniforms.axisColours.value[i].set(...css(name).map((v) => v / 255)),
    );
  return { object, recolour, wide: material.uniforms.wide };
}
