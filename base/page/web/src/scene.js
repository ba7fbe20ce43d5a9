/* The figure "scene": the satellite in three dimensions, with what is to be seen on it. */
import { clockKey, nearest } from "./clock.js";
import { createColourBar } from "./colourbar.js";
import { css } from "./colour.js";
import { button, el, oncePerFrame } from "./dom.js";
import { number, quantity as withUnit, utcClock } from "./format.js";
import { createPlayer } from "./player.js";
import { choices, readScene } from "./scene_values.js";
import { createView } from "./scene_view.js";

function light(scene, i) {
  if (!scene.sunlit || !Number.isFinite(scene.sunlit[i])) return "";
  if (scene.sunlit[i] > 0.9995) return "in sunlight";
  return scene.sunlit[i] < 0.0005 ? "in umbra" : `in penumbra, ${number(100 * scene.sunlit[i], 2)} % of the Sun's disc`;
}

/** Two buttons of which one is pressed. */
function either(options, chosen, label, changed) {
  const buttons = options.map(([id, text]) => button(text, () => pick(id, true), { data: { id }, "aria-pressed": String(id === chosen) }));
  const pick = (id, told) => {
    for (const b of buttons) b.setAttribute("aria-pressed", String(b.dataset.id === id));
    if (told) changed(id);
  };
  return { node: el("div", { class: "segments", role: "group", "aria-label": label }, buttons), pick };
}

