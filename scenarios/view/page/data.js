// The runs as the program wrote them. Values stay quantised here: shaders and readers multiply where they need to.
//
// #runs holds a JSON array of headers, #data-K the data of run K: base64 of a zlib stream, the columns one after the
// other; of each, for each frame and component, the bytes of all shown bodies, or first all low and then all high bytes.
// What is stored are differences along time modulo 2^bits: q[f] - q[f-1], or q[f] - 2 q[f-1] + q[f-2], with q = 0 before
// the start. Positions stand between the corners of `box`; orientations are x, y, z of quaternions with w >= 0, from -1
// to 1; speed and energy stand between `min` and `max`; contacts are counts.

/// Is somebody at this place? (Bodies enter and leave: of those who are not there, all three values are the last.)
export const present = (values, place) =>
  values[3 * place] < 65535 || values[3 * place + 1] < 65535 || values[3 * place + 2] < 65535;

const bytesPer = (column) => column.components * (column.bits / 8);

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/// Inflates into one array, whose length is known before.
async function inflate(packed, length) {
  const bytes = new Uint8Array(length);
  const reader = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();
  let at = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    if (at + value.length > length) throw new Error("the data of a run is longer than its header says");
    bytes.set(value, at);
    at += value.length;
  }
  if (at < length) throw new Error(`the data of a run ends after ${at} of ${length} bytes`);
  return bytes;
}

/// Undoes the differences along time. Returns frame after frame, the components of a body side by side.
function restore(bytes, column, frames, bodies) {
  const { components, bits, differences } = column;
  const wide = bits === 16;
  const values = wide ? new Uint16Array(frames * bodies * components) : new Uint8Array(frames * bodies * components);
  const size = bodies * components;
  const [one, two] = [
    [0, 0],
    [1, 0],
    [2, -1],
  ][differences];
  let at = 0;
  for (let frame = 0; frame < frames; ++frame) {
    const last = frame > 0 ? one : 0;
    const lastButOne = frame > 1 ? two : 0;
    for (let component = 0; component < components; ++component) {
      let out = frame * size + component;
      for (let body = 0; body < bodies; ++body, ++at, out += components) {
        let value = wide ? bytes[at] | (bytes[at + bodies] << 8) : bytes[at];
        if (last) value += last * values[out - size];
        if (lastButOne) value += lastButOne * values[out - 2 * size];
        values[out] = value; // modulo 2^bits, by the type of the array
      }
      if (wide) at += bodies;
    }
  }
  return values;
}

/// One run: {header, frames, bodies, columns by name}, each column with all its values and `frame(f)`.
async function readRun(header, index) {
  if (header.format !== 1) throw new Error(`the data has format ${header.format}, this page reads format 1`);
  const element = document.getElementById(`data-${index}`);
  if (!element) throw new Error(`the data of run ${index} is missing`);
  const frames = header.times.length;
  const bodies = header.shown;
  const length = header.columns.reduce((sum, column) => sum + bytesPer(column) * bodies * frames, 0);
  const bytes = await inflate(bytesOfBase64(element.textContent.trim()), length);
  element.remove(); // the text is as large as the data again
  const columns = {};
  let at = 0;
  for (const column of header.columns) {
    const end = at + bytesPer(column) * bodies * frames;
    const values = restore(bytes.subarray(at, end), column, frames, bodies);
    const size = bodies * column.components;
    columns[column.name] = { ...column, values, frame: (f) => values.subarray(f * size, (f + 1) * size) };
    at = end;
  }
  if (!columns.position) throw new Error("a run has no positions");
  return { index, header, frames, bodies, columns, times: Float64Array.from(header.times) };
}

export async function readRuns() {
  const headers = JSON.parse(document.getElementById("runs").textContent);
  if (!headers.length) throw new Error("this page holds no run");
  const runs = [];
  for (const [index, header] of headers.entries()) runs.push(await readRun(header, index));
  return runs;
}

/// The frame at or before a time, and how far on the way to the next it is, 0 to 1.
export function locate(times, t) {
  let low = 0;
  let high = times.length - 1;
  if (!(t > times[0])) return { frame: 0, mix: 0 };
  if (t >= times[high]) return { frame: high, mix: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  return { frame: low, mix: (t - times[low]) / (times[high] - times[low]) };
}

/// The radius of each shown body; 0: a point.
export function radii(run) {
  const all = new Float32Array(run.bodies);
  for (const { first, count, radius } of run.header.groups) {
    for (let i = 0; i < count; ++i) all[first + i] = (Array.isArray(radius) ? radius[i] : radius) || 0;
  }
  return all;
}

/// The lengths after which space repeats, per axis; 0: it does not.
export function periods(run) {
  return run.header.boundaries.find((b) => b.shape === "periodic")?.size ?? [0, 0, 0];
}

/// What 0 to 65535 stand for: a least corner and lengths, none of them 0.
export function span({ header: { box } }) {
  return { from: box.min, size: box.max.map((high, axis) => high - box.min[axis]) };
}
