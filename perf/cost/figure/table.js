// Every point, in the order of any column.

import { claimed, contactText, count, number, seconds } from "./data.js";

function columns(result, measure, front) {
  const curve = (p) => result.curves[p.curve];
  const list = [
    ["curve", (p) => curve(p).label],
    ["order", (p) => curve(p).order, String],
    ["step [s]", (p) => p.step, number],
    ["tolerance", (p) => p.tolerance, number],
    ["contact", (p) => contactText(p.contact)],
    [`error${measure.unit ? ` [${measure.unit}]` : ""}`, (p) => measure.of(p), number],
    ["fastest", (p) => p.seconds?.min, seconds],
    ["median", (p) => p.seconds?.median, seconds],
    ["slowest", (p) => p.seconds?.max, seconds],
    ["steps", (p) => p.steps, count],
    ["rejected", (p) => p.rejected_steps, count],
    ["evaluations", (p) => p.force_evaluations, count],
    ["state", (p) => p.state_hash],
    ["note", (p) => (p.trouble ? p.trouble : front.has(p) ? "on the front" : claimed(p, measure) ? "" : "not claimed")],
  ].map(([heading, of, text]) => ({ heading, of, text, numeric: Boolean(text) }));
  return list.filter(({ of }) =>
    result.points.some((p) => of(p) !== null && of(p) !== undefined && of(p) !== "" && of(p) !== 0),
  );
}

function compare(a, b) {
  const [none, other] = [a === null || a === undefined || a === "", b === null || b === undefined || b === ""];
  if (none || other) return none - other; // what is missing comes last
  return typeof a === "number" ? a - b : String(a).localeCompare(String(b));
}

/// `order`: {heading, down}, changed by a press on a heading, after which `again` is called.
export function table(view, order, again) {
  const { result, measure } = view;
  const front = new Set(view.front);
  const list = columns(result, measure, front);
  const by = list.find((c) => c.heading === order.heading) ?? list[0];
  const rows = result.points.filter((p) => !view.onlyShown || view.shown.has(result.curves[p.curve]));
  rows.sort((a, b) => {
    const [x, y] = [by.of(a), by.of(b)];
    const missing = (v) => v === null || v === undefined || v === "";
    return missing(x) || missing(y) ? compare(x, y) : (order.down ? -1 : 1) * compare(x, y);
  });
  const element = document.createElement("table");
  const head = element.createTHead().insertRow();
  for (const column of list) {
    const cell = head.appendChild(document.createElement("th"));
    const button = cell.appendChild(document.createElement("button"));
    button.textContent = column.heading;
    cell.className = column.numeric ? "numeric" : "";
    cell.scope = "col";
    if (column === by) cell.setAttribute("aria-sort", order.down ? "descending" : "ascending");
    button.onclick = () => {
      order.down = column.heading === order.heading ? !order.down : false;
      order.heading = column.heading;
      again();
    };
  }
  const body = element.createTBody();
  for (const point of rows) {
    const row = body.insertRow();
    if (front.has(point)) row.className = "front";
    if (point.trouble) row.className = "trouble";
    row.onmouseenter = () => view.onPoint(point);
    row.onmouseleave = () => view.onPoint(null);
    for (const column of list) {
      const cell = row.insertCell();
      const value = column.of(point);
      cell.className = column.numeric ? "numeric" : "";
      cell.textContent = value === null || value === undefined ? "" : column.text ? column.text(value) : value;
    }
  }
  return element;
}
