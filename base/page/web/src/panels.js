/* Panels below each other over one horizontal axis: curves, shaded stretches, a legend each, one readout. Figures of curves and of what-ifs both draw by it. */
import { el } from "./dom.js";
import { nearest } from "./clock.js";
import { seriesColours } from "./colour.js";
import { nameAndUnit, position, quantity, utcDate } from "./format.js";
import { createLegend } from "./legend.js";
import * as paint from "./paint.js";
import { createPlot, roomAbout } from "./plot.js";
import { reachOf, sampleAt } from "./series.js";
import { onTheme } from "./theme.js";

const HINT = "Point at the curves or use the arrow keys to read values; drag to zoom, double click to see all.";

/** Magnitudes, or powers of ten, that an axis shows at most: what is fainter is dark. */
const FAINTEST = 20;
const DECADES = 8;

/** What of [low, high] an axis shows at first. */
function shownOf([low, high], scale) {
  if (scale === "magnitude") return [low, Math.min(high, low + FAINTEST)];
  return scale === "log" ? [Math.max(low, high / 10 ** DECADES), high] : [low, high];
}

/** Lower and upper ends of areas that stand on each other. */
function stack(series) {
  let sum = null;
  for (const s of series) {
    s.base = null;
    s.top = null;
    if (!s.visible || s.own) continue;
    const base = sum ?? new Float64Array(s.y.length);
    s.base = base;
    s.top = Float64Array.from(s.y, (v, i) => base[i] + (Number.isFinite(v) ? v : 0));
    sum = s.top;
  }
}

function wholeStretch(x, series) {
  let min = Infinity;
  let max = -Infinity;
  for (const values of [x ?? [], ...series.map((s) => s.x)])
    for (const v of values) {
      if (!Number.isFinite(v)) continue;
      if (v < min) min = v;
      if (v > max) max = v;
    }
  if (!(min <= max)) return [0, 1];
  return min === max ? [min - 0.5, max + 0.5] : [min, max];
}

const height = (count, host) => {
  const narrow = host.clientWidth < 520;
  if (count === 1) return narrow ? 220 : 280;
  if (count === 2) return narrow ? 165 : 205;
  return narrow ? 140 : 178;
};

/**
 * @param {object} o
 * @param {HTMLElement} o.host @param {import("./clock.js").Clock} o.clock @param {string} o.title
 * @param {{name: string, unit: string, scale: string}} o.x @param {ArrayLike<number>|null} o.xs ascending values of the axis
 * @param {{from: number, to: number, name: string}[]} o.shades
 * @param {{name, unit, scale, stacked, zero, series: object[]}[]} o.panels series as of series.js
 * @param {{name: string}[]} [o.sets] whose number a series may carry
 * @param {string} [o.dashed] what a dashed grey line is
 * @param {(at: number) => string} [o.remark] said behind the place in the readout
 */
