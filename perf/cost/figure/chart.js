// Error against cost, drawn anew for each choice.

import * as Plot from "@observablehq/plot";
import { claimed, contactText, count, drawable, front, isScene, number, power, seconds, settingText } from "./data.js";
import { grey } from "./colours.js";
import { along, name } from "./labels.js";

const polygon = (corners, turned = 0) => ({
  draw(context, size) {
    const radius = Math.sqrt(size / Math.PI) * 1.2;
    for (let i = 0; i < corners; ++i) {
      const angle = turned - Math.PI / 2 + (2 * Math.PI * i) / corners;
      context[i ? "lineTo" : "moveTo"](radius * Math.cos(angle), radius * Math.sin(angle));
    }
    context.closePath();
  },
});
export function symbol(order) {
  if (order <= 1) return "circle";
  if (order === 2) return polygon(4, Math.PI / 4);
  if (order > 6) return "star";
  return polygon({ 3: 3, 4: 4, 5: 5, 6: 6 }[order]);
}

/// Decades for a logarithmic axis, thinned to what there is room for; 2 and 5 times where there are few.
function ticks([low, high], length, room) {
  const [first, last] = [Math.ceil(Math.log10(low) - 1e-9), Math.floor(Math.log10(high) + 1e-9)];
  const decade = length / Math.log10(high / low);
  const every = [1, 2, 3, 5, 10, 20, 50].find((n) => n * decade >= room) ?? 100;
  const found = [];
  for (let d = first - 1; d <= last; ++d) {
    for (const factor of decade * 0.3 >= room ? [1, 2, 5] : [1]) {
      const value = Number(`${factor}e${d}`);
      if (d % every === 0 && value >= low * 0.999 && value <= high * 1.001) found.push(value);
    }
  }
  return found;
}

function evenTicks([low, high], n) {
  const least = (high - low) / n,
    size = 10 ** Math.floor(Math.log10(least));
  const step = size * [1, 2, 5, 10].find((factor) => factor * size >= least * 0.999);
  return Array.from(
    { length: Math.floor(high / step) - Math.ceil(low / step) + 1 },
    (_, i) => (Math.ceil(low / step) + i) * step,
  );
}

function logDomain(values, floor, cap) {
  const positive = values.filter((v) => v > 0).map((v) => Math.min(v, cap));
  let low = positive.length ? Math.log10(Math.min(...positive)) - 0.35 : Math.log10(floor || 1e-12) - 1;
  let high = positive.length ? Math.log10(Math.max(...positive)) + 0.35 : low + 3;
  if (floor > 0 && Math.log10(floor) > low - 3) {
    low = Math.max(Math.min(low, Math.log10(floor) - 0.8), Math.log10(floor) - 2.5);
    high = Math.max(high, Math.log10(floor) + 1);
  }
  const lack = Math.max(0, 1 - (high - low)) / 2;
  return [10 ** (low - lack), 10 ** (high + lack)];
}

function axis(log, values, length, room, text, { floor = 0, cap = Infinity } = {}) {
  const domain = log
    ? logDomain(values, floor, cap)
    : [0, Math.max(...values.filter(Number.isFinite), Number.MIN_VALUE) * 1.05 || 1];
  return {
    type: log ? "log" : "linear",
    domain,
    clamp: true,
    ticks: log ? ticks(domain, length, room) : evenTicks(domain, Math.max(3, Math.floor(length / (1.6 * room)))),
    tickFormat: text,
  };
}

function about(point, curve, measure) {
  const lines = [settingText(point), `${curve.family}, order ${curve.order || "?"}, ${point.precision}`];
  if (point.contact) lines.push(contactText(point.contact));
  lines.push(
    `error ${number(measure.of(point))} ${measure.unit}${claimed(point, measure) ? "" : " (not claimed)"}`,
    `${seconds(point.seconds.min)} fastest, ${seconds(point.seconds.median)} median, ${seconds(point.seconds.max)} slowest of ${point.seconds.runs}`,
    `${count(point.steps)} steps${point.rejected_steps ? `, ${count(point.rejected_steps)} rejected` : ""}`,
    `${count(point.force_evaluations)} force evaluations`,
    `state ${point.state_hash}`,
  );
  return lines.join("\n");
}

