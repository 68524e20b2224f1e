// Names beside the curves in colour: near an end, not on each other, off the points if there is room.

const measure = document.createElement("canvas").getContext("2d");

function width(text, font) {
  measure.font = font;
  return measure.measureText(text).width;
}

const overlap = (a, b) => a.left < b.right + 4 && b.left < a.right + 4 && a.top < b.bottom && b.top < a.bottom;

function* places([x, y], w, h) {
  for (const gap of [6, 10, 16, 24, 36, 52, 75, 105]) {
    for (let turn = 0; turn < 16; ++turn) {
      const c = Math.cos((Math.PI * turn) / 8),
        s = Math.sin((Math.PI * turn) / 8);
      const left = x + gap * c + (c > 0.3 ? 0 : c < -0.3 ? -w : -w / 2);
      const top = y + gap * s + (s > 0.3 ? 0 : s < -0.3 ? -h : -h / 2);
      yield { gap, box: { left, top, right: left + w, bottom: top + h } };
    }
  }
}

function covered(box, dots) {
  let n = 0;
  for (const [x, y] of dots) n += x > box.left - 3 && x < box.right + 3 && y > box.top - 3 && y < box.bottom + 3;
  return n;
}

/// Points on the lines between dots, a few pixels apart: what a name had better not hide.
export function along(dots) {
  const found = [...dots];
  for (let i = 1; i < dots.length; ++i) {
    const [a, b] = [dots[i - 1], dots[i]];
    const parts = Math.min(60, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1]) / 7));
    for (let k = 1; k < parts; ++k)
      found.push([a[0] + ((b[0] - a[0]) * k) / parts, a[1] + ((b[1] - a[1]) * k) / parts]);
  }
  return found;
}

/// names: [{text, colour, anchors: [[x, y], ...] best first, weight}], avoid: [[x, y], ...]
export function name(svg, names, avoid, bounds) {
  const taken = names
    .filter((n) => n.ring)
    .map(({ anchors: [[x, y]] }) => ({ left: x - 10, top: y - 10, right: x + 10, bottom: y + 10 }));
  const layer = svg.appendChild(document.createElementNS("http://www.w3.org/2000/svg", "g"));
  layer.setAttribute("class", "names");
  for (const { text, colour, anchors, ring } of names) {
    const w = width(text, "600 12.5px system-ui, sans-serif"),
      h = 15;
    let best = null;
    anchors.forEach((anchor, rank) => {
      for (const { gap, box } of places(anchor, w, h)) {
        const cost = gap + (ring ? 6 : 0) + rank * 8;
        if (best && cost >= best.cost) break;
        if (ring && gap < 12) continue;
        if (box.left < bounds.left || box.right > bounds.right || box.top < bounds.top || box.bottom > bounds.bottom)
          continue;
        if (taken.some((other) => overlap(box, other))) continue;
        const whole = cost + 7 * covered(box, avoid);
        if (!best || whole < best.cost) best = { cost: whole, box, gap, anchor };
      }
    });
    if (!best) continue;
    taken.push(best.box);
    const { box, anchor, gap } = best;
    const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
    if (gap > 20) {
      const line = layer.appendChild(document.createElementNS("http://www.w3.org/2000/svg", "line"));
      const end = [clamp(anchor[0], box.left, box.right), clamp(anchor[1], box.top, box.bottom)];
      for (const [key, value] of Object.entries({ x1: anchor[0], y1: anchor[1], x2: end[0], y2: end[1] }))
        line.setAttribute(key, value);
      line.style.stroke = colour;
    }
    const element = layer.appendChild(document.createElementNS("http://www.w3.org/2000/svg", "text"));
    element.setAttribute("x", box.left);
    element.setAttribute("y", box.top + 12);
    element.style.fill = colour;
    element.textContent = text;
  }
}
