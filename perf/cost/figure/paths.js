// The paths: two of x, y, z to equal scale, or one of them against time.

import * as Plot from "@observablehq/plot";
import { number } from "./data.js";

const axes = ["t", "x", "y", "z"];
const units = ["s", "m", "m", "m"];

function extent(paths, axis) {
  let [low, high] = [Infinity, -Infinity];
  for (const path of paths) {
    for (const point of path.points) {
      if (!Number.isFinite(point[axis])) continue;
      low = Math.min(low, point[axis]);
      high = Math.max(high, point[axis]);
    }
  }
  return low <= high ? [low, high] : [0, 1];
}

/// Of the reference where there is one: what runs away from it may leave the panel.
function extents(paths) {
  const reference = paths.filter((p) => p.label.startsWith("reference"));
  return axes.map((_, axis) => extent(reference.length ? reference : paths, axis));
}

export const projections = [
  [1, 2],
  [1, 3],
  [2, 3],
  [0, 1],
  [0, 2],
  [0, 3],
].map(([a, b]) => ({
  key: `${axes[a]}${axes[b]}`,
  name: a ? `${axes[a]} and ${axes[b]}` : `${axes[b]} against time`,
  across: a,
  up: b,
}));

/// The two axes along which most happens; a motion along one line, against time.
export function bestProjection(paths) {
  const length = extents(paths).map(([low, high]) => high - low);
  const order = [1, 2, 3].sort((a, b) => length[b] - length[a]);
  const pair = length[order[1]] > 1e-6 * length[order[0]] ? order.slice(0, 2).sort() : [0, order[0]];
  return projections.find((p) => p.across === pair[0] && p.up === pair[1]);
}

const widened = ([low, high], length) => [(low + high - length) / 2, (low + high + length) / 2];

export function pathFigure(paths, shown, colours, projection, width) {
  const { across, up } = projection;
  const all = extents(paths),
    long = (e) => e[1] - e[0];
  const inner = width - 80;
  let height = across ? Math.min(520, Math.max(160, (long(all[up]) / (long(all[across]) || 1)) * inner)) : 300;
  if (!Number.isFinite(height)) height = 300;
  let [x, y] = [long(all[across]) * 1.12 || 1, long(all[up]) * 1.12 || 1];
  if (across) {
    const metres = Math.max(x / inner, y / height); // of a pixel
    [x, y] = [metres * inner, metres * height];
  }
  const drawn = paths.filter((p) => shown.has(p.label));
  const points = drawn.flatMap((path) => path.points.map((point) => ({ path, point })));
  const within = { x: (d) => d.point[across], y: (d) => d.point[up] };
  const label = (axis) => `${axes[axis]} [${units[axis]}]`;
  return Plot.plot({
    width,
    height: height + 56,
    marginLeft: 60,
    marginRight: 20,
    marginTop: 10,
    marginBottom: 46,
    style: { background: "transparent", fontSize: "12px" },
    color: { type: "identity" },
    x: {
      domain: widened(all[across], x),
      label: label(across),
      labelAnchor: "center",
      labelArrow: "none",
      tickFormat: (v) => number(v),
      ticks: Math.floor(inner / 90),
    },
    y: {
      domain: widened(all[up], y),
      label: label(up),
      labelAnchor: "center",
      labelArrow: "none",
      tickFormat: (v) => number(v),
      ticks: Math.max(3, Math.floor(height / 60)),
    },
    marks: [
      Plot.frame({ stroke: "var(--line)" }),
      ...[...drawn]
        .sort((a, b) => a.label.startsWith("reference") - b.label.startsWith("reference"))
        .map((path) =>
          Plot.line(path.points, {
            x: (p) => p[across],
            y: (p) => p[up],
            stroke: colours.get(path.label),
            clip: true,
            strokeWidth: path.label.startsWith("reference") ? 1 : 2.4,
          }),
        ),
      Plot.tip(
        points,
        Plot.pointer({
          ...within,
          maxRadius: 20,
          fill: "var(--card)",
          stroke: "var(--line)",
          fontSize: 12,
          lineHeight: 1.35,
          title: ({ path, point }) =>
            `${path.label}\nbody ${path.body}, ${number(point[0])} s\n(${point
              .slice(1)
              .map((v) => number(v, 5))
              .join(", ")}) m`,
        }),
      ),
    ],
  });
}