function frontLine(points, x, y, xDomain, yDomain) {
  const corners = [...points].reverse().map((p) => [x(p), y(p)]);
  if (!corners.length) return [];
  return [[corners[0][0], yDomain[1]], ...corners, [xDomain[1], corners.at(-1)[1]]];
}

function curveMarks(curve, points, { x, y, colour, measure }) {
  const className = `curve-${curve.index}`;
  const strong = colour !== grey;
  return [
    Plot.line(points, {
      x,
      y,
      stroke: colour,
      strokeWidth: strong ? 2 : 1,
      className: `${className} curve`,
      clip: true,
      strokeDasharray: curve.precision === "single" ? "5 3" : undefined,
      strokeOpacity: points.every((p) => claimed(p, measure)) ? 1 : 0.75,
    }),
    Plot.dot(points, {
      x,
      y,
      symbol: symbol(curve.order),
      r: strong ? 4 : 2.5,
      stroke: colour,
      strokeWidth: 1,
      fill: (p) => (claimed(p, measure) ? colour : "var(--plot)"),
      className: `${className} dots`,
      strokeOpacity: (p) => (claimed(p, measure) ? 1 : 0.6),
    }),
  ];
}

const cssRing = { r: 9, strokeWidth: 2, stroke: "var(--ink)", fill: "none" };

function plan(view) {
  const { result, shown, measure, cost, logError, logCost, width } = view;
  const height = Math.round(Math.min(620, Math.max(380, width * 0.66)));
  const curves = result.curves
    .filter((curve) => shown.has(curve))
    .map((curve) => ({
      curve,
      points: curve.points.map((i) => result.points[i]).filter((p) => drawable(p, measure, cost)),
    }));
  const points = curves.flatMap((c) => c.points);
  const scale = result.reference?.scale?.[measure.group];
  const margins = { marginLeft: 68, marginRight: 20, marginTop: 16, marginBottom: 34 };
  const xAxis = axis(logError, points.map(measure.of), width - 90, 44, logError ? power : (v) => number(v), {
    floor: measure.floor,
    cap: scale > 0 ? 100 * scale : Infinity,
  });
  const spent = points.length ? points.map(cost.of) : cost.text === seconds ? [1e-5, 1e-2] : [1e2, 1e5];
  const yAxis = axis(logCost, spent, height - 50, 24, cost.text);
  if (logCost) yAxis.domain[1] *= 1.4;
  const clampTo = (value, [low, high]) => Math.min(Math.max(value, low), high);
  return {
    curves,
    points,
    height,
    margins,
    xAxis,
    yAxis,
    x: (p) => clampTo(measure.of(p), xAxis.domain),
    y: (p) => clampTo(cost.of(p), yAxis.domain),
  };
}

function nameAll(svg, view, { curves, points, x, y, height }, special) {
  const xs = svg.plot.scale("x"),
    ys = svg.plot.scale("y");
  const at = (p) => [xs.apply(x(p)), ys.apply(y(p))];
  const names = special.map(({ point, text }) => ({ text, colour: "var(--ink)", anchors: [at(point)], ring: true }));
  for (const { curve, points: own } of curves) {
    if (!own.length || view.colour(curve) === grey) continue;
    const anchors = own.map(at);
    names.push({
      text: curve.label,
      colour: view.colour(curve),
      anchors: [anchors.at(-1), anchors[0], ...anchors.slice(1, -1).reverse()],
    });
  }
  const avoid = curves
    .filter(({ curve }) => view.colour(curve) !== grey)
    .flatMap(({ points: own }) => along(own.map(at)));
  if (view.measure.floor > xs.domain[0])
    avoid.push(
      ...along([
        [80, height - 40],
        [80, height - 240],
      ]),
    ); // words along the edge
  name(svg, names, avoid.concat(points.map(at)), { left: 70, top: 16, right: view.width - 4, bottom: height - 36 });
}

