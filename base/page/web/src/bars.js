/* The figure "bars": named values beside each other, with errors. */
import { el } from "./dom.js";
import { nameAndUnit, number, powerOfTen, quantity } from "./format.js";
import { commonPower, tickLabels, ticks } from "./ticks.js";

function scaleOf(bars, log) {
  const values = bars.flatMap((b) => [b.value, b.value - (b.error ?? 0), b.value + (b.error ?? 0)]).filter((v) => Number.isFinite(v) && (!log || v > 0));
  if (log) {
    const lowest = Math.min(...values);
    const min = 10 ** Math.floor(Math.log10(values.length ? lowest : 1) - 0.01);
    const max = 10 ** Math.ceil(Math.log10(Math.max(...values, min * 10)));
    return { min, max, share: (v) => (v > 0 ? Math.log(v / min) / Math.log(max / min) : 0), base: 0 };
  }
  const min = Math.min(0, ...values);
  const max = Math.max(0, ...values) || (min === 0 ? 1 : 0);
  const room = 0.02 * (max - min);
  const [low, high] = [min < 0 ? min - room : 0, max > 0 ? max + room : 0];
  const share = (v) => (v - low) / (high - low);
  return { min: low, max: high, share, base: share(0) };
}

const percent = (share) => `${(100 * Math.min(1, Math.max(0, share))).toFixed(3)}%`;

export function drawBars(figure, { host }) {
  const { bars, unit } = figure;
  const log = figure.scale === "log";
  const scale = scaleOf(bars, log);
  const marks = ticks(scale.min, scale.max, 5, log ? "log" : "linear");
  const labels = tickLabels(marks, log ? "log" : "linear");
  const power = commonPower(marks, log ? "log" : "linear");
  const tick = (i) => labels[i] + (power && i === marks.length - 1 ? `×${powerOfTen(power)}` : "");
  const grid = () => marks.map((m) => el("span", { class: "bar-grid", style: { left: percent(scale.share(m)) } }));

  const rows = bars.map((b) => {
    const known = Number.isFinite(b.value);
    const end = known ? scale.share(b.value) : scale.base;
    const left = Math.min(end, scale.base);
    const track = el("div", { class: "bar-track" }, grid());
    if (known) track.append(el("div", { class: `bar${b.value < 0 ? " negative" : ""}`, style: { left: percent(left), width: percent(Math.abs(end - scale.base)) } }));
    if (known && b.error > 0) {
      const [low, high] = [scale.share(b.value - b.error), scale.share(b.value + b.error)];
      track.append(el("div", { class: "bar-error", style: { left: percent(low), width: percent(Math.min(1, high) - Math.max(0, low)) } }));
    }
    return el(
      "div",
      { class: "bar-row", role: "listitem" },
      el("div", { class: "bar-name" }, b.name),
      track,
      el("div", { class: "bar-value" }, known ? number(b.value, 3) : "–", b.error > 0 ? el("span", { class: "soft" }, ` ± ${number(b.error, 2)}`) : null),
      b.text ? el("div", { class: "bar-text" }, b.text) : null,
    );
  });
  host.append(
    el("p", { class: "panel-name" }, nameAndUnit(figure.name, unit)),
    el("div", { class: "bars", role: "list", "aria-label": `${figure.title}: ${bars.map((b) => `${b.name} ${quantity(b.value, unit, 3)}`).join(", ")}` }, rows),
    el(
      "div",
      { class: "bar-row bar-axis", "aria-hidden": "true" },
      el("div"),
      el("div", { class: "bar-track" }, marks.map((m, i) => el("span", { class: "bar-tick", style: { left: percent(scale.share(m)) } }, tick(i)))),
      el("div"),
    ),
  );
  const columns = () => {
    const out = [
      { name: "name", values: bars.map((b) => String(b.name)) },
      { name: figure.name ?? "value", unit, values: bars.map((b) => b.value ?? NaN) },
    ];
    if (bars.some((b) => b.error !== undefined)) out.push({ name: `${figure.name ?? "value"} sigma`, unit, values: bars.map((b) => b.error ?? NaN) });
    if (bars.some((b) => b.text)) out.push({ name: "remark", values: bars.map((b) => String(b.text ?? "")) });
    return out;
  };
  return { columns, series: () => [{ name: figure.name, unit, x: bars.map((b) => b.name), y: bars.map((b) => b.value) }] };
}
