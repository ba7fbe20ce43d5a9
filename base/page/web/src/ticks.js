/* Where the marks of an axis stand, and what is written beside them. */
import { powerOfTen, utcClock, utcDate } from "./format.js";

const DAY = 86400;
const TIME_STEPS = [
  0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800,
  21600, 43200, DAY, 2 * DAY, 5 * DAY, 10 * DAY, 20 * DAY, 50 * DAY, 100 * DAY, 200 * DAY, 365 * DAY, 1000 * DAY, 3650 * DAY,
];

function multiples(min, max, step) {
  const marks = [];
  const first = Math.ceil(min / step - 1e-9);
  for (let k = first; k * step <= max + step * 1e-9 && marks.length < 1000; k += 1) marks.push(k * step || 0); // never -0
  return marks;
}

/** The step 1, 2, 2.5 or 5 times a power of ten that gives at most `count` intervals. */
export function niceStep(span, count) {
  const rough = span / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(rough));
  for (const m of [1, 2, 2.5, 5]) if (m * power >= rough * (1 - 1e-9)) return m * power;
  return 10 * power;
}

/** Marks of an axis from `min` to `max`, at most about `count`; `type`: linear, log, magnitude or time. */
export function ticks(min, max, count, type) {
  if (!(max > min)) return [min];
  if (type === "time") {
    const step = TIME_STEPS.find((s) => (max - min) / s <= count) ?? TIME_STEPS.at(-1);
    return multiples(min, max, step);
  }
  if (type === "log" && min > 0) {
    const decades = Math.log10(max / min);
    if (decades >= 1) {
      const every = Math.max(1, Math.ceil(decades / count));
      const within = decades * 3 <= count ? [1, 2, 5] : [1];
      const marks = [];
      for (let e = Math.floor(Math.log10(min)); e <= Math.ceil(Math.log10(max)); e += 1)
        if (e % every === 0) for (const m of within) marks.push(m * 10 ** e);
      return marks.filter((v) => v >= min * (1 - 1e-9) && v <= max * (1 + 1e-9));
    }
  }
  return multiples(min, max, niceStep(max - min, count));
}

/** The power of ten that is written once, not at every mark: of linear axes of very large or small numbers; else 0. */
export function commonPower(marks, type) {
  if (type === "time" || type === "log") return 0;
  const largest = Math.max(0, ...marks.map(Math.abs));
  return largest >= 1e6 || (largest > 0 && largest < 1e-3) ? Math.floor(Math.log10(largest) + 1e-9) : 0;
}

/** What is written beside the marks, but for their common power. */
export function tickLabels(marks, type) {
  if (type === "time") {
    const step = marks.length > 1 ? marks[1] - marks[0] : 60;
    if (step >= DAY) return marks.map(utcDate);
    const digits = step >= 1 ? 0 : step >= 0.1 ? 1 : step >= 0.01 ? 2 : 3;
    return marks.map((m, i) => {
      const midnight = Math.abs(m % DAY) < 1e-6 && i > 0;
      if (midnight) return utcDate(m);
      const clock = utcClock(m, digits);
      return step >= 60 ? clock.slice(0, 5) : clock;
    });
  }
  if (type === "log" && marks.some((m) => m !== 0 && (m < 1e-3 || m >= 1e5)))
    return marks.map((m) => {
      const e = Math.floor(Math.log10(m) + 1e-9);
      const mantissa = Math.round(m / 10 ** e);
      return mantissa === 1 ? powerOfTen(e) : `${mantissa}×${powerOfTen(e)}`;
    });
  if (type === "log") return marks.map((m) => String(Number(m.toPrecision(3))));
  const power = 10 ** commonPower(marks, type);
  if (power !== 1) return tickLabels(marks.map((m) => m / power), type);
  const step = marks.length > 1 ? Math.abs(marks[1] - marks[0]) : Math.abs(marks[0] ?? 1) || 1;
  const decimals = Math.max(0, Math.min(12, -Math.floor(Math.log10(step) + 1e-9) + (step.toExponential(3).startsWith("2.5") ? 1 : 0)));
  return marks.map((m) => (Math.abs(m) < step * 1e-6 ? 0 : m).toFixed(decimals).replace(/^-/, "−"));
}
