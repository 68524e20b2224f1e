// Keys, and the sheet that lists them.

import { make } from "./dom.js";

/// [keys as KeyboardEvent.key, how they are written, what they do, the action]
function table(act) {
  return [
    [[" ", "k"], "space", "play, pause", act.toggle],
    [["ArrowRight", "."], "\u2192", "next frame; with shift ten", (event) => act.step(event.shiftKey ? 10 : 1)],
    [["ArrowLeft", ","], "\u2190", "frame before; with shift ten", (event) => act.step(event.shiftKey ? -10 : -1)],
    [["Home"], "home", "to the start", () => act.step(-Infinity)],
    [["End"], "end", "to the end", () => act.step(Infinity)],
    [["+", "="], "+", "faster", () => act.faster(1)],
    [["-", "_"], "\u2212", "slower", () => act.faster(-1)],
    [["l"], "L", "loop", () => act.flip("loop")],
    [["f"], "F, double click", "show everything", act.fit],
    [["c"], "C", "next colouring", act.nextColour],
    [["s"], "S", "stripes of turning balls", () => act.flip("stripes")],
    [["a"], "A", "axes of turning bodies", () => act.flip("axes")],
    [["p"], "P", "paths", () => act.flip("paths")],
    [["b"], "B", "boundaries", () => act.flip("boundaries")],
    [["m"], "M", "runs side by side or overlaid", act.nextMode],
    [["d"], "D", "light, dark", act.nextTheme],
    [["?", "h"], "?", "this list", act.help],
  ];
}

export function keys(act) {
  const rows = table(act);
  const sheet = make(document.body, "dialog", { className: "help" });
  make(sheet, "h2", {}, "Keys");
  const list = make(sheet, "dl");
  for (const [, written, text] of rows) {
    make(make(list, "dt"), "kbd", {}, written);
    make(list, "dd", {}, text);
  }
  make(
    sheet,
    "p",
    {},
    "Drag to turn, wheel or pinch to zoom, right button or two fingers to shift. Click or drag in a plot to go to its time.",
  );
  sheet.onclick = () => sheet.close();
  act.help = () => (sheet.open ? sheet.close() : sheet.showModal());
  rows.at(-1)[3] = act.help;

  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { tagName, type } = event.target;
    if (tagName === "SELECT") return;
    if (event.key === " " && (tagName === "BUTTON" || type === "checkbox")) return; // presses what has the focus
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const row = rows.find(([names]) => names.includes(key));
    if (!row || (sheet.open && key !== "?" && key !== "h")) return;
    event.preventDefault();
    row[3](event);
  });
}
