// What the colours mean, in a corner of the picture, and the names of the views.

import { number } from "../../../perf/cost/figure/data.js";
import { groupColour, mapColour, rgb, runColour, stepShare } from "./colours.js";
import { make } from "./dom.js";

const titles = { speed: "speed", energy: "kinetic energy", contacts: "contacts of a body" };

function swatches(parent, entries) {
  for (const [colour, text] of entries) {
    const row = make(parent, "div", { className: "entry" });
    make(row, "i").style.background = colour;
    make(row, "span", {}, text);
  }
}

function bar(parent, scale, dark) {
  const stops = Array.from({ length: 17 }, (_, i) => rgb(mapColour(i / 16, dark)));
  make(parent, "div", { className: "bar" }).style.background = `linear-gradient(to right, ${stops.join(", ")})`;
  const ends = make(parent, "div", { className: "ends" });
  make(ends, "span", {}, number(scale.min, 2));
  make(ends, "span", {}, number((scale.min + scale.max) / 2, 2));
  make(ends, "span", {}, (scale.cut ? "\u2265 " : "") + number(scale.max, 2));
}

function steps(parent, scale, dark) {
  const row = make(parent, "div", { className: "steps" });
  for (let step = 0; step < scale.steps; ++step) {
    const cell = make(row, "div");
    make(cell, "i").style.background = rgb(mapColour(stepShare(step, scale.steps), dark));
    make(cell, "span", {}, scale.cut && step === scale.steps - 1 ? `\u2265 ${step}` : String(step));
  }
}

export function legend(parent, runs, { colour, scale, dark, mode, axes }) {
  parent.replaceChildren();
  if (scale) {
    make(parent, "div", { className: "title" }, titles[scale.name] + (scale.unit ? ` [${scale.unit}]` : ""));
    (scale.steps ? steps : bar)(parent, scale, dark);
  } else if (colour === "group") {
    const most = runs.reduce((a, b) => (b.header.groups.length > a.header.groups.length ? b : a));
    swatches(
      parent,
      most.header.groups.slice(0, 12).map(({ name }, i) => [`var(${groupColour(i)})`, name]),
    );
  } else if (colour === "run" && mode === "overlaid") {
    swatches(
      parent,
      runs.map((run) => [`var(${runColour(run.index)})`, run.header.label]),
    );
  }
  if (axes) {
    const row = make(parent, "div", { className: "axes" });
    swatches(
      row,
      ["x", "y", "z"].map((axis) => [`var(--axis-${axis})`, axis]),
    );
    make(row, "span", {}, "of the body");
  }
  parent.hidden = !parent.childElementCount;
}

/// The names of views side by side, at their upper left corners.
export function viewNames(parent, runs, areas, height) {
  parent.replaceChildren();
  areas.forEach(([x, y, width, tall], i) => {
    const name = make(parent, "div", { className: "view-name" });
    name.style.cssText = `left: ${x}px; top: ${height - y - tall}px; width: ${width}px; height: ${tall}px`;
    const words = make(name, "span");
    make(words, "i").style.background = `var(${runColour(runs[i].index)})`;
    words.append(runs[i].header.label);
  });
}
