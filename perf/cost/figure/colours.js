// Which curves get a colour: eight at most, so that they can be told apart.

export const grey = "var(--grey)";
const palette = [1, 2, 3, 4, 5, 6, 7, 8].map((i) => `var(--colour-${i})`);
const nameOf = (curve) => curve.label.replace(/, (single|double|extended)$/, "");

/// Colours by the names of curves: those of the front first, as the still picture has them.
export function standing(result) {
  const best = (point) => Math.min(...result.points
    .filter((p) => p.pareto && p.error?.value <= point.error.value).map((p) => p.seconds.min));
  const rank = (curve) => {
    const points = curve.points.map((i) => result.points[i]).filter((p) => !p.trouble && p.claimed);
    const onFront = points.filter((p) => p.pareto).length;
    if (onFront) return -1 - onFront;
    return Math.min(...points.map((p) => Math.log(p.seconds.min / Math.min(best(p), p.seconds.min))));
  };
  const colours = new Map();
  const ranked = result.curves.map((curve) => [rank(curve), curve]).sort((a, b) => a[0] - b[0]);
  for (const [, curve] of ranked) {
    const name = nameOf(curve);
    if (!colours.has(name) && colours.size < palette.length) colours.set(name, palette[colours.size]);
  }
  return colours;
}

/// A colour for each curve that is shown; where few are, all have one.
export function colourOf(curves, shown, standard) {
  const names = [...new Set(curves.filter((c) => shown.has(c)).map(nameOf))];
  const colours = new Map(names.filter((n) => standard.has(n)).map((n) => [n, standard.get(n)]));
  const spare = palette.filter((c) => ![...colours.values()].includes(c));
  for (const name of names) {
    if (!colours.has(name) && spare.length) colours.set(name, spare.shift());
  }
  return (curve) => colours.get(nameOf(curve)) ?? grey;
}

/// Colours for paths: of the curve they belong to, else a spare one.
export function pathColours(labels, standard) {
  const found = new Map();
  const spare = palette.filter((c) => ![...standard.values()].includes(c)).concat("var(--colour-9)", "var(--colour-10)");
  for (const label of labels) {
    const name = [...standard.keys()].filter((n) => label.startsWith(n)).sort((a, b) => b.length - a.length)[0];
    if (label.startsWith("reference")) found.set(label, "var(--ink)");
    else found.set(label, name ? standard.get(name) : spare.length ? spare.shift() : grey);
  }
  return found;
}
