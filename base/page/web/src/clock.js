/* The instant and the stretch of a horizontal axis that several drawings share. All figures over time share one, each other figure has its own. */

export class Clock {
  constructor() {
    /** Where the reader is on the axis, NaN at first. */
    this.at = NaN;
    /** [from, to] that is shown, or null: all. */
    this.zoom = null;
    /** Instants that arrow keys step through, ascending. */
    this.steps = [];
    this.moved = new Set();
    this.zoomed = new Set();
  }

  /** Takes instants to step through where these are more than those that are known. */
  offer(steps) {
    if (steps && steps.length > this.steps.length) this.steps = steps;
  }

  move(at) {
    if (at === this.at || !Number.isFinite(at)) return;
    this.at = at;
    for (const f of this.moved) f(at);
  }

  /** Moves by a number of steps. */
  step(by) {
    if (this.steps.length === 0) return;
    const i = Number.isFinite(this.at) ? nearest(this.steps, this.at) : by > 0 ? -1 : 0;
    this.move(this.steps[Math.min(this.steps.length - 1, Math.max(0, i + by))]);
  }

  setZoom(range) {
    this.zoom = range && range[1] > range[0] ? range : null;
    for (const f of this.zoomed) f(this.zoom);
  }
}

/** Index of the value of an ascending array that is nearest; -1 of an empty one. */
export function nearest(values, at) {
  let low = 0;
  let high = values.length - 1;
  if (high < 0) return -1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= at) low = middle;
    else high = middle;
  }
  return Math.abs(values[high] - at) < Math.abs(values[low] - at) ? high : low;
}

/** What the arrow keys do on a drawing or, where nothing else takes them, on the page. True if the key meant something. */
export function clockKey(clock, event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return false;
  const stride = event.shiftKey ? 10 : 1;
  if (event.key === "ArrowLeft") clock.step(-stride);
  else if (event.key === "ArrowRight") clock.step(stride);
  else if (event.key === "Home") clock.step(-Infinity);
  else if (event.key === "End") clock.step(Infinity);
  else if (event.key === "PageUp") clock.step(-20);
  else if (event.key === "PageDown") clock.step(20);
  else if ((event.key === "+" || event.key === "-") && clock.steps.length > 1) zoomAbout(clock, event.key === "+" ? 0.5 : 2);
  else if (event.key === "0" || event.key === "Escape") clock.setZoom(null);
  else return false;
  event.preventDefault();
  return true;
}

function zoomAbout(clock, factor) {
  const [first, last] = [clock.steps[0], clock.steps[clock.steps.length - 1]];
  const [from, to] = clock.zoom ?? [first, last];
  const at = Number.isFinite(clock.at) ? clock.at : (from + to) / 2;
  const half = ((to - from) * factor) / 2;
  if (2 * half >= last - first) clock.setZoom(null);
  else {
    const low = Math.min(Math.max(at - half, first), last - 2 * half);
    clock.setZoom([low, low + 2 * half]);
  }
}
