// Simulated time: which there is, how it is written, and how it passes.

import { number } from "../../../perf/cost/figure/data.js";

const units = [
  [1, "s"],
  [1e-3, "ms"],
  [1e-6, "\u00b5s"],
  [1e-9, "ns"],
];

/// How times of a run are written: {unit, text(t)}, with as many digits as a thousandth of the run needs.
export function timeWriter(duration) {
  const [size, unit] = units.find(([s]) => duration >= 0.1 * s) ?? units[0];
  const digits = Math.min(Math.max(Math.ceil(3 - Math.log10(duration / size || 1)), 0), 6);
  const form = { minimumFractionDigits: digits, maximumFractionDigits: digits };
  return { unit, size, text: (t) => (t / size).toLocaleString("en", form).replace(/^-(?=[0.]*$)/, "") };
}

/// All times at which some run has a frame.
export function allTimes(runs) {
  if (runs.length === 1) return runs[0].times;
  return Float64Array.from(new Set(runs.flatMap((run) => [...run.times]))).sort();
}

/// Simulated seconds per second: {rates, usual}. The usual one shows a run in about ten seconds.
export function speeds(duration) {
  const natural = duration / 10 || 1;
  const near = natural > 0.01 && natural < 100;
  const steps = near ? [1 / 8, 1 / 4, 1 / 2, 1, 2, 4, 8] : [0.1, 0.2, 0.5, 1, 2, 5, 10];
  const usual = near
    ? 2 ** Math.round(Math.log2(natural))
    : Number((10 ** Math.round(Math.log10(natural))).toPrecision(1));
  const rates = new Set(steps.map((step) => Number((step * usual).toPrecision(6))));
  rates.add(1);
  return { rates: [...rates].sort((a, b) => a - b), usual };
}

export function speedText(rate) {
  if (rate === 1) return "real time";
  const inverse = 1 / rate;
  const text =
    rate < 1 && Math.abs(inverse - Math.round(inverse)) < 1e-6 * inverse
      ? `1/${number(Math.round(inverse))}`
      : number(rate);
  return `${text} \u00d7 real time`;
}

/// The time after `passed` seconds of playing: {time, playing}.
export function advance({ time, rate, loop, playing }, passed, [start, end]) {
  const next = time + passed * rate;
  if (next < end) return { time: next, playing };
  if (!loop || !(end > start)) return { time: end, playing: false };
  return { time: start + ((next - start) % (end - start)), playing };
}

/// The neighbouring frame's time, by a number of frames.
export function stepFrom(times, time, by) {
  const slack = 1e-9 * (times[times.length - 1] - times[0]);
  let at = by > 0 ? times.findLastIndex((t) => t <= time + slack) : times.findIndex((t) => t >= time - slack);
  if (at < 0) at = by > 0 ? 0 : times.length - 1;
  return times[Math.min(Math.max(at + by, 0), times.length - 1)];
}
