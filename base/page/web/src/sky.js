/* The figure "sky": the path over a station. North is up and east left, as one looks up. */
import { nearest } from "./clock.js";
import { el, oncePerFrame, svg } from "./dom.js";
import { number, utcClock, utcDate } from "./format.js";

const R = 150;
const MARGIN = 30;
const SIZE = 2 * (R + MARGIN);

/** Place in the drawing of a direction; the zenith is the middle, the horizon the rim. */
function place(azimuthDeg, elevationDeg) {
  const r = (R * (90 - elevationDeg)) / 90;
  const a = (azimuthDeg * Math.PI) / 180;
  return [SIZE / 2 - r * Math.sin(a), SIZE / 2 - r * Math.cos(a)];
}

function frame() {
  const parts = [];
  for (const elevation of [0, 30, 60]) {
    parts.push(svg("circle", { cx: SIZE / 2, cy: SIZE / 2, r: (R * (90 - elevation)) / 90, class: elevation === 0 ? "sky-rim" : "sky-grid" }));
    if (elevation > 0) parts.push(svg("text", { x: SIZE / 2 + 3, y: SIZE / 2 - (R * (90 - elevation)) / 90 + 11, class: "sky-small" }, `${elevation}°`));
  }
  for (let azimuth = 0; azimuth < 180; azimuth += 45) {
    const [x1, y1] = place(azimuth, 0);
    const [x2, y2] = place(azimuth + 180, 0);
    parts.push(svg("line", { x1, y1, x2, y2, class: "sky-grid" }));
  }
  ["N", "NE", "E", "SE", "S", "SW", "W", "NW"].forEach((name, i) => {
    const [x, y] = place(i * 45, -9);
    parts.push(svg("text", { x, y: y + 4, class: name.length === 1 ? "sky-name" : "sky-small", "text-anchor": "middle" }, name));
  });
  return parts;
}

/** The path in pieces of equal light: in sunlight, in penumbra, in umbra. */
function pieces(azimuth, elevation, sunlit) {
  const kind = (i) => (!sunlit || !Number.isFinite(sunlit[i]) || sunlit[i] > 0.999 ? "lit" : sunlit[i] > 0.001 ? "half" : "dark");
  const out = [];
  let points = [];
  let last = null;
  for (let i = 0; i < azimuth.length; i += 1) {
    const up = Number.isFinite(azimuth[i]) && elevation[i] >= -1;
    if (up) points.push(place(azimuth[i], elevation[i]));
    const now = up ? kind(i) : null;
    if (points.length > 1 && (now !== last || i === azimuth.length - 1) && last !== null) {
      out.push(svg("polyline", { points: points.map((p) => p.map((v) => v.toFixed(1)).join(",")).join(" "), class: `sky-path ${last}` }));
      points = up ? [points.at(-1)] : [];
    } else if (!up) points = [];
    last = now;
  }
  return out;
}

/** Direction from the path at a sample to where a name does not lie on it: across, away from where the path bends to. */
function aside(azimuth, elevation, i) {
  const step = Math.max(3, Math.floor(azimuth.length / 12));
  const at = (k) => place(azimuth[k], elevation[k]);
  const [before, here, after] = [Math.max(0, i - step), i, Math.min(azimuth.length - 1, i + step)].map(at);
  const along = [after[0] - before[0], after[1] - before[1]];
  const size = Math.hypot(...along) || 1;
  const across = [-along[1] / size, along[0] / size];
  const bend = (before[0] + after[0] - 2 * here[0]) * across[0] + (before[1] + after[1] - 2 * here[1]) * across[1];
  // A straight path: outward.
  const outward = (here[0] - SIZE / 2) * across[0] + (here[1] - SIZE / 2) * across[1];
  const sign = Math.abs(bend) > 1 ? -Math.sign(bend) : Math.sign(outward) || 1;
  return across.map((v) => sign * v);
}

