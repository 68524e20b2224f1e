// The page: choices on top, the chart beside its legend, then what can be read from it, the paths and the points.

import { chart } from "./chart.js";
import { colourOf, grey, pathColours, standing } from "./colours.js";
import { contactText, costs, measures, number, settingText } from "./data.js";
import { legend } from "./legend.js";
import { bestProjection, pathFigure, projections } from "./paths.js";
import { table } from "./table.js";

const result = JSON.parse(document.getElementById("result").textContent);
result.curves.forEach((curve, index) => (curve.index = index));
const page = document.getElementById("page");

/// An element; text is never markup.
function make(parent, tag, properties = {}, text = "") {
  const element = parent.appendChild(document.createElement(tag));
  Object.assign(element, properties);
  if (text) element.append(text);
  return element;
}

function select(parent, label, groups, value, change) {
  const field = make(parent, "label", { className: "field" });
  make(field, "span", {}, label);
  const element = make(field, "select");
  for (const [group, options] of groups) {
    const inside = group ? make(element, "optgroup", { label: group }) : element;
    for (const [key, name] of options) make(inside, "option", { value: key, selected: key === value }, name);
  }
  element.onchange = () => change(element.value);
}

function checkbox(parent, label, checked, change) {
  const field = make(parent, "label", { className: "check" });
  const input = make(field, "input", { type: "checkbox", checked });
  field.append(label);
  input.onchange = () => change(input.checked);
}

function head() {
  make(page, "h1", {}, `${result.scenario}: what accuracy costs`);
  if (result.doc) make(page, "p", { className: "doc" }, result.doc);
  const { reference, measure, bodies, compared } = result;
  const bar = reference.error_bar?.[measure.quantity];
  const facts = make(page, "dl", { className: "facts" });
  const fact = (name, text) => {
    if (!text) return;
    make(facts, "dt", {}, name);
    make(facts, "dd", {}, text);
  };
  fact(
    "Reference",
    [
      `${reference.kind}: ${reference.what}`,
      bar ? `itself within ${number(bar)} ${measure.unit}` : "",
      reference.floor ? `no error below ${number(reference.floor)} ${measure.unit} is claimed` : "",
    ]
      .filter(Boolean)
      .join("; "),
  );
  fact(
    "Run",
    `${number(result.duration)} s simulated, ${bodies} ${bodies === 1 ? "body" : "bodies"}` +
      (compared < bodies ? `, ${compared} compared` : "") +
      `, ${result.threads} thread${result.threads === 1 ? "" : "s"}`,
  );
  fact("Machine", result.machine);
  fact("Contacts", result.remarks?.join(" "));
  fact("Horizon", result.horizon?.sentence);
  make(facts, "dt", {}, "Command");
  make(make(facts, "dd"), "code", {}, result.command);
  if (result.recommended?.sentence) {
    const card = make(page, "p", { className: "recommended" });
    make(card, "strong", {}, "Recommended ");
    card.append(result.recommended.sentence);
    const { confirmed_error: error } = result.recommended;
    if (Number.isFinite(error))
      make(card, "span", {}, ` A run of its own confirmed an error of ${number(error)} ${measure.unit}.`);
  }
}

function list(heading, sentences) {
  if (!sentences?.length) return;
  const part = make(page, "section");
  make(part, "h2", {}, heading);
  const items = make(part, "ul");
  for (const sentence of sentences) make(items, "li", {}, sentence);
}

const all = measures(result);
const state = {
  result,
  shown: new Set(result.curves.filter((c) => c.points.some((i) => !result.points[i].trouble))),
  measure: all.find((m) => m.chosen) ?? all[0],
  cost: costs.min,
  logError: true,
  logCost: true,
  onlyShown: false,
  order: { heading: "fastest", down: false },
  front: [],
};
const standard = standing(result, state.measure, state.cost);

function controls(parent, draw) {
  const bar = make(parent, "div", { className: "controls" });
  const groups = Map.groupBy
    ? Map.groupBy(all, (m) => m.group)
    : all.reduce((map, m) => map.set(m.group, [...(map.get(m.group) ?? []), m]), new Map());
  select(
    bar,
    "Error",
    [...groups].map(([group, members]) => [
      group,
      members.map((m) => [
        m.key,
        `${group in { position: 1, velocity: 1, orientation: 1, spin: 1 } ? `${group}, ` : ""}${m.option}`,
      ]),
    ]),
    state.measure.key,
    (key) => draw({ measure: all.find((m) => m.key === key) }),
  );
  select(bar, "Cost", [["", Object.entries(costs).map(([key, c]) => [key, c.name])]], "min", (key) =>
    draw({ cost: costs[key] }),
  );
  checkbox(bar, "log error", true, (logError) => draw({ logError }));
  checkbox(bar, "log cost", true, (logCost) => draw({ logCost }));
}

/// Now, and when its width has changed.
function whenResized(element, draw) {
  let width = 0;
  const look = () => {
    if (Math.abs(element.clientWidth - width) < 2) return;
    width = element.clientWidth;
    draw();
  };
  look();
  new ResizeObserver(() => requestAnimationFrame(look)).observe(element);
}

/// Brings out one curve; null: none.
function light(holder, curve) {
  holder.classList.toggle("lit", Boolean(curve));
  for (const old of holder.querySelectorAll(".bright")) old.classList.remove("bright");
  if (!curve) return;
  for (const part of holder.querySelectorAll(`.curve-${curve.index}`)) part.classList.add("bright");
}

