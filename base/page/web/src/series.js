/* One curve of a panel: its numbers in ascending order of the horizontal axis, and what is read out of them. */
import { nearest } from "./clock.js";

function ascending(x) {
  for (let i = 1; i < x.length; i += 1) if (!(x[i] >= x[i - 1])) return false;
  return true;
}

function permuted(values, order) {
  if (!values) return null;
  const out = new values.constructor(order.length);
  order.forEach((from, to) => {
    out[to] = values[from];
  });
  return out;
}

/**
 * A curve from its description (../../format.md).
 * @param {object} s @param {(i: number) => ArrayLike<number>} array @param {ArrayLike<number>} x of the figure
 * @returns {{name, unit, set, column, role, mark, x, y, error, low, high, own, visible, stored}} ascending in x; `own`: has horizontal values of its own;
 *   `stored`: the arrays as the document has them
 */
export function readSeries(s, array, x, unit) {
  const stored = { x: array(s.x) ?? x, y: array(s.data) ?? [], error: array(s.error), low: array(s.low), high: array(s.high) };
  let { y, error, low, high } = stored;
  let xs = stored.x ?? [];
  const count = Math.min(xs.length, y.length);
  if (y.length > count) y = y.slice(0, count);
  let mark = s.mark ?? (s.role === "measured" ? "points" : "line");
  let own = Boolean(array(s.x)) || xs.length > count;
  if (xs.length > count) xs = xs.slice(0, count);
  if (!ascending(xs)) {
    // What does not run forward is no curve over this axis.
    const order = [...Array(count).keys()].filter((i) => !Number.isNaN(xs[i])).sort((a, b) => xs[a] - xs[b]);
    [xs, y, error, low, high] = [xs, y, error, low, high].map((v) => permuted(v, order));
    if (mark === "line") mark = "points";
    own = true;
  }
  return { name: s.name, unit, set: s.set, column: s.column, role: s.role, mark, x: xs, y, error, low, high, own, visible: !s.hidden, stored };
}

/** Lower and upper end at a sample: of the band, of one sigma, or of the value itself. */
export function ends(s, i) {
  if (s.low && s.high) return [s.low[i], s.high[i]];
  if (s.error && Number.isFinite(s.error[i])) return [s.y[i] - s.error[i], s.y[i] + s.error[i]];
  return [s.y[i], s.y[i]];
}

/** The sample nearest to a place of the axis, or null: {i, x, y, error}. Far is what lies beyond `reach`. */
export function sampleAt(s, at, reach = Infinity) {
  const i = nearest(s.x, at);
  if (i < 0 || !Number.isFinite(at) || Math.abs(s.x[i] - at) > reach) return null;
  return { i, x: s.x[i], y: s.y[i], error: s.error ? s.error[i] : undefined };
}

/** Lowest and highest that visible curves reach between `from` and `to`, errors included: [min, max], NaN where nothing is. */
export function reachOf(series, from, to, log) {
  let min = Infinity;
  let max = -Infinity;
  for (const s of series) {
    if (!s.visible) continue;
    for (let i = 0; i < s.x.length; i += 1) {
      if (s.x[i] < from || s.x[i] > to) continue;
      const value = s.top ? s.top[i] : s.y[i];
      const [low, high] = s.top ? [value, value] : ends(s, i);
      for (const v of [value, low, high]) {
        if (!Number.isFinite(v) || (log && v <= 0)) continue;
        if (v < min) min = v;
        if (v > max) max = v;
      }
    }
  }
  return min <= max ? [min, max] : [NaN, NaN];
}
