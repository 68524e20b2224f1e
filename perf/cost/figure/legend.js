// The curves by family, each to be switched on and off.

import { drawable, front } from "./data.js";
import { grey, nameOf } from "./colours.js";
import { symbol } from "./chart.js";
import * as Plot from "@observablehq/plot";

function sample(curve, colour) {
  return Plot.plot({
    width: 30,
    height: 14,
    margin: 0,
    axis: null,
    x: { domain: [0, 30] },
    y: { domain: [0, 14] },
    color: { type: "identity" },
    style: { background: "transparent" },
    marks: [
      Plot.line(
        [
          [0, 7],
          [30, 7],
        ],
        {
          stroke: colour,
          strokeWidth: colour === grey ? 1 : 2,
          strokeDasharray: curve.precision === "single" ? "5 3" : undefined,
        },
      ),
      Plot.dot([[15, 7]], { fill: colour, symbol: symbol(curve.order), r: 4 }),
    ],
  });
}

function button(parent, text, press) {
  const element = parent.appendChild(document.createElement("button"));
  element.type = "button";
  element.textContent = text;
  element.onclick = press;
}

/// Returns a function that brings it up to date.
export function legend(side, state, { draw, light }) {
  const { result } = state;
  const usable = result.curves.filter((c) => c.points.some((i) => !result.points[i].trouble));
  const families = new Map();
  for (const curve of result.curves) families.set(curve.family, [...(families.get(curve.family) ?? []), curve]);
  const bar = side.appendChild(document.createElement("div"));
  bar.className = "buttons";
  button(bar, "all", () => draw({ shown: new Set(usable) }));
  button(bar, "none", () => draw({ shown: new Set() }));
  button(bar, "front only", () => draw({ shown: frontOfAll(state, usable) }));
  if (result.curves.some((c) => c.precision !== "double")) {
    button(bar, "double only", () => draw({ shown: new Set(usable.filter((c) => c.precision === "double")) }));
  }
  const precisions = [...new Set(result.curves.map((c) => c.precision))];
  side.style.setProperty("--precisions", precisions.length);
  const toggle = (curves, on) => {
    const shown = new Set(state.shown);
    for (const curve of curves) shown[on ? "add" : "delete"](curve);
    draw({ shown });
  };
  if (precisions.length > 1) {
    const row = side.appendChild(document.createElement("div"));
    row.className = "row precisions";
    row.append(
      document.createElement("span"),
      ...precisions.map((p) => Object.assign(document.createElement("div"), { textContent: p })),
    );
  }
  const cells = new Map(),
    heads = [],
    names = [];
  for (const [family, curves] of families) {
    const group = side.appendChild(document.createElement("fieldset"));
    const head = group.appendChild(document.createElement("legend")).appendChild(document.createElement("label"));
    const whole = head.appendChild(document.createElement("input"));
    whole.type = "checkbox";
    head.append(family);
    heads.push({ whole, curves });
    whole.onchange = () =>
      toggle(
        curves.filter((c) => usable.includes(c)),
        whole.checked,
      );
    for (const name of new Set(curves.map(nameOf))) {
      const own = curves.filter((c) => nameOf(c) === name);
      const row = group.appendChild(document.createElement("div"));
      row.className = "row";
      const words = row.appendChild(document.createElement("span"));
      words.textContent = name;
      names.push({ words, own });
      for (const curve of own) cells.set(curve, cell(row, curve, precisions.indexOf(curve.precision)));
    }
  }
  function cell(row, curve, column) {
    const label = row.appendChild(document.createElement("label"));
    label.style.gridColumn = column + 2;
    const input = label.appendChild(document.createElement("input"));
    input.type = "checkbox";
    input.disabled = !usable.includes(curve);
    input.setAttribute("aria-label", curve.label);
    label.title = input.disabled
      ? (result.points[curve.points[0]]?.trouble ?? "no points")
      : `${curve.integrator}, ${curve.precision}`;
    input.onchange = () => toggle([curve], input.checked);
    label.onmouseenter = () => light(state.shown.has(curve) ? curve : null);
    label.onmouseleave = () => light(null);
    return { input, swatch: label.appendChild(document.createElement("i")) };
  }
  return (colour) => {
    const onFront = new Set(state.front.map((p) => result.curves[p.curve]));
    for (const [curve, { input, swatch }] of cells) {
      input.checked = state.shown.has(curve);
      swatch.replaceChildren(sample(curve, input.checked ? colour(curve) : "var(--line)"));
    }
    for (const { words, own } of names)
      words.classList.toggle(
        "on-front",
        own.some((c) => onFront.has(c)),
      );
    for (const { whole, curves } of heads) {
      const on = curves.filter((c) => state.shown.has(c)).length;
      whole.checked = on > 0;
      whole.indeterminate = on > 0 && on < curves.length;
    }
  };
}

/// The curves that touch the front of all of them, by the error and the cost that are chosen.
function frontOfAll({ result, measure, cost }, usable) {
  const points = usable.flatMap((c) => c.points.map((i) => result.points[i])).filter((p) => drawable(p, measure, cost));
  return new Set(front(points, measure, cost).map((p) => result.curves[p.curve]));
}
