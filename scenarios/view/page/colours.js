// Colours of bodies, runs and scales, all to be told apart by colour-blind eyes.

/// A colour of the style sheet as [red, green, blue], 0 to 255.
export function css(name) {
  const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const number = parseInt(text.slice(1), 16);
  return [number >> 16, (number >> 8) & 255, number & 255];
}

export const groupColour = (index) => `--colour-${(index % 10) + 1}`;
/// Of a run among several: blue, vermilion, green, ...
export const runColour = (index) => `--colour-${(index % 8) + 1}`;

// Viridis at eleven places; its ends are cut where they would vanish into the paper.
const viridis = "440154 482475 414487 355f8d 2a788e 21918c 22a884 44bf70 7ad151 bddf26 fde725"
  .split(" ")
  .map((hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16)));
const ends = { light: [0.06, 0.94], dark: [0.16, 1.0] };

function viridisAt(share) {
  const at = Math.min(Math.max(share, 0), 1) * (viridis.length - 1);
  const low = Math.min(Math.floor(at), viridis.length - 2);
  return viridis[low].map((v, i) => Math.round(v + (at - low) * (viridis[low + 1][i] - v)));
}

/// The scale's colour at a share of its length.
export function mapColour(share, dark) {
  const [low, high] = ends[dark ? "dark" : "light"];
  return viridisAt(low + share * (high - low));
}

/// 256 texels; with steps, that many even colours.
export function mapTexels(dark, steps = 0) {
  const texels = new Uint8Array(256 * 4);
  for (let i = 0; i < 256; ++i) {
    const share = steps ? stepShare(Math.floor((i / 256) * steps), steps) : i / 255;
    texels.set([...mapColour(share, dark), 255], 4 * i);
  }
  return texels;
}

export const stepShare = (step, steps) => (steps > 1 ? step / (steps - 1) : 0);
export const rgb = (colour) => `rgb(${colour.join(" ")})`;

const mostSteps = 9;

/// How a column is coloured, the same for all runs: its ends, or the number of steps of a count.
/// The upper end leaves out the highest hundredth where that is far above the rest: a few fast bodies, all others dark.
export function scaleOf(runs, name) {
  const columns = runs.map((run) => run.columns[name]).filter(Boolean);
  if (!columns.length) return null;
  const unit = columns.find((c) => c.unit)?.unit ?? "";
  if (name === "contacts") {
    const most = columns.reduce((high, c) => c.values.reduce((a, b) => Math.max(a, b), high), 0);
    const steps = Math.min(most, mostSteps - 1) + 1;
    return { name, unit, steps, cut: most > mostSteps - 1, min: 0, max: steps };
  }
  const real = (column, q) => column.min + (q / 255) * (column.max - column.min);
  const min = Math.min(...columns.map((c) => c.min));
  const max = Math.max(...columns.map((c) => c.max));
  if (!(max > min)) return null; // all alike: nothing to tell apart
  const usual = Math.max(...columns.map((c) => real(c, hundredthBelowTop(c.values))));
  const cut = usual - min < 0.6 * (max - min) && usual > min;
  return { name, unit, steps: 0, cut, min, max: cut ? usual : max };
}

function hundredthBelowTop(values) {
  const often = new Uint32Array(256);
  for (let i = 0; i < values.length; ++i) ++often[values[i]];
  let above = values.length / 100;
  let q = 255;
  while (q > 0 && (above -= often[q]) > 0) --q;
  return q;
}

/// The scale's ends in the quantised values of a column, 0 to 1, for the shader.
export function scaleRange(scale, column) {
  if (scale.steps) return [0, scale.max / 255];
  const width = column.max - column.min;
  if (!(width > 0)) return [0, 1];
  const ends = [(scale.min - column.min) / width, (scale.max - column.min) / width];
  return ends[1] > ends[0] ? ends : [ends[0], ends[0] + 1];
}
