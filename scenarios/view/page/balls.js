// The bodies of one run. Quantised columns of two neighbouring frames are on the GPU; a step of one frame sends one.

import * as THREE from "three";
import { ballFragment, ballVertex } from "./shaders.js";
import { css, groupColour, runColour, scaleRange } from "./colours.js";
import { locate, periods, radii, span } from "./data.js";

// Points are the fastest, but their size on screen is limited and they vanish with their centre: few bodies get corners.
export const mostWithCorners = 4096;

const quad = () => new THREE.BufferAttribute(new Int8Array([-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0]), 3);

/// All bodies in an order in which the first few are as good as any.
function mixed(bodies) {
  const order = Uint32Array.from({ length: bodies }, (_, i) => i);
  for (let i = bodies - 1, random = 1; i > 0; --i) {
    random = (Math.imul(random, 1664525) + 1013904223) >>> 0;
    const other = Math.floor((random / 2 ** 32) * (i + 1));
    [order[i], order[other]] = [order[other], order[i]];
  }
  return order;
}

/// Two slots of a column: even frames in one, odd frames in the other.
class Slots {
  constructor(geometry, name, column, make) {
    this.column = column;
    this.attributes = [0, 1].map((slot) => {
      const attribute = make(column.frame(0), column.components);
      attribute.setUsage(THREE.DynamicDrawUsage);
      geometry.setAttribute(`${name}${slot}`, attribute);
      return attribute;
    });
    this.loaded = [0, 0];
  }

  /// Another column of the same form.
  use(column) {
    if (column !== this.column) this.loaded = [-1, -1];
    this.column = column;
  }

  show(...frames) {
    for (const frame of frames) {
      if (this.loaded[frame % 2] === frame) continue;
      const attribute = this.attributes[frame % 2];
      attribute.array = this.column.frame(frame);
      attribute.needsUpdate = true;
      this.loaded[frame % 2] = frame;
    }
  }
}

export class Balls {
  constructor(run, { smooth, map }) {
    this.run = run;
    const many = run.bodies > mostWithCorners;
    this.geometry = many ? new THREE.BufferGeometry() : new THREE.InstancedBufferGeometry();
    const make = many
      ? (array, size) => new THREE.BufferAttribute(array, size, true)
      : (array, size) => new THREE.InstancedBufferAttribute(array, size, true);
    if (many) this.geometry.setIndex(new THREE.BufferAttribute(mixed(run.bodies), 1));
    else this.geometry.setAttribute("position", quad()).setIndex([0, 1, 2, 2, 1, 3]).instanceCount = run.bodies;

    const { position, orientation } = run.columns;
    this.scalars = ["speed", "energy", "contacts"].filter((name) => run.columns[name]);
    this.slots = { place: new Slots(this.geometry, "place", position, make) };
    if (orientation) this.slots.turn = new Slots(this.geometry, "turn", orientation, make);
    const none = { components: 1, frame: () => new Uint8Array(run.bodies) };
    this.slots.value = new Slots(this.geometry, "value", run.columns[this.scalars[0]] ?? none, make);
    this.radius = radii(run);
    const radius = make(this.radius, 1);
    radius.normalized = false;
    this.geometry.setAttribute("radius", radius);
    this.tint = make(new Uint8Array(4 * run.bodies), 4);
    this.geometry.setAttribute("tint", this.tint);

    const { from, size } = span(run);
    const period = periods(run).map((length, axis) => (size[axis] > 0 ? length / size[axis] : 0));
    this.uniforms = {
      boxFrom: { value: new THREE.Vector3(...from) },
      boxSize: { value: new THREE.Vector3(...size) },
      period: { value: new THREE.Vector3(...period) },
      mixing: { value: 0 },
      valueMixing: { value: 0 },
      useMap: { value: 0 },
      mapRange: { value: new THREE.Vector2(0, 1) },
      map: { value: map },
      screen: { value: new THREE.Vector2(1, 1) },
      corner: { value: new THREE.Vector2() },
      pointPixels: { value: 3 },
      leastPixels: { value: 0.7 },
      room: { value: smooth ? 2 : 0 },
      stripes: { value: 1 },
      ambient: { value: 0.5 },
    };
    const defines = {};
    if (!many) defines.CORNERS = 1;
    if (smooth) defines.SMOOTH = 1;
    if (orientation) defines.TURNS = 1;
    const material = new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader: ballVertex,
      fragmentShader: ballFragment,
      uniforms: this.uniforms,
      defines,
      alphaToCoverage: smooth,
    });
    this.object = many ? new THREE.Points(this.geometry, material) : new THREE.Mesh(this.geometry, material);
    this.object.frustumCulled = false;
  }

  /// Draws that share of a crowd; few bodies are always drawn.
  thin(share) {
    if (this.object.isPoints) this.geometry.setDrawRange(0, Math.ceil(share * this.run.bodies));
  }

  /// Moves to a time; returns the frame and the way to the next.
  show(time) {
    const { frame, mix } = locate(this.run.times, time);
    const next = Math.min(frame + 1, this.run.frames - 1);
    for (const slots of Object.values(this.slots)) slots.show(frame, next);
    const toOdd = frame % 2 === 0 ? mix : 1 - mix;
    this.uniforms.mixing.value = toOdd;
    // A count belongs to its frame: it is not mixed.
    this.uniforms.valueMixing.value = this.colouring === "contacts" ? frame % 2 : toOdd;
    return { frame, mix };
  }

  /// Colours by a column with its scale, by group, by run, or plainly; call `show` after.
  colour(by, scale) {
    const column = scale && this.run.columns[by];
    this.colouring = by;
    this.uniforms.useMap.value = column ? 1 : 0;
    if (column) {
      this.slots.value.use(column);
      this.uniforms.mapRange.value.set(...scaleRange(scale, column));
    }
    const own = css(by === "run" ? runColour(this.run.index) : "--plain");
    this.run.header.groups.forEach(({ first, count, turns }, index) => {
      const colour = [...(by === "group" ? css(groupColour(index)) : own), turns ? 255 : 0];
      for (let i = first; i < first + count; ++i) this.tint.array.set(colour, 4 * i);
    });
    this.tint.needsUpdate = true;
  }
}
