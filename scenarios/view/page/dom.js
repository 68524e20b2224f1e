// Elements; text is never markup.

export function make(parent, tag, properties = {}, text = "") {
  const element = document.createElement(tag);
  Object.assign(element, properties);
  if (text) element.append(text);
  parent?.append(element);
  return element;
}

export function svg(parent, tag, attributes = {}, text = "") {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  if (text) element.append(text);
  parent?.append(element);
  return element;
}

const shapes = {
  play: "M5 3.2v9.6L13 8z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  back: "M11.5 3.2v9.6L5.5 8zM3.5 3h1.6v10H3.5z",
  on: "M4.5 3.2v9.6l6-4.8zM10.9 3h1.6v10h-1.6z",
  loop: "M11 1.5 14 4l-3 2.5V4.8H5A2.2 2.2 0 0 0 2.8 7v1H1.2V7A3.8 3.8 0 0 1 5 3.2h6zM5 14.5 2 12l3-2.5v1.7h6A2.2 2.2 0 0 0 13.2 9V8h1.6v1a3.8 3.8 0 0 1-3.8 3.8H5z",
  fit: "M2 6V2h4v1.5H3.5V6zM10 2h4v4h-1.5V3.5H10zM2 10h1.5v2.5H6V14H2zM12.5 10H14v4h-4v-1.5h2.5z",
  theme: "M8 1.5a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zM8 3v10A5 5 0 0 1 8 3z",
};

export function icon(name) {
  const picture = svg(null, "svg", { viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": "true" });
  svg(picture, "path", { d: shapes[name], fill: "currentColor", "fill-rule": "evenodd" });
  return picture;
}
