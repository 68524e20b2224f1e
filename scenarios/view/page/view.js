// The page: the picture with its bar, the series below, and what is to be said of the data. The state is in one object;
// all changes of it go through `set`.

import { moves } from "./camera.js";
import { advance, allTimes, speeds, stepFrom, timeWriter } from "./clock.js";
import { scaleOf } from "./colours.js";
import { controls } from "./controls.js";
import { radii, readRuns } from "./data.js";
import { make } from "./dom.js";
import { fromFragment } from "./fragment.js";
import { keys } from "./keys.js";
import { legend, viewNames } from "./legend.js";
import { Pace } from "./pace.js";
import { plots } from "./plots.js";
import { Scene } from "./scene.js";

const page = document.getElementById("page");
const root = document.documentElement;
const prefersDark = matchMedia("(prefers-color-scheme: dark)");
const manyStripes = 3000; // of so many balls stripes are noise

function head(runs) {
  const { scenario, doc } = runs[0].header;
  make(page, "h1", {}, scenario);
  if (doc) make(page, "p", { className: "doc" }, doc);
  const facts = runs.map(({ header: { label, bodies } }) =>
    [label, `${bodies.toLocaleString("en")} ${bodies === 1 ? "body" : "bodies"}`].filter(Boolean).join(", "),
  );
  make(page, "p", { className: "facts" }, facts.join(" \u00b7 "));
}

function notes(runs) {
  const said = new Set(runs.flatMap((run) => run.header.notes ?? []));
  if (!said.size) return;
  const list = make(make(page, "section", { className: "notes" }), "ul");
  for (const note of said) make(list, "li", {}, note);
}

/// What there is to choose from, and what is chosen at first.
function offers(runs) {
  const several = runs.length > 1;
  const scales = {};
  for (const name of ["speed", "energy", "contacts"]) {
    const scale = scaleOf(runs, name);
    if (scale) scales[name] = scale;
  }
  const groups = runs.some((run) => run.header.groups.length > 1);
  const colours = [...(several ? ["run"] : []), ...Object.keys(scales), ...(groups ? ["group"] : []), "plain"];
  const turning = runs.filter((run) => run.columns.orientation);
  const balls = turning.some((run) => radii(run).some((r) => r > 0));
  // Of points that turn the axes show it; where runs are compared, only of those that do nothing else.
  const points = turning.length > 0 && !balls && (!several || !turning.some(moves));
  return { several, scales, colours, balls, points };
}

function firstState(runs, { colours, balls, points }, usual, start) {
  const bodies = Math.max(...runs.map((run) => run.bodies));
  const said = fromFragment();
  const state = {
    time: start,
    playing: said.time === undefined && !matchMedia("(prefers-reduced-motion: reduce)").matches,
    rate: usual,
    loop: true,
    colour: colours[0],
    mode: "beside",
    theme: prefersDark.matches ? "dark" : "light",
    stripes: balls && bodies <= manyStripes,
    axes: points && bodies <= 500,
    paths: bodies <= 12,
    boundaries: true,
    look: undefined,
    ...said,
  };
  if (!colours.includes(state.colour)) state.colour = colours[0];
  return state;
}

class Page {
  constructor(runs) {
    this.runs = runs;
    this.times = allTimes(runs);
    this.span = [this.times[0], this.times[this.times.length - 1]];
    this.offer = offers(runs);
    this.speeds = speeds(this.span[1] - this.span[0]);
    this.state = firstState(runs, this.offer, this.speeds.usual, this.span[0]);
    this.drawn = 0;
    this.pace = new Pace();
    this.build();
    this.set({});
    this.fit(this.state.look);
  }

  build() {
    const { runs, span, offer } = this;
    head(runs);
    const card = make(page, "div", { className: "card" });
    this.stage = make(card, "div", { className: "stage" });
    this.canvas = make(this.stage, "canvas", { tabIndex: 0 });
    this.canvas.setAttribute("aria-label", "the motion");
    this.names = make(this.stage, "div", { className: "view-names" });
    this.legend = make(this.stage, "div", { className: "legend" });
    this.thinned = make(this.stage, "div", { className: "thinned" });
    this.startPicture();
    const writer = timeWriter(span[1] - span[0]);
    const act = this.actions();
    const has = {
      stripes: offer.balls,
      axes: this.scene?.parts.some((part) => part.axes),
      paths: this.scene?.parts.some((part) => part.paths),
      boundaries: runs.some((run) => run.header.boundaries.length),
    };
    this.controls = controls(card, {
      act,
      has,
      span,
      writer,
      rates: [...new Set([...this.speeds.rates, this.state.rate])].sort((a, b) => a - b),
      colours: offer.colours,
      several: offer.several,
    });
    keys(act);
    const below = make(page, "section", { className: "plots" });
    this.showPlots = plots(below, runs, { span, writer, scrub: act.scrub });
    notes(runs);
    prefersDark.addEventListener("change", () => this.set({ theme: prefersDark.matches ? "dark" : "light" }));
    addEventListener("hashchange", () => {
      const said = fromFragment();
      this.set(said);
      if (said.look) this.fit(said.look);
    });
  }

