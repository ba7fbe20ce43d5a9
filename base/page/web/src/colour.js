/* Colours of data: one per name of a series, maps of values, and colours of kinds. All can be told apart by the colour-blind. */
import { colours } from "./theme.js";

/* Viridis, and a diverging map from blue through near white to orange, at equal steps. */
const VIRIDIS = [
  [68, 1, 84], [72, 26, 108], [71, 47, 125], [65, 68, 135], [57, 86, 140], [49, 104, 142], [42, 120, 142], [35, 136, 142],
  [31, 152, 139], [34, 168, 132], [53, 183, 121], [84, 197, 104], [122, 209, 81], [165, 219, 54], [210, 226, 27], [253, 231, 37],
];
const DIVERGING = [
  [16, 70, 128], [42, 110, 170], [94, 155, 203], [155, 196, 224], [208, 226, 239], [246, 245, 243], [250, 222, 196], [245, 186, 134],
  [226, 143, 72], [190, 99, 28], [138, 65, 10],
];
const NOTHING = [150, 155, 160];

/**
 * Colour of a share of a map, as three numbers 0..255; grey where there is none.
 * @param {number} share 0 at the low end, 1 at the high
 */
export function mapColour(share, diverging = false) {
  if (!Number.isFinite(share)) return NOTHING;
  const table = diverging ? DIVERGING : VIRIDIS;
  const at = Math.min(1, Math.max(0, share)) * (table.length - 1);
  const i = Math.min(table.length - 2, Math.floor(at));
  const f = at - i;
  return table[i].map((v, k) => Math.round(v + f * (table[i + 1][k] - v)));
}

export function css([r, g, b]) {
  return `rgb(${r},${g},${b})`;
}

/** From values to shares of a map. Logarithmic where `log`; symmetric about 0 where `diverging`. */
export function shareOf(min, max, { log = false, diverging = false } = {}) {
  if (diverging) {
    const size = Math.max(Math.abs(min), Math.abs(max)) || 1;
    return (v) => (v + size) / (2 * size);
  }
  if (log && min > 0 && max > min) return (v) => (v > 0 ? Math.log(v / min) / Math.log(max / min) : v === 0 ? 0 : NaN);
  return max > min ? (v) => (v - min) / (max - min) : (v) => (Number.isFinite(v) ? 0.5 : NaN);
}

/** Lowest and highest of an array's numbers; of positive ones where `log`, over at most eight decades. */
export function extent(values, log = false) {
  let min = Infinity;
  let max = -Infinity;
  for (let i = 0; i < values.length; i += 1) {
    const v = values[i];
    if (!Number.isFinite(v) || (log && v <= 0)) continue;
    if (v < min) min = v;
    if (v > max) max = v;
  }
  if (log && max > 0) min = Math.max(min, max * 1e-8);
  return min <= max ? [min, max] : [NaN, NaN];
}

/* Materials and parts: muted colours of even weight; more of them than there are colours differ in lightness. */
const KINDS = [
  [0, 114, 178], [230, 159, 0], [0, 158, 115], [204, 121, 167], [86, 180, 233], [213, 94, 0], [178, 172, 90], [110, 100, 170], [150, 150, 150],
  [90, 140, 90], [160, 100, 80], [60, 160, 170],
];
export function kindColour(index) {
  const round = Math.floor(index / KINDS.length);
  const f = [1, 0.72, 1.25, 0.55][round % 4];
  return KINDS[index % KINDS.length].map((v) => Math.min(255, Math.round(v * f)));
}

const DASHES = [[], [7, 4], [2, 3], [9, 3, 2, 3]];
const given = new Map([["vis", 0], ["lwir", 1]]);

/**
 * Numbers of colours of the series of one panel: a name has the same colour in the whole page where it can.
 * @param {{name: string, set?: number, role?: string}[]} series
 * @returns {{colour: () => string, dash: number[]}[]}
 */
export function seriesColours(series) {
  const taken = new Map();
  return series.map((s) => {
    if (s.role === "measured") return { colour: () => colours().ink, dash: DASHES[0] };
    if (s.role === "after") return { colour: () => colours().series[0], dash: DASHES[0] };
    if (s.role === "before") return { colour: () => colours().before, dash: DASHES[1] };
    const key = String(s.name).toLowerCase() + (s.set ? `/${s.set}` : "");
    const count = colours().series.length;
    let number = given.get(key);
    // Blue and vermilion are those of the two bands, for others only where nothing else is left.
    if (number === undefined) number = [2, 3, 4, 5, 6, 7, 0, 1].find((n) => !taken.has(n)) ?? taken.size;
    for (let tries = 0; taken.has(number) && tries < 4 * count; tries += 1) number = (number + 1) % (4 * count);
    taken.set(number, key);
    if (!given.has(key)) given.set(key, number);
    return { colour: () => colours().series[number % count], dash: DASHES[Math.floor(number / count) % 4] };
  });
}
