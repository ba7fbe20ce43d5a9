/* What curves become when parameters change, by the matrix of derivatives. No drawing here. */

/** Value of a parameter at the left and right end of its slider, and whether equal ways are equal factors. */
export function rangeOf(p) {
  const reach = Number.isFinite(p.reach) && p.reach > 0 ? p.reach : 0;
  const width = Number.isFinite(p.width) && p.width > 0 ? p.width : 0;
  const far = Math.max(3 * reach, 3 * width) || Math.abs(p.null) || 1;
  const low = Math.max(Number.isFinite(p.minimum) ? p.minimum : -Infinity, p.null - far);
  const high = Math.min(Number.isFinite(p.maximum) ? p.maximum : Infinity, p.null + far);
  const log = Boolean(p.logarithmic) && p.null > 0 && high > 0;
  return { low: log ? Math.max(low, p.null / 100) : low, high, log };
}

/** The stretch within which the line holds: [from, to], within what the parameter may be. */
export function statedInterval(p) {
  const reach = Number.isFinite(p.reach) ? p.reach : Infinity;
  return [Math.max(p.minimum ?? -Infinity, p.null - reach), Math.min(p.maximum ?? Infinity, p.null + reach)];
}

/** True where a value is beyond what its line is good for. */
export function isBeyond(p, value) {
  return Number.isFinite(p.reach) && Math.abs(value - p.null) > p.reach * (1 + 1e-9);
}

/** Largest change of any curve by one width of a parameter, as a share of the curve's size: how telling it is. */
export function telling(index, p, curves) {
  const step = (Number.isFinite(p.width) && p.width > 0 ? p.width : p.reach > 0 ? p.reach : p.maximum - p.null) || 0;
  let most = 0;
  for (const c of curves) {
    const d = c.derivative[index];
    if (!d) continue;
    let size = 0;
    let change = 0;
    for (let i = 0; i < c.base.length; i += 1) {
      if (Math.abs(c.base[i]) > size) size = Math.abs(c.base[i]);
      if (Math.abs(d[i]) > change) change = Math.abs(d[i]);
    }
    if (size > 0) most = Math.max(most, (change * Math.abs(step)) / size);
  }
  return most;
}

/**
 * base + sum of (value - null) derivative, and its error: that of a derivative is a share of its largest value.
 * @param {{base: ArrayLike<number>, derivative: (ArrayLike<number>|null)[], error?: number[]}} curve
 * @param {{null: number}[]} parameters @param {number[]} values
 * @returns {{value: Float64Array, error: Float64Array}}
 */
export function moved(curve, parameters, values) {
  const value = Float64Array.from(curve.base);
  const error = new Float64Array(value.length);
  parameters.forEach((p, k) => {
    const by = values[k] - p.null;
    const d = curve.derivative[k];
    if (by === 0 || !d) return;
    const share = curve.error?.[k] ?? 0;
    let largest = 0;
    for (let i = 0; i < value.length; i += 1) {
      value[i] += by * d[i];
      if (Math.abs(d[i]) > largest) largest = Math.abs(d[i]);
    }
    if (share > 0) for (let i = 0; i < value.length; i += 1) error[i] += Math.abs(by) * largest * share;
  });
  return { value, error };
}