  startPicture() {
    try {
      this.scene = new Scene(this.canvas, this.runs, () => this.redraw());
    } catch {
      this.canvas.remove();
      make(
        this.stage,
        "p",
        { className: "missing" },
        "The motion needs WebGL 2, which this browser does not offer here.",
      );
      return;
    }
    this.canvas.ondblclick = () => this.fit();
    this.canvas.addEventListener("webglcontextrestored", () => this.redraw());
    new ResizeObserver(() => this.layOut()).observe(this.stage);
  }

  actions() {
    const set = (change) => this.set(change);
    const cycle = (list, item) => list[(list.indexOf(item) + 1) % list.length];
    return {
      set,
      toggle: () => {
        const ended = this.state.time >= this.span[1];
        set({ playing: !this.state.playing, ...(ended && !this.state.playing ? { time: this.span[0] } : {}) });
      },
      step: (by) => set({ playing: false, time: stepFrom(this.times, this.state.time, by) }),
      scrub: (time) => set({ playing: false, time }),
      flip: (name) => set({ [name]: !this.state[name] }),
      faster: (by) => {
        const { rates } = this.speeds;
        const next = by > 0 ? rates.find((r) => r > this.state.rate) : rates.findLast((r) => r < this.state.rate);
        if (next) set({ rate: next });
      },
      fit: () => this.fit(),
      nextColour: () => set({ colour: cycle(this.offer.colours, this.state.colour) }),
      nextMode: () => this.offer.several && set({ mode: cycle(["beside", "overlaid"], this.state.mode) }),
      nextTheme: () => set({ theme: cycle(["light", "dark"], this.state.theme) }),
    };
  }

  set(change) {
    const { state } = this;
    Object.assign(state, change);
    state.time = Math.min(Math.max(state.time, this.span[0]), this.span[1]);
    const looks = Object.keys(change).some((name) => !["time", "playing", "rate", "loop"].includes(name));
    if (looks || !this.drawn) this.restyle();
    this.controls.all(state);
    this.redraw();
  }

  restyle() {
    const { state, runs } = this;
    root.dataset.theme = state.theme;
    const dark = state.theme === "dark";
    const scale = this.offer.scales[state.colour];
    this.scene?.style({ ...state, scale, dark });
    const axes = state.axes && this.scene?.parts.some((part) => part.axes);
    legend(this.legend, runs, { ...state, scale, dark, axes });
    this.layOut();
  }

  layOut() {
    const { scene, runs, state } = this;
    if (!scene) return;
    scene.views = state.mode === "beside" ? runs.length : 1;
    scene.resize();
    if (scene.fitted && !scene.touched) scene.fit(scene.fitted); // until somebody chooses another look
    const areas = scene.views > 1 ? runs.map((_, i) => scene.area(i)) : [];
    viewNames(this.names, runs, areas, this.canvas.clientHeight);
    this.redraw();
  }

  fit(look) {
    this.scene?.fit(look);
    this.redraw();
  }

  redraw() {
    this.waiting ??= requestAnimationFrame((now) => this.frame(now));
  }

  frame(now) {
    this.waiting = undefined;
    const { state } = this;
    let busy = false;
    if (state.playing) {
      // After a pause of the browser's own the motion goes on where it was.
      const passed = Math.min((now - (this.last ?? now)) / 1000, 0.25);
      if (this.last) this.pace.note(passed);
      busy = passed > 0.03;
      const wasPlaying = state.playing;
      Object.assign(state, advance(state, passed, this.span));
      if (state.playing !== wasPlaying) this.controls.all(state);
    }
    this.last = state.playing ? now : undefined;
    this.scene?.show(state.time);
    this.drawPicture();
    // Where drawing is slow the time and the plots take their share of it only now and then.
    if (!busy || this.drawn % 4 === 0) {
      this.controls.time(state);
      this.showPlots(state.time);
    }
    this.tell();
    if (state.playing) this.redraw();
  }

  drawPicture() {
    if (!this.scene) return;
    const share = this.state.playing || this.scene.dragged ? this.pace.share : 1;
    this.scene.draw(share);
    this.thinned.hidden = !this.scene.crowd || share === 1;
    this.thinned.textContent = `while it moves, 1 of ${1 / share} bodies is drawn`;
  }

  /// For tests: what is on screen now, and when something first was.
  tell() {
    if (!this.drawn++) {
      this.scene?.finish();
      root.dataset.drawn = Math.round(performance.now());
    }
    root.dataset.time = this.state.time;
    root.dataset.frames = this.drawn;
  }
}

async function start() {
  page.replaceChildren();
  root.dataset.theme = prefersDark.matches ? "dark" : "light";
  if (typeof DecompressionStream === "undefined") {
    throw new Error("this browser cannot inflate data (it has no DecompressionStream); versions since 2023 can");
  }
  const waiting = make(page, "p", { className: "waiting" }, "Reading the motion\u2026");
  const runs = await readRuns();
  waiting.remove();
  window.ballpark = new Page(runs);
}

start().catch((error) => {
  console.error(error);
  page.replaceChildren();
  make(page, "p", { className: "missing" }, `The motion cannot be shown: ${error.message}.`);
  root.dataset.failed = error.message;
});
