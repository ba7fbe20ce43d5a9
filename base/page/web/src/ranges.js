/* The figure "ranges": what a thing reaches, as a bar, between strokes for what it may. */
import { el } from "./dom.js";
import { nameAndUnit, quantity } from "./format.js";
import { tickLabels, ticks } from "./ticks.js";

const finite = (v) => Number.isFinite(v);
const percent = (share) => `${(100 * Math.min(1, Math.max(0, share))).toFixed(3)}%`;

function stretch(ranges) {
  const values = ranges.flatMap((r) => [r.low - (r.error ?? 0), r.high + (r.error ?? 0), r.minimum, r.maximum]).filter(finite);
  if (values.length === 0) return [0, 1];
  const [min, max] = [Math.min(...values), Math.max(...values)];
  const room = 0.03 * (max - min) || 0.5;
  return [min - room, max + room];
}

/** "hot: 290 K to 310 K, may 273 K to 313 K, kept by 3 K" */
function spoken(r, unit) {
  const q = (v) => quantity(v, unit);
  const may = [finite(r.minimum) ? `from ${q(r.minimum)}` : "", finite(r.maximum) ? `to ${q(r.maximum)}` : ""].filter(Boolean).join(" ");
  return [`${r.name}, ${r.of ?? ""}: ${q(r.low)} to ${q(r.high)}`, may && `may ${may}`, r.text].filter(Boolean).join(", ");
}

export function drawRanges(figure, { host }) {
  const { ranges, unit } = figure;
  const [from, to] = stretch(ranges);
  const share = (v) => (v - from) / (to - from);
  const marks = ticks(from, to, 6, "linear");
  const labels = tickLabels(marks, "linear");
  const bar = (low, high, kind) => el("div", { class: `range ${kind}`, style: { left: percent(share(low)), width: percent(share(high) - share(low)) } });
  // What lies beyond a limit has a colour of its own.
  const pieces = (r, error, kind) => {
    const [low, high] = [r.low - error, r.high + error];
    const [least, most] = [finite(r.minimum) ? r.minimum : -Infinity, finite(r.maximum) ? r.maximum : Infinity];
    return [
      [low, Math.min(high, least), "beyond"],
      [Math.max(low, least), Math.min(high, most), ""],
      [Math.max(low, most), high, "beyond"],
    ].flatMap(([a, b, where]) => (a < b || (where === "" && low === high && a === b) ? [bar(a, b, `${kind} ${where}`.trim())] : []));
  };
  const limit = (v) => (finite(v) ? el("span", { class: "range-limit", style: { left: percent(share(v)) } }) : null);

  const rows = ranges.map((r, i) => {
    const first = i === 0 || ranges[i - 1].name !== r.name;
    const track = el("div", { class: "bar-track" }, marks.map((m) => el("span", { class: "bar-grid", style: { left: percent(share(m)) } })));
    if (finite(r.low) && finite(r.high)) {
      if (r.error > 0) track.append(...pieces(r, r.error, "pale"));
      track.append(...pieces(r, 0, ""));
    }
    track.append(...[limit(r.minimum), limit(r.maximum)].filter(Boolean));
    return el(
      "div",
      { class: `range-row${first ? " first" : ""}${r.exceeded ? " exceeded" : ""}`, role: "listitem", title: spoken(r, unit) },
      el("div", { class: "bar-name" }, first ? r.name : ""),
      el("div", { class: "range-of" }, r.of ?? ""),
      track,
      el("div", { class: "range-text" }, r.text ?? ""),
    );
  });
  const axis = el("div", { class: "bar-track" }, marks.map((m, i) => el("span", { class: "bar-tick", style: { left: percent(share(m)) } }, labels[i])));
  host.append(
    el("p", { class: "panel-name" }, nameAndUnit(figure.name, unit)),
    el(
      "div",
      { class: "range-rows", role: "list", "aria-label": `${figure.title}: ${ranges.map((r) => spoken(r, unit)).join("; ")}` },
      rows,
      el("div", { class: "range-row bar-axis", "aria-hidden": "true" }, el("div"), el("div"), axis, el("div")),
    ),
  );
  const numbers = (key, name) => ({ name, unit, values: ranges.map((r) => r[key] ?? NaN) });
  const columns = () => [
    { name: "name", values: ranges.map((r) => String(r.name)) },
    { name: "of", values: ranges.map((r) => String(r.of ?? "")) },
    numbers("low", "lowest"),
    numbers("high", "highest"),
    numbers("error", "uncertainty"),
    numbers("minimum", "minimum"),
    numbers("maximum", "maximum"),
    { name: "remark", values: ranges.map((r) => String(r.text ?? "")) },
  ];
  return { columns, series: () => [{ name: figure.name, unit, x: ranges.map((r) => `${r.name}, ${r.of ?? ""}`), low: ranges.map((r) => r.low), high: ranges.map((r) => r.high) }] };
}