export function drawSky(figure, { array, host, clock }) {
  const [time, azimuth, elevation] = [array(figure.time) ?? [], array(figure.azimuth_deg) ?? [], array(figure.elevation_deg) ?? []];
  const sunlit = array(figure.sunlit);
  clock.offer(time);
  const dot = svg("circle", { r: 5.5, class: "sky-now", visibility: "hidden" });
  const marks = (figure.marks ?? []).map((m) => {
    const i = nearest(time, m.time);
    if (i < 0 || !Number.isFinite(azimuth[i])) return null;
    const [x, y] = place(azimuth[i], elevation[i]);
    let [ux, uy] = aside(azimuth, elevation, i);
    // A name inside the sky does not run over its rim, where those of the compass stand.
    const end = x + Math.sign(ux) * (8 + 6.2 * String(m.name).length);
    if (elevation[i] > 8 && Math.abs(ux) >= 0.35 && Math.hypot(end - SIZE / 2, y - SIZE / 2) > R) [ux, uy] = [-ux, -uy];
    const anchor = Math.abs(ux) < 0.35 ? "middle" : ux < 0 ? "end" : "start";
    return [
      svg("circle", { cx: x, cy: y, r: 2.8, class: "sky-mark" }),
      svg("text", { x: x + 8 * ux, y: y + 3.5 + 10 * uy, "text-anchor": anchor, class: "sky-label" }, m.name),
    ];
  });
  const drawing = svg(
    "svg",
    {
      viewBox: `0 0 ${SIZE} ${SIZE}`,
      class: "sky",
      role: "img",
      "aria-label": `${figure.title}: path over the station, ${time.length} instants. ${(figure.marks ?? []).map((m) => `${m.name} ${utcClock(m.time)}`).join(", ")}`,
    },
    frame(),
    pieces(azimuth, elevation, sunlit),
    marks,
    dot,
  );
  const readout = el("p", { class: "readout" }, "North is up, east is left, as one looks up. Point at the path to read it.");
  const key = el(
    "p",
    { class: "sky-key" },
    [["lit", "in sunlight"], ["half", "in penumbra"], ["dark", "in umbra"]].map(([kind, name]) =>
      el("span", {}, svg("svg", { width: 26, height: 8, "aria-hidden": "true" }, svg("line", { x1: 1, y1: 4, x2: 25, y2: 4, class: `sky-path ${kind}` })), ` ${name}`),
    ),
  );
  host.append(readout, el("div", { class: "sky-frame" }, drawing), sunlit ? key : "");

  drawing.addEventListener(
    "pointermove",
    oncePerFrame((e) => {
      const box = drawing.getBoundingClientRect();
      const [x, y] = [((e.clientX - box.left) / box.width) * SIZE, ((e.clientY - box.top) / box.height) * SIZE];
      let best = -1;
      let least = 20 ** 2;
      for (let i = 0; i < time.length; i += 1) {
        const [px, py] = place(azimuth[i], elevation[i]);
        const d = (px - x) ** 2 + (py - y) ** 2;
        if (d < least) [best, least] = [i, d];
      }
      if (best >= 0) clock.move(time[best]);
    }),
  );
  const show = (at) => {
    const i = nearest(time, at);
    if (i < 0 || at < time[0] - 1 || at > time[time.length - 1] + 1 || !Number.isFinite(azimuth[i])) {
      dot.setAttribute("visibility", "hidden");
      return;
    }
    const [x, y] = place(azimuth[i], elevation[i]);
    dot.setAttribute("cx", x);
    dot.setAttribute("cy", y);
    dot.setAttribute("visibility", elevation[i] >= -1 ? "visible" : "hidden");
    const light = sunlit && Number.isFinite(sunlit[i]) ? ` · ${number(100 * sunlit[i], 3)} % of the Sun's disc` : "";
    readout.textContent = `${utcDate(time[i])} ${utcClock(time[i])} UTC · azimuth ${number(azimuth[i])}° · elevation ${number(elevation[i])}°${light}`;
    readout.classList.add("live");
  };
  clock.moved.add(show);
  show(clock.at);

  const columns = () => {
    const out = [
      { name: "time", unit: "UTC", time: true, values: time },
      { name: "azimuth", unit: "deg", values: azimuth },
      { name: "elevation", unit: "deg", values: elevation },
    ];
    if (sunlit) out.push({ name: "sunlit", unit: "1", values: sunlit });
    return out;
  };
  return { clock, columns, series: () => [{ name: "path", x: Array.from(azimuth), y: Array.from(elevation), time: Array.from(time) }] };
}
