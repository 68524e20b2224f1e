// What the page knows: the result as the program wrote it, and numbers as people read them.

export const quantities = {
  position: { unit: "m" },
  velocity: { unit: "m/s" },
  orientation: { unit: "rad" },
  spin: { unit: "rad/s" },
};
export const faces = { maximum: "largest along the path", end: "at the end", rms: "rms along the path" };
const others = {
  energy: ["energy, largest relative change", ""],
  momentum: ["momentum, largest relative change", ""],
  angular_momentum: ["angular momentum, largest relative change", ""],
  quaternion_norm: ["quaternion norm, largest error", ""],
  penetration: ["deepest overlap", "m"],
};
export const costs = {
  min: { name: "wall time of a whole run, fastest", of: (p) => p.seconds?.min, text: seconds },
  median: { name: "wall time of a whole run, median", of: (p) => p.seconds?.median, text: seconds },
  evaluations: { name: "force evaluations", of: (p) => p.force_evaluations, text: count },
};

export function number(x, digits = 3) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "";
  const rounded = Number(x.toPrecision(digits));
  const size = Math.abs(rounded);
  if (size !== 0 && (size < 1e-4 || size >= 1e6)) return rounded.toExponential().replace("e+", "e");
  return String(rounded);
}

export function seconds(s) {
  if (!Number.isFinite(s)) return "";
  if (s === 0) return "0 s";
  for (const [size, name] of [
    [1, "s"],
    [1e-3, "ms"],
    [1e-6, "us"],
  ]) {
    if (Math.abs(s) >= size * 0.9995) return `${number(s / size)} ${name}`;
  }
  return `${number(s / 1e-9)} ns`;
}

export function count(n) {
  if (!Number.isFinite(n)) return "";
  return n < 1e6 ? Math.round(n).toLocaleString("en") : number(n);
}

/// 10 to a power, as it is printed.
export function power(x) {
  const exponent = Math.round(Math.log10(x));
  if (Math.abs(Math.log10(x) - exponent) > 1e-9 || exponent === 0 || exponent === 1) return number(x);
  return (
    "10" +
    String(exponent).replace(/./g, (c) =>
      c === "-" ? "\u207b" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[c],
    )
  );
}

/// Every error that is somewhere above zero: {key, name, unit, of(point), floor}.
export function measures(result) {
  const found = [];
  const bar = result.reference?.error_bar ?? {};
  const above = bar[result.measure.quantity] > 0 ? result.reference.floor / bar[result.measure.quantity] : 10;
  const add = (measure) => {
    if (result.points.some((p) => measure.of(p) > 0) || measure.chosen) found.push(measure);
  };
  for (const [quantity, { unit }] of Object.entries(quantities)) {
    for (const [face, words] of Object.entries(faces)) {
      const chosen = quantity === result.measure.quantity && face === result.measure.which;
      const floor = quantity === result.measure.quantity ? result.reference.floor : above * (bar[quantity] ?? 0);
      const name = chosen && result.measure.name ? result.measure.name : `${quantity} error, ${words}`;
      add({
        key: `${quantity}.${face}`,
        group: quantity,
        option: words,
        name,
        unit,
        floor,
        chosen,
        of: (p) => p.error?.[quantity]?.[face],
      });
    }
  }
  add({
    key: "event_time",
    group: "events",
    option: "largest error of a time",
    name: "largest error of an event's time",
    unit: "s",
    floor: 10 * (result.reference?.event_time ?? 0),
    of: (p) => p.error?.event_time,
  });
  for (const [key, [name, unit]] of Object.entries(others)) {
    add({ key, group: "what should not change", option: name, name, unit, floor: 0, of: (p) => p.error?.[key] });
  }
  return found;
}

/// Is the error far enough above the reference's own?
export function claimed(point, measure) {
  return measure.chosen ? point.claimed : !(measure.floor > 0) || measure.of(point) > measure.floor;
}

export function drawable(point, measure, cost) {
  return !point.trouble && Number.isFinite(measure.of(point)) && cost.of(point) > 0;
}

/// Points that no other is both as accurate as and faster than, the fastest first.
export function front(points, measure, cost) {
  const sorted = points
    .filter((p) => claimed(p, measure))
    .sort((a, b) => cost.of(a) - cost.of(b) || measure.of(a) - measure.of(b));
  let best = Infinity;
  return sorted.filter((p) => measure.of(p) < best && ((best = measure.of(p)), true));
}

export function settingText(p) {
  const words = [p.integrator];
  if (p.step) words.push(`step ${number(p.step)} s`);
  if (p.tolerance) words.push(`tolerance ${number(p.tolerance)}`);
  if (p.precision !== "double") words.push(p.precision);
  if (p.rotation && p.rotation !== "renormalise") words.push(p.rotation);
  return words.join(", ");
}

export function contactText(contact) {
  if (!contact) return "";
  if (contact.kind === "penalty") return `penalty, ${number(contact.stiffness)} N/m`;
  return `${contact.iterations} iterations, ${contact.substeps} substep${contact.substeps === 1 ? "" : "s"}`;
}

const close = (a, b) => (a ?? 0) === (b ?? 0) || Math.abs(a - b) <= 1e-9 * Math.abs(b);

export function isScene(point, scene) {
  return (
    Boolean(scene) &&
    point.integrator === scene.integrator &&
    point.precision === scene.precision &&
    close(point.step, scene.step) &&
    close(point.tolerance, scene.tolerance) &&
    (!scene.contact || JSON.stringify(scene.contact) === JSON.stringify(point.contact))
  );
}