function workPrecision() {
  const part = make(page, "section", { className: "work" });
  const draw = (change = {}) => {
    Object.assign(state, change);
    render();
  };
  controls(part, draw);
  const split = make(part, "div", { className: "split" });
  const figure = make(split, "figure");
  const costName = make(figure, "div", { className: "cost-name" });
  const holder = make(figure, "div", { className: "chart" });
  const errorName = make(figure, "div", { className: "error-name" });
  const side = make(split, "aside");
  const points = make(page, "section", { className: "points" });
  let redrawLegend = null;

  const drawTable = () => {
    const place = points.querySelector(".scroll");
    place.replaceChildren(
      table({ ...state, onPoint: (p) => light(holder, p && result.curves[p.curve]) }, state.order, drawTable),
    );
  };
  const render = () => {
    const colour = colourOf(result.curves, state.shown, standing(result, state.measure, state.cost, standard));
    const drawn = chart({
      ...state,
      colour,
      width: Math.max(320, holder.clientWidth),
      onPoint: (p) => light(holder, p && result.curves[p.curve]),
    });
    holder.replaceChildren(drawn.figure);
    state.front = drawn.front;
    costName.textContent = state.cost.name;
    errorName.replaceChildren();
    make(errorName, "span", { className: "better" }, "\u2190 more accurate");
    make(errorName, "span", {}, state.measure.name + (state.measure.unit ? ` [${state.measure.unit}]` : ""));
    redrawLegend(colour);
    drawTable();
  };
  redrawLegend = legend(side, state, { draw, light: (curve) => light(holder, curve) });
  make(points, "h2", {}, "All points");
  checkbox(
    points,
    "only of the curves shown above",
    false,
    (onlyShown) => ((state.onlyShown = onlyShown), drawTable()),
  );
  make(points, "div", { className: "scroll" });
  whenResized(holder, render);
  return points;
}

function paths() {
  if (!result.paths?.length) return;
  const part = make(page, "section");
  make(part, "h2", {}, "Paths");
  const labels = [...new Set(result.paths.map((p) => p.label))];
  const bodies = [...new Set(result.paths.map((p) => p.body))];
  const colours = pathColours(labels, standard);
  const shown = new Set(labels);
  const bar = make(part, "div", { className: "controls" });
  const holder = make(part, "div", { className: "chart" });
  let body = "all";
  const chosen = () => (body === "all" ? result.paths : result.paths.filter((p) => String(p.body) === body));
  let projection = bestProjection(result.paths);
  const render = () =>
    holder.replaceChildren(pathFigure(chosen(), shown, colours, projection, Math.max(320, holder.clientWidth)));
  select(bar, "View", [["", projections.map((p) => [p.key, p.name])]], projection.key, (key) => {
    projection = projections.find((p) => p.key === key);
    render();
  });
  if (bodies.length > 1) {
    select(
      bar,
      "Body",
      [["", [["all", "all"], ...bodies.map((b) => [String(b), String(b)])]]],
      body,
      (b) => ((body = b), render()),
    );
  }
  for (const label of labels) {
    const field = make(bar, "label", { className: "check" });
    const input = make(field, "input", { type: "checkbox", checked: true });
    make(field, "i", { className: label.startsWith("reference") ? "stroke thin" : "stroke" }).style.background =
      colours.get(label) ?? grey;
    field.append(label);
    input.onchange = () => (shown[input.checked ? "add" : "delete"](label), render());
  }
  whenResized(holder, render);
}

/// Means beyond the horizon: a row a setting, a column an observable; what differs stands out.
function ensemble() {
  if (!result.ensemble) return;
  const { copies, time, reference, observables, settings } = result.ensemble;
  const named = (p) => [settingText(p), contactText(p.contact)].filter(Boolean).join(", ");
  const part = make(page, "section");
  make(part, "h2", {}, `Beyond the horizon: ensembles of ${copies} runs, at t = ${number(time)} s`);
  make(part, "p", {}, `Means with their 95 % intervals; in parentheses how many standard errors they are from those of
    the reference, ${named(reference)} (${reference.why}).`);
  const place = make(part, "div", { className: "scroll" });
  const body = make(place, "table");
  const head = make(make(body, "thead"), "tr");
  make(head, "th", { scope: "col" }, "setting");
  for (const { name, unit } of observables)
    make(head, "th", { scope: "col", className: "numeric" }, unit ? `${name} [${unit}]` : name);
  const mean = (m) => `${number(m.mean)} \u00b1 ${number((m.interval95[1] - m.interval95[0]) / 2, 2)}`;
  const rows = make(body, "tbody");
  const first = make(rows, "tr", { className: "front" });
  make(first, "td", {}, `reference: ${named(reference)}`);
  for (const m of reference.means) make(first, "td", { className: "numeric" }, mean(m));
  for (let i = 0; i < settings.length; i += observables.length) {
    const row = make(rows, "tr");
    make(row, "td", {}, named(settings[i]));
    for (const m of settings.slice(i, i + observables.length)) {
      const cell = make(row, "td", { className: "numeric" });
      make(cell, m.sigmas > 2 ? "strong" : "span", {}, `${mean(m)} (${number(m.sigmas, 2)})`);
    }
  }
}

head();
const points = workPrecision();
list("Where curves cross", result.crossovers);
ensemble();
paths();
list("Left out", result.left_out);
page.append(points);
