/* One plot: axes, lines and whatever is painted on it, on top of uPlot. It knows a clock, not other plots. */
import "./sharp.js";
import uPlot from "uplot";
import { clockKey } from "./clock.js";
import { el, oncePerFrame } from "./dom.js";
import { onTheme, colours, isPrinting } from "./theme.js";
import { powerOfTen } from "./format.js";
import { commonPower, tickLabels, ticks } from "./ticks.js";

const LEFT = 62;
/** Room for names in place of numbers. */
const NAMES = 130;
const FONT = "12px system-ui, -apple-system, 'Segoe UI', Roboto, sans-serif";
/** Width of a plot on paper, in pixels of CSS. */
const PAPER = 660;

/**
 * A plot in `host`.
 * @param {object} o
 * @param {HTMLElement} o.host
 * @param {import("./clock.js").Clock} o.clock what hovering moves, what zooming sets
 * @param {[number, number]} o.full the whole horizontal stretch
 * @param {string} o.xType linear, log or time @param {string} o.yType linear, log or magnitude
 * @param {number} o.height pixels of the plot with its horizontal axis
 * @param {boolean} o.last has labels of the horizontal axis
 * @param {{colour: () => string, width: number, dash: number[], step: boolean}[]} o.lines drawn by uPlot
 * @param {() => Array} o.data of uPlot: horizontal values, then one array a line, null at gaps
 * @param {(from: number, to: number) => [number, number]} o.yRange
 * @param {(u: uPlot) => void} [o.below] painted first @param {(u: uPlot) => void} [o.above] painted last
 * @param {(at: number) => {y: number, colour: string}[]} [o.dots] marks at the clock's place
 * @param {(at: number) => string} [o.spoken] what a screen reader says of a place
 * @param {(at: number) => number} [o.snap] from the pointer's place to the one that is meant
 * @param {{places: ArrayLike<number>, texts: string[]}} [o.names] stand on the vertical axis in place of numbers
 * @param {string} o.label
 */
