// Which curves get a colour: eight at most, so that they can be told apart; where few are shown, all of them.

import { claimed, drawable, front, isScene } from "./data.js";

export const grey = "var(--grey)";
const palette = [1, 2, 3, 4, 5, 6, 7, 8].map((i) => `var(--colour-${i})`);
const others = ["var(--colour-9)", "var(--colour-10)"];
/// What curves that differ by their precision alone have in common: they share a colour.
export const nameOf = (curve) => curve.label.replace(/, (single|double|extended)(?=,|$)/, "");

/// How a curve ranks for a colour, the less the better, as in the still picture: those of the front first, then the
/// scene's own, then what is near the front.
function rank(result, curve, best, measure, cost) {
  const points = curve.points
    .map((i) => result.points[i])
    .filter((p) => drawable(p, measure, cost) && claimed(p, measure));
  const onFront = points.filter((p) => best.includes(p)).length;
  if (onFront) return -1 - onFront;
  const recommended = result.points[result.recommended?.point];
  if (points.some((p) => p === recommended || isScene(p, result.scene))) return -1;
  const cheapest = (point) =>
    Math.min(cost.of(point), ...best.filter((p) => measure.of(p) <= measure.of(point)).map(cost.of));
  return Math.min(...points.map((p) => Math.log(cost.of(p) / cheapest(p))));
}

/// The curves that stand out when all are shown, and the colours of their names, which they keep from `before`.
export function standing(result, measure, cost, before) {
  const best = front(
    result.points.filter((p) => drawable(p, measure, cost)),
    measure,
    cost,
  );
  const ranked = result.curves
    .map((curve) => [rank(result, curve, best, measure, cost), curve])
    .sort((a, b) => a[0] - b[0]);
  const curves = new Set(ranked.slice(0, palette.length).map(([, curve]) => curve));
  const names = [...new Set([...curves].map(nameOf))];
  const colours = new Map(names.filter((n) => before?.colours.has(n)).map((n) => [n, before.colours.get(n)]));
  const spare = palette.filter((c) => ![...colours.values()].includes(c));
  for (const name of names) {
    if (!colours.has(name)) colours.set(name, spare.shift());
  }
  return { curves, colours };
}

/// A colour for each curve that is shown.
export function colourOf(curves, shown, { curves: strong, colours }) {
  const names = [...new Set(curves.filter((c) => shown.has(c)).map(nameOf))];
  if (names.length > palette.length) return (curve) => (strong.has(curve) ? colours.get(nameOf(curve)) : grey);
  const found = new Map(names.filter((n) => colours.has(n)).map((n) => [n, colours.get(n)]));
  const spare = palette.filter((c) => ![...found.values()].includes(c));
  for (const name of names) {
    if (!found.has(name)) found.set(name, spare.shift());
  }
  return (curve) => found.get(nameOf(curve)) ?? grey;
}

/// Colours for paths: of the curve they belong to, else a spare one.
export function pathColours(labels, { colours }) {
  const found = new Map();
  const spare = palette.filter((c) => ![...colours.values()].includes(c)).concat(others);
  for (const label of labels) {
    const name = [...colours.keys()].filter((n) => label.startsWith(n)).sort((a, b) => b.length - a.length)[0];
    if (label.startsWith("reference")) found.set(label, "var(--ink)");
    else found.set(label, name ? colours.get(name) : (spare.shift() ?? grey));
  }
  return found;
}
