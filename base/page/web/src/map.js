/* The figure "map": a value over two axes, as colours. */
import { Clock, nearest } from "./clock.js";
import { css, extent, mapColour, shareOf } from "./colour.js";
import { createColourBar } from "./colourbar.js";
import { el } from "./dom.js";
import { nameAndUnit, position, quantity, utcDate } from "./format.js";
import { createPlot } from "./plot.js";

/** Edges of cells about places: half way between neighbours. */
function edges(places) {
  const n = places.length;
  if (n === 1) return [places[0] - 0.5, places[0] + 0.5];
  const out = [places[0] - (places[1] - places[0]) / 2];
  for (let i = 1; i < n; i += 1) out.push((places[i - 1] + places[i]) / 2);
  out.push(places[n - 1] + (places[n - 1] - places[n - 2]) / 2);
  return out;
}

const short = (text) => (text.length > 20 ? `${text.slice(0, 19)}…` : text);

export function drawMap(figure, { array, host, clock: shared }) {
  const { x, y, z } = figure;
  const time = x.scale === "time" || x.unit === "UTC";
  const axis = { ...x, scale: time ? "time" : "linear" };
  const clock = time ? shared : new Clock();
  const [xs, ys, zs] = [array(x.data) ?? [], array(y.data) ?? [], array(z.data) ?? []];
  clock.offer(xs);
  const log = z.scale === "log";
  const [min, max] = extent(zs, log);
  const share = shareOf(min, max, { log, diverging: figure.diverging });
  const ex = edges(xs);
  const ey = edges(ys);
  const bar = createColourBar();
  bar.set({ name: z.name, unit: z.unit, min, max, log, diverging: figure.diverging });
  const readout = el("p", { class: "readout" }, "Point at the map to read values.");
  const frame = el("div", { class: "plot map" });
  host.append(
    readout,
    el("div", { class: "panel" }, el("div", { class: "panel-head" }, el("p", { class: "panel-name" }, nameAndUnit(y.name, y.unit))), frame),
    el("p", { class: "x-name" }, time && xs.length > 0 ? `UTC, ${utcDate(xs[0])}` : nameAndUnit(x.name, x.unit)),
    bar.node,
  );

  let row = 0;
  const value = (at) => zs[row * xs.length + nearest(xs, at)];
  const say = (at) => `${position(at, axis)}, ${y.name} ${y.labels?.[row] ?? quantity(ys[row], y.unit)}: ${z.name} ${quantity(value(at), z.unit)}`;
  const plot = createPlot({
    host: frame,
    clock,
    full: [Math.min(ex[0], ex.at(-1)), Math.max(ex[0], ex.at(-1))],
    xType: axis.scale,
    yType: "linear",
    height: host.clientWidth < 520 ? 240 : 320,
    last: true,
    lines: [],
    label: `${figure.title}: ${z.name} over ${x.name} and ${y.name}`,
    data: () => [[ex[0], ex.at(-1)]],
    names: y.labels ? { places: ys, texts: y.labels.map(short) } : undefined,
    yRange: () => [Math.min(ey[0], ey.at(-1)), Math.max(ey[0], ey.at(-1))],
    snap: (at) => xs[nearest(xs, at)] ?? at,
    spoken: say,
    above: paintCells,
  });

  function paintCells(u) {
    const { ctx, bbox } = u;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    const px = ex.map((v) => u.valToPos(v, "x", true));
    const py = ey.map((v) => u.valToPos(v, "y", true));
    for (let j = 0; j < ys.length; j += 1)
      for (let i = 0; i < xs.length; i += 1) {
        const v = zs[j * xs.length + i];
        if (!Number.isFinite(v)) continue;
        ctx.fillStyle = css(mapColour(share(v), figure.diverging));
        const [left, right] = [Math.round(Math.min(px[i], px[i + 1])), Math.round(Math.max(px[i], px[i + 1]))];
        const [top, bottom] = [Math.round(Math.min(py[j], py[j + 1])), Math.round(Math.max(py[j], py[j + 1]))];
        ctx.fillRect(left, top, Math.max(1, right - left), Math.max(1, bottom - top));
      }
    ctx.restore();
  }

  const show = (at) => {
    const inside = xs.length > 0 && at >= Math.min(ex[0], ex.at(-1)) && at <= Math.max(ex[0], ex.at(-1));
    if (!inside) return;
    readout.textContent = say(at);
    readout.classList.add("live");
    bar.point(value(at));
  };
  plot.uplot.over.addEventListener("mousemove", (e) => {
    const at = plot.uplot.posToVal(e.offsetY, "y");
    const next = ascendingNearest(ys, at);
    if (next !== row) {
      row = next;
      show(clock.at);
    }
  });
  frame.addEventListener("keydown", (e) => {
    if (e.key !== "ArrowUp" && e.key !== "ArrowDown") return;
    row = Math.min(ys.length - 1, Math.max(0, row + (e.key === "ArrowUp" ? 1 : -1)));
    show(clock.at);
    e.preventDefault();
  });
  clock.moved.add(show);

  const columns = () => {
    const cells = xs.length * ys.length;
    const take = (f) => Float64Array.from({ length: cells }, (v, k) => f(k));
    return [
      { name: x.name, unit: x.unit, time, values: take((k) => xs[k % xs.length]) },
      { name: y.name, unit: y.unit, values: take((k) => ys[Math.floor(k / xs.length)]) },
      { name: z.name, unit: z.unit, values: zs },
    ];
  };
  return { clock, plots: [plot.uplot], columns, series: () => [{ name: z.name, unit: z.unit, x: Array.from(xs), y: Array.from(ys), z: Array.from(zs) }] };
}

function ascendingNearest(values, at) {
  let best = 0;
  for (let i = 1; i < values.length; i += 1) if (Math.abs(values[i] - at) < Math.abs(values[best] - at)) best = i;
  return best;
}
