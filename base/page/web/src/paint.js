/* What is painted on a plot beside the lines that uPlot draws: shaded stretches, bands, error bars, points, areas. */
import { colours } from "./theme.js";
import { ends } from "./series.js";

const dpr = () => devicePixelRatio;

/** Colour of a shaded stretch by its name. */
export function shadeColour(name, names) {
  const known = colours().shade[name];
  if (known) return known;
  const others = names.filter((n) => !colours().shade[n]);
  return colours().shades[others.indexOf(name) % colours().shades.length];
}

/** Left and right end of a stretch on the canvas, or null where none of it is seen. */
function seen(u, s) {
  const { bbox } = u;
  const left = Math.max(bbox.left, u.valToPos(s.from, "x", true));
  const right = Math.min(bbox.left + bbox.width, u.valToPos(s.to, "x", true));
  return right > left ? [left, right] : null;
}

/** Stretches, behind everything. */
export function paintShades(u, shades) {
  const { ctx, bbox } = u;
  const names = [...new Set(shades.map((s) => s.name))];
  ctx.save();
  for (const s of shades) {
    const place = seen(u, s);
    if (!place) continue;
    ctx.fillStyle = shadeColour(s.name, names);
    ctx.fillRect(place[0], bbox.top, place[1] - place[0], bbox.height);
  }
  ctx.restore();
}

/** Names of stretches at the top of the plot, where there is room. */
export function paintShadeNames(u, shades) {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.font = `${11 * dpr()}px system-ui, sans-serif`;
  ctx.textBaseline = "top";
  ctx.textAlign = "center";
  ctx.fillStyle = colours().soft;
  for (const s of shades) {
    const place = seen(u, s);
    if (place && ctx.measureText(s.name).width + 8 * dpr() < place[1] - place[0]) ctx.fillText(s.name, (place[0] + place[1]) / 2, bbox.top + 6 * dpr());
  }
  ctx.restore();
}

/** Runs `f(place, i)` for stretches without a gap: `begin`, then each sample, then `end`. */
function eachStretch(s, ok, begin, each, end) {
  let open = false;
  for (let i = 0; i < s.x.length; i += 1) {
    if (ok(i)) {
      if (!open) begin(i);
      open = true;
      each(i);
    } else if (open) {
      open = false;
      end(i - 1);
    }
  }
  if (open) end(s.x.length - 1);
}

/** The area between two values of each sample. */
export function paintBetween(u, s, lowOf, highOf, style, alpha) {
  const { ctx } = u;
  const X = (i) => u.valToPos(s.x[i], "x", true);
  const log = u.scales.y.distr === 3;
  const floor = u.scales.y.min;
  const Y = (v) => u.valToPos(log ? Math.max(v, floor) : v, "y", true);
  let start = 0;
  ctx.save();
  clip(u);
  ctx.fillStyle = style;
  ctx.globalAlpha = alpha;
  eachStretch(
    s,
    (i) => Number.isFinite(lowOf(i)) && Number.isFinite(highOf(i)) && !(log && highOf(i) <= 0),
    (i) => {
      start = i;
      ctx.beginPath();
    },
    (i) => ctx.lineTo(X(i), Y(highOf(i))),
    (last) => {
      for (let i = last; i >= start; i -= 1) ctx.lineTo(X(i), Y(lowOf(i)));
      ctx.closePath();
      ctx.fill();
    },
  );
  ctx.restore();
}

function clip(u, room = 0) {
  const { ctx, bbox } = u;
  ctx.beginPath();
  ctx.rect(bbox.left - room, bbox.top, bbox.width + 2 * room, bbox.height);
  ctx.clip();
}

/** The band of a curve: from low to high, or one sigma about it. */
export function paintBand(u, s, style) {
  paintBetween(u, s, (i) => ends(s, i)[0], (i) => ends(s, i)[1], style, 0.22);
}

/** Points with error bars. */
export function paintPoints(u, s, style, dense) {
  const { ctx, bbox } = u;
  const log = u.scales.y.distr === 3;
  const radius = (dense ? 1.7 : 2.6) * dpr();
  const cap = 2.5 * dpr();
  ctx.save();
  // A point at the end of the axis is seen whole.
  clip(u, 4 * dpr());
  ctx.strokeStyle = style;
  ctx.fillStyle = style;
  ctx.lineWidth = 1 * dpr();
  for (let i = 0; i < s.x.length; i += 1) {
    const v = s.y[i];
    if (!Number.isFinite(v) || (log && v <= 0)) continue;
    const x = u.valToPos(s.x[i], "x", true);
    if (x < bbox.left - 1 || x > bbox.left + bbox.width + 1) continue;
    const [low, high] = ends(s, i);
    if (high > low) {
      const bottom = log && low <= 0 ? bbox.top + bbox.height : u.valToPos(low, "y", true);
      const top = u.valToPos(high, "y", true);
      ctx.globalAlpha = 0.55;
      ctx.beginPath();
      ctx.moveTo(x, bottom);
      ctx.lineTo(x, top);
      if (!dense)
        for (const y of [bottom, top]) {
          ctx.moveTo(x - cap, y);
          ctx.lineTo(x + cap, y);
        }
      ctx.stroke();
    }
    ctx.globalAlpha = 1;
    ctx.beginPath();
    ctx.arc(x, u.valToPos(v, "y", true), radius, 0, 2 * Math.PI);
    ctx.fill();
  }
  ctx.restore();
}

/** A line, or steps, over horizontal values of its own. */
export function paintLine(u, s, style, width, dash) {
  const { ctx } = u;
  const log = u.scales.y.distr === 3;
  const X = (i) => u.valToPos(s.x[i], "x", true);
  const Y = (i) => u.valToPos(s.y[i], "y", true);
  ctx.save();
  clip(u);
  ctx.strokeStyle = style;
  ctx.lineWidth = width * dpr();
  ctx.lineJoin = "round";
  ctx.setLineDash(dash.map((d) => d * dpr()));
  eachStretch(
    s,
    (i) => Number.isFinite(s.y[i]) && !(log && s.y[i] <= 0),
    () => ctx.beginPath(),
    (i) => {
      if (s.mark === "step" && i > 0) ctx.lineTo(X(i), Number.isFinite(s.y[i - 1]) ? Y(i - 1) : Y(i));
      ctx.lineTo(X(i), Y(i));
    },
    () => ctx.stroke(),
  );
  ctx.restore();
}

/** A thin line across the plot at a value. */
export function paintLevel(u, value) {
  const { ctx, bbox } = u;
  const y = Math.round(u.valToPos(value, "y", true)) + 0.5;
  if (!(y >= bbox.top && y <= bbox.top + bbox.height)) return;
  ctx.save();
  ctx.strokeStyle = colours().soft;
  ctx.lineWidth = dpr();
  ctx.beginPath();
  ctx.moveTo(bbox.left, y);
  ctx.lineTo(bbox.left + bbox.width, y);
  ctx.stroke();
  ctx.restore();
}
