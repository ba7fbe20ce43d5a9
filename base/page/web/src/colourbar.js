/* The bar that says which colour means which value. */
import { css, mapColour, shareOf } from "./colour.js";
import { el } from "./dom.js";
import { nameAndUnit, powerOfTen } from "./format.js";
import { commonPower, tickLabels, ticks } from "./ticks.js";

/**
 * @returns {{node: HTMLElement, set: (o: {name, unit, min, max, log?: boolean, diverging?: boolean}) => void, point: (value: number) => void}}
 */
export function createColourBar() {
  const canvas = el("canvas", { width: 256, height: 1, "aria-hidden": "true" });
  const scale = el("div", { class: "colourbar-scale" });
  const pointer = el("span", { class: "colourbar-pointer", hidden: true });
  const name = el("p", { class: "panel-name" });
  const node = el("div", { class: "colourbar" }, name, el("div", { class: "colourbar-strip" }, canvas, pointer), scale);
  let place = () => NaN;
  return {
    node,
    set({ name: title, unit, min, max, log = false, diverging = false }) {
      const context = canvas.getContext("2d");
      for (let i = 0; i < 256; i += 1) {
        context.fillStyle = css(mapColour(i / 255, diverging));
        context.fillRect(i, 0, 1, 1);
      }
      const size = Math.max(Math.abs(min), Math.abs(max));
      const [low, high] = diverging ? [-size, size] : [min, max];
      place = shareOf(min, max, { log, diverging });
      const known = Number.isFinite(low) && Number.isFinite(high);
      const marks = known ? (high > low ? ticks(low, high, 5, log ? "log" : "linear") : [low]) : [];
      const labels = tickLabels(marks, log ? "log" : "linear");
      const power = commonPower(marks, log ? "log" : "linear");
      name.textContent = nameAndUnit(title, unit) + (power ? `, ×${powerOfTen(power)}` : "");
      scale.replaceChildren(...marks.map((m, i) => el("span", { style: { left: `${100 * place(m)}%` } }, labels[i])));
      pointer.hidden = true;
    },
    point(value) {
      const share = place(value);
      pointer.hidden = !(share >= 0 && share <= 1);
      if (!pointer.hidden) pointer.style.left = `${100 * share}%`;
    },
  };
}
