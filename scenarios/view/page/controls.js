// The bar under the picture: playing and time in one line, what is drawn in another. It shows the state and asks for
// changes of it; it keeps none.

import { speedText } from "./clock.js";
import { icon, make } from "./dom.js";

function button(parent, title, content, press) {
  const element = make(parent, "button", { type: "button", title });
  element.setAttribute("aria-label", title);
  element.append(content);
  element.onclick = press;
  return element;
}

function select(parent, label, options, change) {
  const field = make(parent, "label", { className: "field" });
  make(field, "span", {}, label);
  const element = make(field, "select");
  for (const [value, text] of options) make(element, "option", { value }, text);
  element.onchange = () => change(element.value);
  return element;
}

function check(parent, text, title, change) {
  const field = make(parent, "label", { className: "check", title });
  const input = make(field, "input", { type: "checkbox" });
  field.append(text);
  input.onchange = () => change(input.checked);
  return input;
}

function transport(parent, { act, rates, span, writer }) {
  const bar = make(parent, "div", { className: "transport" });
  const back = button(bar, "frame before (\u2190)", icon("back"), () => act.step(-1));
  const play = button(bar, "play, pause (space)", icon("play"), act.toggle);
  const on = button(bar, "next frame (\u2192)", icon("on"), () => act.step(1));
  play.classList.add("play");
  back.classList.add("plain");
  on.classList.add("plain");
  const slider = make(bar, "input", { type: "range", min: 0, max: 1, step: "any", value: 0 });
  slider.setAttribute("aria-label", "time");
  slider.oninput = () => act.scrub(span[0] + Number(slider.value) * (span[1] - span[0]));
  const time = make(bar, "output", { className: "time" });
  const now = make(time, "span", { className: "now" });
  make(time, "span", { className: "end" }, ` / ${writer.text(span[1])} ${writer.unit}`);
  now.style.minWidth = `${Math.max(...span.map((t) => writer.text(t).length))}ch`;
  const rate = select(
    bar,
    "",
    rates.map((r) => [r, speedText(r)]),
    (value) => act.set({ rate: Number(value) }),
  );
  rate.title = "simulated seconds per second (+ and \u2212)";
  const loop = button(bar, "loop (L)", icon("loop"), () => act.flip("loop"));
  loop.classList.add("plain");
  let pictured = false;
  return ({ time: t, playing, rate: chosen, loop: looping }) => {
    slider.value = (t - span[0]) / (span[1] - span[0] || 1);
    slider.setAttribute("aria-valuetext", `${writer.text(t)} ${writer.unit}`);
    now.textContent = writer.text(t);
    if (playing !== pictured) play.replaceChildren(icon(playing ? "pause" : "play"));
    pictured = playing;
    if (rate.value !== String(chosen)) rate.value = chosen;
    loop.setAttribute("aria-pressed", looping);
  };
}

const words = {
  speed: "speed",
  energy: "kinetic energy",
  contacts: "contacts",
  group: "group",
  run: "run",
  plain: "nothing",
};
const toggles = {
  stripes: ["stripes", "stripes of turning balls (S)"],
  axes: ["axes", "axes of turning bodies (A)"],
  paths: ["paths", "where bodies have been (P)"],
  boundaries: ["boundaries", "planes, boxes, tubes (B)"],
};

function choices(parent, { act, colours, has, several }) {
  const bar = make(parent, "div", { className: "choices" });
  const colour =
    colours.length > 1 &&
    select(
      bar,
      "Colour by",
      colours.map((c) => [c, words[c]]),
      (value) => act.set({ colour: value }),
    );
  const checks = Object.entries(toggles)
    .filter(([name]) => has[name])
    .map(([name, [text, title]]) => [name, check(bar, text, title, (on) => act.set({ [name]: on }))]);
  let modes = [];
  if (several) {
    const pair = make(bar, "div", { className: "pair", role: "group" });
    modes = [
      ["beside", "side by side"],
      ["overlaid", "overlaid"],
    ].map(([mode, text]) => [mode, button(pair, `${text} (M)`, text, () => act.set({ mode }))]);
  }
  const end = make(bar, "div", { className: "end" });
  for (const [title, content, press] of [
    ["show everything (F)", icon("fit"), () => act.fit()],
    ["light, dark (D)", icon("theme"), () => act.nextTheme()],
    ["keys (?)", "?", () => act.help()],
  ]) {
    button(end, title, content, press).classList.add("plain");
  }
  return (state) => {
    if (colour) colour.value = state.colour;
    for (const [name, input] of checks) input.checked = state[name];
    for (const [mode, element] of modes) element.setAttribute("aria-pressed", mode === state.mode);
  };
}

/// Returns {time(state), all(state)}: the first for every drawn frame, the second when anything else has changed.
export function controls(parent, options) {
  const time = transport(parent, options);
  const choice = choices(parent, options);
  return {
    time,
    all(state) {
      time(state);
      choice(state);
    },
  };
}