export function createPanels(o) {
  const { host, clock, x, shades } = o;
  const every = o.panels.flatMap((p) => p.series);
  const full = wholeStretch(o.xs, every);
  if (every.length > 0 && every.every((s) => s.mark === "points") && x.scale !== "log") {
    // Points at the ends stand free of the frame.
    const room = 0.015 * (full[1] - full[0]);
    full[0] -= room;
    full[1] += room;
  }
  const usable = o.xs && o.xs.length > 0 && every.some((s) => !s.own);
  const steps = usable ? o.xs : [...new Set(every.flatMap((s) => [...s.x]))].sort((a, b) => a - b);
  clock.offer(steps);
  const snap = (at) => (steps.length > 0 ? steps[nearest(steps, at)] : at);
  const readout = el("p", { class: "readout" }, HINT);
  host.append(readout);

  const shadesAt = (at) => shades.filter((s) => at >= s.from && at <= s.to).map((s) => s.name);
  const near = (s, at) => sampleAt(s, at, s.own || s.mark === "points" ? 0.02 * (full[1] - full[0]) : Infinity);
  const spokenOf = (series, unit) => (at) =>
    [
      position(at, x),
      ...series.filter((s) => s.visible).map((s) => {
        const v = near(s, at);
        return v && Number.isFinite(v.y) ? `${s.name} ${quantity(v.y, unit)}` : null;
      }),
    ]
      .filter(Boolean)
      .join(", ");

  const panels = o.panels.map((p, index) => {
    const { series } = p;
    const looks = seriesColours(series);
    series.forEach((s, i) => Object.assign(s, looks[i]));
    if (o.sets?.length > 1) for (const s of series) if (s.set !== undefined) s.detail = o.sets[s.set]?.name;
    if (p.stacked) stack(series);
    const lines = usable ? series.filter((s) => !s.own && s.mark !== "points") : [];
    const log = p.scale === "log";
    const drawn = (s) => {
      const values = s.top ?? s.y;
      return Array.from(values, (v) => (s.visible && Number.isFinite(v) && !(log && v <= 0) ? v : null));
    };
    const legend = createLegend(series, () => {
      if (p.stacked) stack(series);
      panels[index].plot.refresh();
      show(clock.at);
    });
    const frame = el("div", { class: "plot" });
    const single = series.length === 1 && String(series[0].name) === String(p.name) && !series[0].detail;
    if (single) legend.node.classList.add("single");
    host.append(
      el(
        "div",
        { class: "panel" },
        el("div", { class: "panel-head" }, el("p", { class: "panel-name" }, nameAndUnit(p.name, p.unit)), legend.node),
        frame,
      ),
    );
    const visible = () => series.filter((s) => s.visible);
    const plot = createPlot({
      host: frame,
      clock,
      full,
      xType: x.scale ?? "linear",
      yType: p.scale ?? "linear",
      height: height(o.panels.length, host) + (index === o.panels.length - 1 ? 22 : 0),
      last: index === o.panels.length - 1,
      label: `${o.title}: ${nameAndUnit(p.name, p.unit)} over ${x.name}`,
      lines: lines.map((s) => ({ colour: s.colour, dash: s.dash, width: s.base !== undefined ? 0 : s.role === "part" || s.mark === "area" ? 1.25 : 1.9, step: s.mark === "step" })),
      data: () => (usable ? [o.xs, ...lines.map(drawn)] : [full]),
      yRange: (from, to) => roomAbout(...shownOf(reachOf(series, from, to, log), p.scale), p.scale ?? "linear", p.zero || p.stacked, p.unit !== "K"),
      snap,
      spoken: spokenOf(series, p.unit),
      dots: (at) =>
        visible()
          .filter((s) => !s.own && s.mark !== "points" && s.x.length > 0)
          .map((s) => {
            const i = nearest(s.x, at);
            return { x: s.x[i], y: (s.top ?? s.y)[i], colour: s.colour() };
          })
          .filter((d) => Number.isFinite(d.y) && !(log && d.y <= 0)),
      below: (u) => {
        paint.paintShades(u, shades);
        for (const s of visible()) {
          if (s.base) paint.paintBetween(u, s, (i) => s.base[i], (i) => s.top[i], s.colour(), 0.62);
          else if (s.mark === "area") paint.paintBetween(u, s, () => (log ? u.scales.y.min : 0), (i) => s.y[i], s.colour(), 0.3);
          if (!s.top && s.mark !== "points" && (s.error || (s.low && s.high))) paint.paintBand(u, s, s.colour());
        }
        if (p.zero) paint.paintLevel(u, 0);
      },
      above: (u) => {
        if (index === 0) paint.paintShadeNames(u, shades);
        for (const s of visible()) {
          if (s.mark === "points") paint.paintPoints(u, s, s.colour(), s.x.length > 400);
          else if (s.own) paint.paintLine(u, s, s.colour(), 1.9, s.dash);
        }
      },
    });
    return { ...p, plot, legend, lines, drawn };
  });

  const label = x.scale === "time" ? `UTC, ${dates(full)}` : nameAndUnit(x.name, x.unit);
  host.append(el("p", { class: "x-name" }, label, shadeKey(shades, o.dashed)));

  function show(at) {
    if (!Number.isFinite(at)) return;
    const inside = at >= full[0] && at <= full[1];
    for (const p of panels) p.legend.show(p.series.map((s) => (inside && s.visible ? near(s, at) : null)));
    readout.textContent = inside ? [position(at, x), ...shadesAt(at), o.remark?.(at)].filter(Boolean).join(" · ") : HINT;
    readout.classList.toggle("live", inside);
  }
  clock.moved.add(show);
  show(clock.at);

  return {
    /** uPlot's objects, for tests. */
    plots: panels.map((p) => p.plot.uplot),
    /** Draws again after the numbers of series changed. */
    refresh() {
      for (const p of panels) {
        if (p.stacked) stack(p.series);
        p.plot.refresh();
      }
      show(clock.at);
    },
    /** What is drawn, read back from the plots: of uPlot's lines its own data. */
    drawn: () =>
      panels.flatMap((p) =>
        p.series.map((s) => {
          const line = p.lines.indexOf(s);
          const out = { panel: p.name, name: s.name, unit: p.unit, set: s.set, column: s.column, visible: s.visible, mark: s.mark, x: Array.from(s.x), y: Array.from(s.y) };
          for (const key of ["error", "low", "high"]) if (s[key]) out[key] = Array.from(s[key]);
          if (line >= 0) out.drawn = Array.from(p.plot.uplot.data[line + 1]);
          return out;
        }),
      ),
  };
}

function dates([from, to]) {
  const [a, b] = [utcDate(from), utcDate(to)];
  return a === b ? a : `${a} to ${b}`;
}

function shadeKey(shades, dashed) {
  const names = [...new Set(shades.map((s) => s.name))];
  const keys = names.map((name) => {
    const swatch = el("span", { class: "swatch shade", "aria-hidden": "true" });
    const tint = () => swatch.style.setProperty("--colour", paint.shadeColour(name, names));
    tint();
    onTheme(tint);
    return el("span", { class: "shade-key" }, swatch, name);
  });
  if (dashed) keys.unshift(el("span", { class: "shade-key" }, el("span", { class: "swatch dashed plain", "aria-hidden": "true" }), dashed));
  return keys.length > 0 ? el("span", { class: "shade-keys" }, keys) : null;
}

/** Columns of panels for tables and files: the axis and what shares it, then series with places of their own. */
export function panelColumns(x, xs, panels, sets) {
  const time = x.scale === "time";
  const columns = xs && xs.length > 0 ? [{ name: x.name, unit: x.unit, time, values: xs }] : [];
  for (const p of panels)
    for (const s of p.series) {
      const set = s.set !== undefined && sets?.length > 1 ? ` (${sets[s.set]?.name})` : "";
      const name = (String(s.name) === String(p.name) ? s.name : `${s.name} ${p.name ?? ""}`.trim()) + set;
      if (s.stored.x !== xs) columns.push({ name: `${name} ${x.name}`, unit: x.unit, time, values: s.stored.x });
      columns.push({ name, unit: p.unit, values: s.stored.y });
      for (const [key, word] of [["error", "sigma"], ["low", "low"], ["high", "high"]])
        if (s.stored[key]) columns.push({ name: `${name} ${word}`, unit: p.unit, values: s.stored[key] });
    }
  return columns;
}

