/* Numbers, units and instants as people read them. */

const SUPERSCRIPT = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
const MINUS = "−";

/** 10 to a whole power, written out: 10⁻³. */
export function powerOfTen(exponent) {
  return "10" + [...String(exponent)].map((c) => SUPERSCRIPT[c]).join("");
}

/**
 * A number with sensible digits: 0.01234, 273.2, 1.5×10⁻⁶; a dash where there is none.
 * @param {number} value @param {number} [digits] significant ones
 */
export function number(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : `${MINUS}∞`;
  if (Number.isInteger(value) && Math.abs(value) < 1e7) return String(value).replace(/^-/, MINUS);
  const size = Math.floor(Math.log10(Math.abs(value)));
  if (size < -3 || size > 6) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    return `${Number(mantissa)}×${powerOfTen(Number(exponent))}`.replace(/^-/, MINUS);
  }
  return value.toFixed(Math.max(0, digits - 1 - size)).replace(/^-/, MINUS);
}

/** A number that somebody chose, as short as its digits allow: 0.8, not 0.8000. */
export function plain(value, digits = 4) {
  const short = Number(value.toPrecision(digits));
  const size = Math.abs(short);
  return Number.isFinite(short) && (size === 0 || (size >= 1e-4 && size < 1e7)) ? String(short).replace(/^-/, MINUS) : number(value, digits);
}

/** A unit as it is read: m^2 and m2 become m². "1" and "" are none. */
export function unitText(unit) {
  return !unit || unit === "1" ? "" : String(unit).replace(/\^(-?\d+)|(?<=\bm)([23])\b/g, (all, first, second) => [...(first ?? second)].map((c) => SUPERSCRIPT[c]).join(""));
}

/** A number with a unit behind it. */
export function quantity(value, unit, digits = 4) {
  const text = number(value, digits);
  return unitText(unit) && text !== "–" ? `${text} ${unitText(unit)}` : text;
}

/** "name, unit" as a heading of an axis. */
export function nameAndUnit(name, unit) {
  return unitText(unit) ? `${name}, ${unitText(unit)}` : String(name ?? "");
}

/** All digits that tell a double, or a single, from its neighbours: for files. */
export function exact(value, single = false) {
  if (value === null || value === undefined || Number.isNaN(value)) return "";
  if (!single) return String(value);
  for (let digits = 6; digits < 9; digits += 1) {
    const text = Number(value.toPrecision(digits));
    if (Math.fround(text) === value) return String(text);
  }
  return String(Number(value.toPrecision(9)));
}

const two = (n) => String(n).padStart(2, "0");

/** YYYY-MM-DD of seconds since 1970. */
export function utcDate(seconds) {
  const d = new Date(seconds * 1000);
  if (Number.isNaN(d.getTime())) return "–";
  return `${d.getUTCFullYear()}-${two(d.getUTCMonth() + 1)}-${two(d.getUTCDate())}`;
}

/** HH:MM:SS, with `digits` of the second. */
export function utcClock(seconds, digits = 0) {
  const scale = 10 ** digits;
  const rounded = Math.round(seconds * scale) / scale;
  const d = new Date(Math.round(rounded * 1000));
  if (Number.isNaN(d.getTime())) return "–";
  const fraction = digits > 0 ? (Math.round(rounded * 1000) % 1000 / 1000).toFixed(digits).slice(1) : "";
  return `${two(d.getUTCHours())}:${two(d.getUTCMinutes())}:${two(d.getUTCSeconds())}${fraction}`;
}

/** ISO 8601 in UTC to the millisecond, for files. */
export function utcIso(seconds) {
  const d = new Date(Math.round(seconds * 1000));
  return Number.isNaN(d.getTime()) ? "" : d.toISOString();
}

/** A value of a horizontal axis, as it is read out. */
export function position(value, axis) {
  if (axis.scale === "time") return `${utcDate(value)} ${utcClock(value, value % 1 === 0 ? 0 : 1)} UTC`;
  return `${axis.name} ${quantity(value, axis.unit, 5)}`;
}
