// Small plots of series over time, one below or beside the other, that show and set the time.

import { number } from "../../../perf/cost/figure/data.js";
import { roundUp } from "./boundaries.js";
import { runColour } from "./colours.js";
import { locate } from "./data.js";
import { make, svg } from "./dom.js";

const height = 104;
const margin = { left: 58, right: 10, top: 8, bottom: 20 };

/// Series of one name in all runs that have it.
function collect(runs) {
  const names = [...new Set(runs.flatMap((run) => (run.header.series ?? []).map((s) => s.name)))];
  return names
    .map((name) => {
      const of = runs.map((run) => ({ run, series: (run.header.series ?? []).find((s) => s.name === name) }));
      const lines = of.filter(({ series }) => series?.values.some(Number.isFinite));
      return { name, unit: lines[0]?.series.unit ?? "", lines };
    })
    .filter(({ lines }) => lines.length);
}

/// The values' range; where they barely change, what is drawn is the change since the start.
function range(lines) {
  const values = lines.flatMap(({ series }) => series.values.filter(Number.isFinite));
  const extremes = (list) => [list.reduce((a, b) => Math.min(a, b)), list.reduce((a, b) => Math.max(a, b))];
  const [low, high] = extremes(values);
  const size = Math.max(Math.abs(low), Math.abs(high));
  const start = lines[0].series.values.find(Number.isFinite);
  if (high - low > 2e-3 * size || high === low) return { from: 0, low, high };
  return { from: start, low: low - start, high: high - start };
}

function ticks(low, high, most) {
  if (!(high > low)) return [low];
  const step = roundUp((high - low) / most);
  const found = [];
  for (let i = Math.ceil(low / step - 1e-6); i * step <= high + 1e-6 * step; ++i) found.push(i * step);
  return found;
}

function curve(times, values, x, y, from) {
  let path = "";
  let pen = false;
  values.forEach((value, i) => {
    if (!Number.isFinite(value)) return void (pen = false);
    path += `${pen ? "L" : "M"}${x(times[i]).toFixed(1)} ${y(value - from).toFixed(1)}`;
    pen = true;
  });
  return path;
}

const signed = (change) => `${change < 0 ? "\u2212" : "+"} ${number(Math.abs(change), 2)}`;

class Plot {
  constructor(parent, { name, unit, lines }, { several, span, writer, scrub }) {
    Object.assign(this, { name, unit, lines, several, span, writer });
    this.range = range(lines);
    const figure = make(parent, "figure", { className: "plot" });
    const caption = make(figure, "figcaption");
    make(caption, "span", { className: "name" }, name);
    this.readings = lines.map(({ run }) => {
      const reading = make(caption, "span", { className: "reading" });
      if (several) reading.style.color = `var(${runColour(run.index)})`;
      return reading;
    });
    this.picture = svg(figure, "svg", { height, role: "img", "aria-label": `${name} over time` });
    const timeAt = (event) => {
      const at = event.clientX - this.picture.getBoundingClientRect().left;
      const share = (at - margin.left) / (this.width - margin.left - margin.right);
      return span[0] + Math.min(Math.max(share, 0), 1) * (span[1] - span[0]);
    };
    this.picture.onpointerdown = (event) => {
      this.picture.setPointerCapture(event.pointerId);
      scrub(timeAt(event));
    };
    this.picture.onpointermove = (event) => event.buttons && scrub(timeAt(event));
  }

  resize() {
    const width = Math.max(this.picture.parentElement.clientWidth, 160);
    if (width === this.width) return;
    this.width = width;
    this.picture.setAttribute("width", width);
    const { low, high, from } = this.range;
    const [bottom, top] = [height - margin.bottom, margin.top];
    const slack = high > low ? 0.06 * (high - low) : 0.5 * (Math.abs(low) || 1);
    this.x = (t) =>
      margin.left + ((t - this.span[0]) / (this.span[1] - this.span[0] || 1)) * (width - margin.left - margin.right);
    this.y = (v) => bottom - ((v - low + slack) / (high - low + 2 * slack)) * (bottom - top);
    this.picture.replaceChildren();
    this.drawAxes(ticks(low, high, 5), from, bottom, top);
    for (const { run, series } of this.lines) {
      const d = curve(run.times, series.values, this.x, this.y, from);
      const colour = this.several ? runColour(run.index) : "--curve";
      svg(this.picture, "path", { d, class: "curve", style: `stroke: var(${colour})` });
    }
    this.head = svg(this.picture, "g", { class: "head" });
    svg(this.head, "line", { y1: top, y2: bottom });
    this.dots = this.lines.map(({ run }) =>
      svg(this.head, "circle", { r: 3.5, style: `fill: var(${this.several ? runColour(run.index) : "--curve"})` }),
    );
  }

  drawAxes(levels, from, bottom, top) {
    const { picture, x, y, width, writer } = this;
    const step = levels.length > 1 ? levels[1] - levels[0] : 0;
    const digits = (level) => (step ? Math.max(1, Math.ceil(Math.log10(Math.abs(level) / step + 1)) + 1) : 4);
    for (const level of levels) {
      svg(picture, "line", { class: "grid", x1: margin.left, x2: width - margin.right, y1: y(level), y2: y(level) });
      const sign = from && level > 0 ? "+" : "";
      svg(
        picture,
        "text",
        { class: "level", x: margin.left - 6, y: y(level) + 3.5 },
        sign + number(level, digits(level)),
      );
    }
    const most = Math.max(2, Math.floor((width - margin.left) / 60));
    const size = writer.size;
    for (const t of ticks(this.span[0] / size, this.span[1] / size, most)) {
      svg(picture, "line", { class: "grid", x1: x(t * size), x2: x(t * size), y1: top, y2: bottom });
      svg(picture, "text", { class: "moment", x: x(t * size), y: height - 5 }, `${number(t)} ${writer.unit}`);
    }
    svg(picture, "line", { class: "base", x1: margin.left, x2: width - margin.right, y1: bottom, y2: bottom });
  }

  show(time) {
    const { from } = this.range;
    this.head.setAttribute("transform", `translate(${this.x(time)} 0)`);
    this.lines.forEach(({ run, series }, i) => {
      const { frame, mix } = locate(run.times, time);
      const before = series.values[frame];
      const after = series.values[Math.min(frame + 1, run.frames - 1)];
      const value = mix > 0 && Number.isFinite(after) ? before + mix * (after - before) : before;
      const known = Number.isFinite(value);
      this.dots[i].style.visibility = known ? "" : "hidden";
      if (known) this.dots[i].setAttribute("cy", this.y(value - from));
      const change = value - from;
      const text = from && change ? `${number(from, 4)} ${signed(change)}` : number(value, 4);
      this.readings[i].textContent = known ? `${text} ${this.unit}` : "";
    });
  }
}

/// Returns show(time); `scrub(time)` is called with a time that was pointed at.
export function plots(parent, runs, options) {
  const all = collect(runs).map((series) => new Plot(parent, series, { ...options, several: runs.length > 1 }));
  let shown = options.span[0];
  const show = (time) => {
    shown = time;
    for (const plot of all) plot.show(time);
  };
  const resize = () => {
    for (const plot of all) plot.resize();
    show(shown);
  };
  resize();
  new ResizeObserver(() => requestAnimationFrame(resize)).observe(parent);
  return show;
}