export function drawScene(figure, { array, host, clock, document: doc, frame }) {
  if (!doc.scene) throw new Error("the document has no scene");
  const scene = readScene(doc.scene, array);
  const all = choices(scene, array);
  clock.offer(scene.time);
  let shown = all.find((c) => c.id === figure.quantity) ?? all[0];
  let index = 0;
  let instant = false;
  let surface = -1;

  const stage = el("div", { class: "scene-view", tabindex: "0", role: "application" });
  const tip = el("div", { class: "scene-tip", hidden: true });
  const facet = el("p", { class: "readout" }, "Point at a facet to read it; drag to turn, arrow keys step the time.");
  const bar = createColourBar();
  const key = el("ul", { class: "kinds", "aria-label": "colours" });
  const player = scene.time.length > 1 ? createPlayer(scene.time, clock, (i) => light(scene, i)) : null;

  let view = null;
  let eye = null;
  try {
    view = createView(stage, scene, () => eye?.pick("free", false));
  } catch (error) {
    console.warn(`no picture of the satellite: ${error.message}`);
    stage.classList.add("no-webgl");
    stage.append(el("p", {}, "This browser gives no WebGL, so the satellite cannot be shown. Its values are in the table; all else on the page works."));
  }
  stage.append(tip);

  const select = el(
    "select",
    { on: { change: () => choose(select.value) } },
    all.map((c) => el("option", { value: c.id, selected: c === shown }, c.name)),
  );
  const box = (text, changed, checked) => el("label", { class: "check" }, el("input", { type: "checkbox", checked, on: { change: (e) => changed(e.target.checked) } }), text);
  const instantBox = box("Scale to this instant", (on) => {
    instant = on;
    paint();
  }, false);
  eye = view?.hasObserver ? either([["observer", "As the observer sees it"], ["free", "Free view"]], "observer", "Point of view", (id) => view.setMode(id)) : null;
  const pin = button("Keep in view", () => {
    const on = frame.classList.toggle("pinned");
    pin.setAttribute("aria-pressed", String(on));
    pin.textContent = on ? "Back to its place" : "Keep in view";
  }, { class: "pin", "aria-pressed": "false" });
  host.append(
    el("div", { class: "scene" },
      el("div", { class: "scene-controls" },
        el("label", { class: "choice" }, "Show ", select),
        eye?.node,
        view && scene.time.length > 0 ? box("Arrows", (on) => view.showArrows(on), true) : null,
        instantBox,
        view ? el("span", { class: "zoom-buttons" }, button("+", () => view.zoom(1.25), { "aria-label": "Nearer" }), button("−", () => view.zoom(0.8), { "aria-label": "Farther" })) : null,
        view ? pin : null,
      ),
      stage, facet, player?.node, bar.node, key,
    ),
  );

  function choose(id) {
    shown = all.find((c) => c.id === id) ?? all[0];
    select.value = shown.id;
    paint();
  }

  function paint() {
    view?.paint(shown.colours(index, instant));
    bar.node.hidden = Boolean(shown.kinds);
    instantBox.hidden = Boolean(shown.kinds);
    key.hidden = !shown.kinds;
    if (shown.kinds) {
      key.replaceChildren(
        ...shown.kinds.map((k) => el("li", {}, el("span", { class: "swatch area", style: { "--colour": css(k.colour) }, "aria-hidden": "true" }), k.name)),
      );
    } else {
      const [min, max] = shown.range(index, instant);
      bar.set({ name: shown.name, unit: shown.unit, min, max, log: shown.log });
    }
    tell();
  }

  /** Says what the facet is that is pointed at. */
  function tell() {
    const when = scene.time.length > 0 ? ` at ${utcClock(scene.time[index])} UTC` : "";
    stage.setAttribute("aria-label", `The satellite, coloured by ${shown.name}${when}. Arrow keys step the time, with Alt they turn the view.`);
    if (surface < 0) {
      tip.hidden = true;
      return;
    }
    const words = [scene.parts?.[scene.part[surface]], scene.materials?.[scene.material[surface]]];
    if (!shown.kinds) {
      const v = shown.value(index, surface);
      words.push(`${shown.name} ${withUnit(v, shown.unit)}`);
      bar.point(v);
    }
    facet.textContent = words.filter(Boolean).join(" · ");
    facet.classList.add("live");
    tip.replaceChildren(...words.filter(Boolean).map((w) => el("div", {}, w)));
    tip.hidden = false;
  }

  const point = oncePerFrame((x, y) => {
    surface = view.surfaceAt(x, y);
    tip.style.transform = `translate(${Math.min(x + 14, stage.clientWidth - 170)}px, ${y + 14}px)`;
    tell();
  });
  if (view) {
    view.canvas.addEventListener("pointermove", (e) => point(e.offsetX, e.offsetY));
    view.canvas.addEventListener("pointerleave", () => {
      surface = -1;
      tip.hidden = true;
    });
    stage.addEventListener("keydown", (e) => {
      const step = Math.PI / 24;
      const way = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[e.key];
      if (e.altKey && way) {
        view.turn(...way);
        e.preventDefault();
      } else if (e.key === "+" || e.key === "-") {
        view.zoom(e.key === "+" ? 1.25 : 0.8);
        e.preventDefault();
      } else clockKey(clock, e);
    });
  }

  const show = (at) => {
    const i = nearest(scene.time, at);
    if (i < 0 || i === index) return;
    index = i;
    view?.setTime(i);
    if (!shown.kinds) paint();
    else tell();
  };
  clock.moved.add(show);
  paint();
  player?.show(scene.time[0]);
  show(clock.at);

  const quantities = () => all.filter((c) => !c.kinds);
  const now = (c) => Float64Array.from({ length: scene.count }, (v, s) => c.value(index, s));
  return {
    clock,
    columns: () => [
      { name: "surface", values: Uint32Array.from({ length: scene.count }, (v, s) => s) },
      ...["part", "material"].map((id) => ({ name: id, values: Array.from({ length: scene.count }, (v, s) => all.find((c) => c.id === id).text(0, s)) })),
      ...quantities().map((c) => ({ name: scene.time.length > 0 ? `${c.name} at ${utcClock(scene.time[index])} UTC` : c.name, unit: c.unit, values: now(c) })),
    ],
    series: () => (shown.kinds ? [] : [{ name: shown.name, unit: shown.unit, time: scene.time[index], index, y: Array.from(now(shown)) }]),
    choose,
    view,
  };
}
