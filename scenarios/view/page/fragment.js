// What the address says behind its #, for stills and tests:
//   t=1.5&play=0&speed=0.25&loop=0&colour=speed&mode=beside|overlaid&theme=light|dark&stripes=0&axes=1&paths=1&
//   boundaries=0&look=AZIMUTH,ELEVATION[,ZOOM]   (angles in degrees)

const flag = (text) => text !== "0" && text !== "false";
const finite = (text) => (Number.isFinite(Number(text)) ? Number(text) : undefined);
const readers = {
  t: ["time", finite],
  play: ["playing", flag],
  speed: ["rate", (text) => (Number(text) > 0 ? Number(text) : undefined)],
  loop: ["loop", flag],
  colour: ["colour", String],
  mode: ["mode", String],
  theme: ["theme", String],
  stripes: ["stripes", flag],
  axes: ["axes", flag],
  paths: ["paths", flag],
  boundaries: ["boundaries", flag],
  look: ["look", (text) => text.split(",").map(Number)],
};

/// What is named of the state; nothing else of it.
export function fromFragment() {
  const said = {};
  for (const [key, text] of new URLSearchParams(location.hash.slice(1))) {
    const [name, read] = readers[key] ?? [];
    const value = name ? read(text) : undefined;
    if (value !== undefined) said[name] = value;
  }
  return said;
}
