/* One parameter of a what-if: a slider with its stated interval, or a checkbox. */
import { button, el, freshId } from "./dom.js";
import { plain, quantity, unitText } from "./format.js";
import { isBeyond, rangeOf, statedInterval } from "./whatif.js";

const STEPS = 1000;
/** Width of a slider's handle, pixels. */
const HANDLE = 16;

/** Labels of one effect on several materials are alike; names tell them apart. */
const nameBelow = (p) => (p.label && p.label !== p.name ? el("span", { class: "slider-name" }, p.name) : null);

function numericField(p, id, changed) {
  return el("input", {
    type: "number",
    class: "slider-number",
    step: "any",
    min: Number.isFinite(p.minimum) ? p.minimum : undefined,
    max: Number.isFinite(p.maximum) ? p.maximum : undefined,
    "aria-label": `${p.label ?? p.name}, number`,
    on: { change: (e) => changed(e.target.valueAsNumber) },
  });
}

/**
 * @param {object} p a parameter of the document
 * @param {(value: number) => void} changed
 * @param {boolean} served a program computes what the line does not reach
 * @returns {{node: HTMLElement, set: (value: number) => void}}
 */
export function createSliderRow(p, changed, served) {
  return p.switch ? switchRow(p, changed) : sliderRow(p, changed, served);
}

function switchRow(p, changed) {
  const id = freshId("switch");
  const on = Number.isFinite(p.maximum) ? p.maximum : 1;
  const off = Number.isFinite(p.minimum) ? p.minimum : 0;
  const box = el("input", { type: "checkbox", id, on: { change: () => changed(box.checked ? on : off) } });
  const node = el(
    "div",
    { class: "slider-row switch-row", data: { name: p.name } },
    el("label", { for: id, class: "slider-label" }, box, el("span", {}, p.label ?? p.name, nameBelow(p))),
    p.text ? el("p", { class: "slider-text" }, p.text) : null,
  );
  return { node, set: (v) => (box.checked = v === on) };
}

function sliderRow(p, changed, served) {
  const id = freshId("slider");
  const { low, high, log } = rangeOf(p);
  const toPlace = (v) => STEPS * (log ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low));
  const atNull = Math.min(STEPS, Math.max(0, toPlace(p.null)));
  // The middle of what is known is met exactly, wherever it lies between the steps.
  const fromPlace = (s) => (Math.abs(s - atNull) < 0.75 ? p.null : log ? low * (high / low) ** (s / STEPS) : low + (s / STEPS) * (high - low));
  const within = (v) => Math.min(Number.isFinite(p.maximum) ? p.maximum : v, Math.max(Number.isFinite(p.minimum) ? p.minimum : v, v));
  const [from, to] = statedInterval(p);
  const bounded = Number.isFinite(p.reach);
  const share = (v) => Math.min(1, Math.max(0, toPlace(v) / STEPS));
  // The handle's middle keeps half its width from the ends.
  const left = (s) => `calc(${HANDLE / 2}px + (100% - ${HANDLE}px) * ${s})`;

  const slider = el("input", {
    type: "range", id, min: 0, max: STEPS, step: 1,
    on: { input: () => changed(fromPlace(Number(slider.value))) },
  });
  const field = numericField(p, id, (v) => (Number.isFinite(v) ? changed(within(v)) : set(p.null)));
  const interval = el("span", {
    class: "slider-interval",
    "aria-hidden": "true",
    style: { left: left(share(from)), width: `max(3px, calc((100% - ${HANDLE}px) * ${share(to) - share(from)}))` },
  });
  const origin = el("span", { class: "slider-null", "aria-hidden": "true", style: { left: left(share(p.null)) } });
  const note = el("p", { class: "slider-note", "aria-live": "polite" });
  const reset = button("Reset", () => changed(p.null), { class: "slider-reset", "aria-label": `Reset ${p.label ?? p.name}` });
  const node = el(
    "div",
    { class: "slider-row", data: { name: p.name } },
    el("label", { for: id, class: "slider-label" }, p.label ?? p.name, nameBelow(p)),
    el("div", { class: "slider-value" }, field, unitText(p.unit) ? el("span", { class: "soft" }, unitText(p.unit)) : null, reset),
    el("div", { class: "slider-track" }, bounded && p.reach > 0 ? interval : null, origin, slider),
    note,
    p.text ? el("p", { class: "slider-text" }, p.text) : null,
  );

  function set(v) {
    slider.value = String(toPlace(v));
    field.value = String(Number(v.toPrecision(6)));
    slider.setAttribute("aria-valuetext", quantity(v, p.unit));
    reset.hidden = v === p.null;
    const beyond = isBeyond(p, v);
    node.classList.toggle("beyond", beyond);
    node.classList.toggle("changed", v !== p.null);
    const end = served ? "it is computed." : "umbra serve computes it.";
    if (bounded && p.reach === 0) note.textContent = beyond ? `How far the straight line holds is not known; ${end}` : "";
    else
      note.textContent = !bounded
        ? ""
        : beyond
        ? `Beyond ${plain(from)} to ${plain(to)} the straight line is off by more than 1 %; ${end}`
        : `the line is good to 1 % from ${plain(from)} to ${plain(to)}`;
  }
  return { node, set };
}
