// The picture: one camera, one or more views of it side by side on one canvas, drawn when something has changed.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Balls, mostWithCorners as mostWithAxes } from "./balls.js";
import { axes } from "./axes.js";
import { boundaries, boundaryPoints } from "./boundaries.js";
import { fieldOfView, firstLook, fit, motionBox, moves, samples } from "./camera.js";
import { css, mapTexels } from "./colours.js";
import { mostWithPaths, paths } from "./paths.js";

// So many balls are drawn with smooth edges; of more the edges are too many.
const mostSmooth = 4096;

export class Scene {
  constructor(canvas, runs, changed) {
    const smooth = runs.reduce((sum, run) => sum + run.bodies, 0) <= mostSmooth;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: smooth, powerPreference: "high-performance" });
    this.renderer.sortObjects = false;
    this.renderer.autoClear = false;
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // colours are as in the style sheet
    this.map = new THREE.DataTexture(mapTexels(false), 256, 1);
    this.map.magFilter = this.map.minFilter = THREE.NearestFilter;
    this.camera = new THREE.PerspectiveCamera(fieldOfView, 1, 0.1, 10);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    for (const event of ["start", "change", "end"]) this.controls.addEventListener(event, changed);
    this.controls.addEventListener("start", () => (this.dragged = this.touched = true));
    this.controls.addEventListener("end", () => (this.dragged = false));

    this.parts = runs.map((run) => this.part(run, smooth));
    this.look = firstLook(this.parts.reduce((sum, part) => sum.union(part.motion), new THREE.Box3()));
    this.box = this.parts.reduce((sum, part) => sum.union(part.room), new THREE.Box3());
    this.points = this.parts.flatMap((part) => part.points);
    this.crowd = this.parts.some((part) => part.balls.object.isPoints);
    this.views = 1;
    this.canvas = canvas;
  }

  part(run, smooth) {
    const motion = motionBox(run);
    const around = boundaryPoints(run, motion);
    const room = motion.clone();
    for (const point of around) room.expandByPoint(point);
    const size = room.getSize(new THREE.Vector3());
    const reach = (moves(run) ? 0.12 : 0.45) * Math.max(size.x, size.y, size.z);
    const withAxes = run.columns.orientation && run.bodies <= mostWithAxes;
    const points = samples(run, !withAxes ? 0 : moves(run) ? 0.4 * reach : reach).concat(
      around.flatMap((point) => [...point, 0]),
    );
    const part = { run, motion, room, points, group: new THREE.Scene() };
    part.balls = new Balls(run, { smooth, map: this.map });
    part.boundaries = boundaries(run, motion);
    part.group.add(part.boundaries.object, part.balls.object);
    if (run.bodies <= mostWithPaths && moves(run)) part.group.add((part.paths = paths(run)).object);
    if (withAxes) part.group.add((part.axes = axes(part.balls, reach)).object);
    return part;
  }

  /// Looks at everything, from a direction in degrees.
  fit(look = this.look) {
    this.fitted = look;
    this.touched = false;
    const [, , width, height] = this.area(0);
    const middle = this.box.getCenter(new THREE.Vector3());
    this.controls.target.copy(fit(this.camera, this.points, middle, width / height, look));
    this.controls.update();
  }

  /// Where view i is on the canvas, in CSS pixels: x, y from below, width, height.
  area(i) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const beside = width >= height * 0.9;
    const [columns, rows] = grid(this.views, beside);
    const [column, row] = [i % columns, Math.floor(i / columns)];
    const [x, y] = [Math.round((column * width) / columns), Math.round(((rows - 1 - row) * height) / rows)];
    return [x, y, Math.round(((column + 1) * width) / columns) - x, Math.round(((rows - row) * height) / rows) - y];
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight, false);
  }

  /// Colours, and what is drawn at all.
  style({ colour, scale, dark, stripes, axes: showAxes, paths: showPaths, boundaries: showBoundaries }) {
    this.renderer.setClearColor(new THREE.Color(...css("--scene").map((v) => v / 255)), 1);
    this.map.image.data.set(mapTexels(dark, scale?.steps ?? 0));
    this.map.needsUpdate = true;
    for (const { balls, axes: own, paths: trail, boundaries: walls } of this.parts) {
      balls.colour(colour, scale);
      balls.uniforms.stripes.value = stripes ? 1 : 0;
      balls.uniforms.ambient.value = dark ? 0.46 : 0.6;
      walls.recolour();
      walls.object.visible = showBoundaries;
      trail?.colour(colour);
      if (trail) trail.object.visible = showPaths;
      own?.recolour();
      if (own) own.object.visible = showAxes;
    }
  }

  show(time) {
    for (const { balls, paths: trail, boundaries: walls } of this.parts) {
      const { frame, mix } = balls.show(time);
      trail?.show(frame, mix);
      walls.show(time);
    }
  }

  /// One view for each run, or all runs in one; while something moves perhaps a share of a crowd.
  draw(share = 1) {
    for (const { balls } of this.parts) balls.thin(share);
    this.renderer.setScissorTest(true);
    for (let view = 0; view < this.views; ++view) {
      const area = this.area(view);
      this.renderer.setViewport(...area);
      this.renderer.setScissor(...area);
      this.renderer.clear();
      this.camera.aspect = area[2] / area[3];
      this.depthRange();
      for (const part of this.views > 1 ? [this.parts[view]] : this.parts) this.drawPart(part, area);
    }
  }

  drawPart({ balls, axes: own, group }, area) {
    const ratio = this.renderer.getPixelRatio();
    const [x, y, width, height] = area.map((length) => Math.floor(length * ratio));
    const { screen, corner, pointPixels } = balls.uniforms;
    screen.value.set(width, height);
    corner.value.set(x, y);
    pointPixels.value = ratio * (balls.run.bodies <= 100 ? 6 : balls.run.bodies <= 5000 ? 3 : 1.25);
    if (own) own.wide.value = ratio * (balls.run.bodies <= 10 ? 4.5 : 3);
    this.renderer.render(group, this.camera);
  }

  /// Waits until all is drawn.
  finish() {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /// As narrow as everything allows, so that depths are told apart.
  depthRange() {
    const sphere = this.box.getBoundingSphere(new THREE.Sphere());
    const distance = this.camera.position.distanceTo(sphere.center);
    this.camera.far = distance + 4 * sphere.radius;
    this.camera.near = Math.max(distance - 2 * sphere.radius, 1e-3 * Math.min(distance, sphere.radius), 1e-12);
    this.camera.updateProjectionMatrix();
  }
}

/// Columns and rows for some views: in one line while they are few.
function grid(views, beside) {
  if (views <= 3) return beside ? [views, 1] : [1, views];
  const columns = Math.ceil(Math.sqrt(views * (beside ? 1 : 0.5)));
  return [columns, Math.ceil(views / columns)];
}