/// Returns {figure, front}: the picture, which tells of the point under the pointer by `onPoint`.
export function chart(view) {
  const { result, measure, cost, width, onPoint } = view;
  const p = plan(view),
    { x, y } = p;
  const best = front(p.points, measure, cost);
  const recommended = result.recommended ? result.points[result.recommended.point] : null;
  const special = p.points
    .filter((q) => q === recommended || isScene(q, result.scene))
    .map((q) => ({
      point: q,
      dashed: q !== recommended,
      text:
        q !== recommended
          ? "as the scene has it"
          : isScene(q, result.scene)
            ? "recommended, as the scene has it"
            : "recommended",
    }));
  const floor = measure.floor > p.xAxis.domain[0] ? [Math.min(measure.floor, p.xAxis.domain[1])] : [];
  const strongLast = [...p.curves].sort((a, b) => (view.colour(a.curve) !== grey) - (view.colour(b.curve) !== grey));
  const figure = Plot.plot({
    width,
    height: p.height,
    ...p.margins,
    style: { background: "transparent", overflow: "visible" },
    x: { ...p.xAxis, label: null },
    y: { ...p.yAxis, label: null },
    color: { type: "identity" },
    marks: [
      Plot.rectX(floor, { x1: p.xAxis.domain[0], x2: (v) => v, fill: "var(--floor)" }),
      Plot.gridX(p.xAxis.ticks, { stroke: "var(--grid)", strokeOpacity: 1 }),
      Plot.gridY(p.yAxis.ticks, { stroke: "var(--grid)", strokeOpacity: 1 }),
      Plot.frame({ stroke: "var(--line)" }),
      Plot.axisX(p.xAxis.ticks, { text: p.xAxis.tickFormat, label: null, fontSize: 12, color: "var(--soft)" }),
      Plot.axisY(p.yAxis.ticks, { text: p.yAxis.tickFormat, label: null, fontSize: 12, color: "var(--soft)" }),
      Plot.line(frontLine(best, x, y, p.xAxis.domain, p.yAxis.domain), {
        curve: "step-after",
        stroke: "var(--front)",
        strokeWidth: 7,
        strokeLinejoin: "round",
        className: "front",
      }),
      ...strongLast.flatMap(({ curve, points }) =>
        curveMarks(curve, points, { x, y, colour: view.colour(curve), measure }),
      ),
      Plot.dot(
        special.filter((s) => !s.dashed).map((s) => s.point),
        { x, y, ...cssRing },
      ),
      Plot.dot(
        special.filter((s) => s.dashed).map((s) => s.point),
        { x, y, ...cssRing, strokeDasharray: "3 2.5" },
      ),
      Plot.text(floor, {
        x: p.xAxis.domain[0],
        text: (v) => `no error below ${number(v)} ${measure.unit} is claimed`,
        frameAnchor: "bottom-left",
        rotate: -90,
        dx: 12,
        dy: -8,
        textAnchor: "start",
        fill: "var(--floor-ink)",
        fontSize: 11,
      }),
      Plot.text(p.points.length ? [] : ["nothing to draw: no curve is chosen, or none gave this error"], {
        frameAnchor: "middle",
        fontSize: 14,
        fill: "var(--soft)",
      }),
      Plot.tip(
        p.points,
        Plot.pointer({
          x,
          y,
          title: (q) => about(q, result.curves[q.curve], measure),
          fill: "var(--card)",
          stroke: "var(--line)",
          fontSize: 12,
          lineWidth: 40,
          lineHeight: 1.35,
          textPadding: 10,
          maxRadius: 30,
        }),
      ),
    ],
  });
  const svg = figure.tagName === "svg" ? figure : figure.querySelector("svg:last-of-type");
  svg.plot = figure;
  nameAll(svg, view, p, special);
  svg.append([...svg.children].find((g) => g.getAttribute("aria-label") === "tip") ?? document.createComment(""));
  figure.addEventListener("input", () => onPoint(figure.value));
  return { figure, front: best };
}