export function createPlot(o) {
  const { host, clock } = o;
  let [from, to] = o.full;
  const y0 = o.yRange(from, to);
  let power = 0;
  const marker = el("div", { class: "marker", hidden: true });
  const dots = [];
  const axisStyle = {
    stroke: () => colours().soft,
    font: FONT,
    grid: { stroke: () => colours().grid, width: 1 },
    ticks: { stroke: () => colours().axis, width: 1, size: 4 },
    border: { show: true, stroke: () => colours().axis, width: 1 },
    gap: 5,
  };
  const u = new uPlot(
    {
      width: widthOf(host),
      height: o.height,
      padding: [16, 20, o.last ? 0 : 6, 0],
      legend: { show: false },
      scales: {
        x: { time: false, auto: false, min: from, max: to, distr: o.xType === "log" ? 3 : 1 },
        y: { auto: false, min: y0[0], max: y0[1], dir: o.yType === "magnitude" ? -1 : 1, distr: o.yType === "log" ? 3 : 1 },
      },
      axes: [
        {
          ...axisStyle,
          size: o.last ? 28 : 6,
          filter: every,
          splits: (v, i, min, max) => ticks(min, max, Math.max(2, v.bbox.width / devicePixelRatio / (o.xType === "time" ? 85 : 75)), o.xType),
          values: (v, marks) => (o.last ? tickLabels(marks, o.xType) : marks.map(() => "")),
        },
        {
          ...axisStyle,
          size: o.names ? NAMES : LEFT,
          filter: every,
          splits: (v, i, min, max) => o.names?.places ?? ticks(min, max, Math.max(2, v.bbox.height / devicePixelRatio / 34), o.yType),
          values: (v, marks) => {
            power = o.names ? 0 : commonPower(marks, o.yType);
            return o.names?.texts ?? tickLabels(marks, o.yType);
          },
        },
      ],
      series: [
        {},
        ...o.lines.map((l) => ({
          stroke: () => l.colour(),
          width: l.width,
          dash: l.dash,
          points: { show: false },
          paths: l.step ? uPlot.paths.stepped({ align: 1 }) : undefined,
        })),
      ],
      cursor: {
        x: false,
        y: false,
        points: { show: false },
        drag: { x: true, y: false, setScale: false, dist: 6 },
        bind: { dblclick: () => () => clock.setZoom(null) },
      },
      hooks: {
        drawClear: [(v) => o.below?.(v)],
        draw: [(v) => o.above?.(v), paintPower],
        setCursor: [(v) => hover(v)],
        setSelect: [(v) => select(v)],
      },
    },
    o.data(),
    host,
  );
  u.over.append(marker);

  // A finger that moves across reads values; one that moves up or down scrolls.
  u.over.addEventListener("pointermove", (e) => {
    if (e.pointerType !== "touch") return;
    const at = u.posToVal(e.clientX - u.over.getBoundingClientRect().left, "x");
    clock.move(o.snap ? o.snap(at) : at);
  });

  /** The power of ten of the vertical axis, above it. */
  function paintPower(v) {
    if (power === 0) return;
    v.ctx.save();
    v.ctx.font = `${12 * devicePixelRatio}px system-ui, sans-serif`;
    v.ctx.textAlign = "right";
    v.ctx.textBaseline = "bottom";
    v.ctx.fillStyle = colours().soft;
    v.ctx.fillText(`×${powerOfTen(power)}`, v.bbox.left - 4 * devicePixelRatio, v.bbox.top - 1 * devicePixelRatio);
    v.ctx.restore();
  }

  function hover(v) {
    if (!(v.cursor.left >= 0)) return;
    const at = v.posToVal(v.cursor.left, "x");
    clock.move(o.snap ? o.snap(at) : at);
  }

  function select(v) {
    if (v.select.width < 2) return;
    const range = [v.posToVal(v.select.left, "x"), v.posToVal(v.select.left + v.select.width, "x")];
    v.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    clock.setZoom(range);
  }

  /** Takes horizontal and vertical range anew, and paints. */
  function rescale() {
    const zoom = clock.zoom;
    const [first, last] = o.full;
    const within = zoom && zoom[0] < last && zoom[1] > first;
    [from, to] = within ? [Math.max(zoom[0], first), Math.min(zoom[1], last)] : o.full;
    const [min, max] = o.yRange(from, to);
    u.batch(() => {
      u.setScale("x", { min: from, max: to });
      u.setScale("y", { min, max });
    });
    mark();
  }

  function mark() {
    const at = clock.at;
    const inside = at >= from && at <= to;
    marker.hidden = !inside;
    const places = inside && o.dots ? o.dots(at) : [];
    const left = u.valToPos(at, "x");
    if (inside) marker.style.transform = `translateX(${left}px)`;
    places.forEach((p, i) => {
      if (!dots[i]) {
        dots[i] = el("div", { class: "dot" });
        u.over.append(dots[i]);
      }
      dots[i].style.transform = `translate(${u.valToPos(p.x ?? at, "x")}px, ${u.valToPos(p.y, "y")}px)`;
      dots[i].style.background = p.colour;
    });
    dots.forEach((d, i) => {
      const p = places[i];
      d.hidden = !p || !(p.y >= u.scales.y.min && p.y <= u.scales.y.max);
    });
    if (o.spoken) {
      host.setAttribute("aria-valuetext", Number.isFinite(at) ? o.spoken(at) : "no place chosen");
      if (Number.isFinite(at)) host.setAttribute("aria-valuenow", String(at));
    }
  }

  host.tabIndex = 0;
  host.setAttribute("role", "slider");
  host.setAttribute("aria-label", o.label);
  host.setAttribute("aria-valuemin", String(o.full[0]));
  host.setAttribute("aria-valuemax", String(o.full[1]));
  host.setAttribute("aria-valuenow", String(o.full[0]));
  host.addEventListener("keydown", (e) => clockKey(clock, e));

  const fit = () => {
    const width = isPrinting() ? PAPER : widthOf(host);
    if (width > 0 && width !== u.width) u.setSize({ width, height: o.height });
    mark();
  };
  new ResizeObserver(oncePerFrame(fit)).observe(host);
  onTheme(() => {
    fit();
    u.redraw(true, true);
  });
  clock.moved.add(mark);
  clock.zoomed.add(rescale);
  mark();

  return {
    uplot: u,
    rescale,
    /** Takes the data anew, and the vertical range. */
    refresh() {
      u.setData(o.data(), false);
      rescale();
      u.redraw(true, false);
    },
  };
}

/** uPlot leaves marks of a logarithmic axis out; ours are chosen already. */
const every = (u, marks) => marks;

function widthOf(host) {
  return Math.max(0, Math.floor(host.clientWidth));
}

/** The vertical range for values from `min` to `max`, with room about them; from 0 where it must be, or `may` be and is near. */
export function roomAbout(min, max, type, zero, may = true) {
  if (!(min <= max)) return type === "log" ? [0.1, 10] : [0, 1];
  if (type === "log") {
    const low = Math.max(min, max * 1e-7);
    const room = Math.max(1.15, (max / low) ** 0.04);
    return [low / room, max * room];
  }
  let [low, high] = [min, max];
  if (low === 0 && high === 0) return [0, 1];
  if (zero || (may && type !== "magnitude" && low >= 0 && low < 0.45 * high)) [low, high] = [Math.min(0, low), Math.max(0, high)];
  const span = high - low || Math.abs(high) * 0.1 || 1;
  return [low === 0 ? 0 : low - 0.06 * span, high === 0 ? 0 : high + 0.08 * span];
}
