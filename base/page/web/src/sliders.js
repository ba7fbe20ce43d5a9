/* The figure "sliders": parameters that move several curves at once, exactly as far as the matrix of derivatives reaches. */
import { Clock } from "./clock.js";
import { button, el, oncePerFrame } from "./dom.js";
import { createPanels, panelColumns } from "./panels.js";
import { createServer } from "./serve.js";
import { createSliderRow } from "./slider_row.js";
import { isBeyond, moved, telling } from "./whatif.js";

const FIRST = 8;
const WAIT_MS = 350;
/** A panel shows so many curves at first. */
const MANY = 6;

/** A curve of the drawing that shares the axis. */
const line = (name, x, y, more) => ({ name, x, y, own: false, mark: "line", visible: true, stored: { x, y }, ...more });

/** Base, moved and computed curves of each panel. */
function arrange(curves, xs, served) {
  const panels = [];
  for (const c of curves) {
    const title = c.panel ?? c.name;
    let panel = panels.find((p) => p.name === title && p.unit === c.unit);
    if (!panel) panels.push((panel = { name: title, unit: c.unit, scale: c.scale ?? "linear", series: [] }));
    const y = Float64Array.from(c.base);
    const visible = !(c.hidden ?? panel.series.filter((s) => s.role !== "before").length >= MANY);
    c.before = line(`${c.name} as it is`, xs, c.base, { role: "before", visible, quiet: true });
    c.after = line(c.name, xs, y, { error: new Float64Array(y.length), visible, with: [c.before] });
    c.computed = line(`${c.name} computed`, xs, new Float64Array(y.length).fill(NaN), { mark: "points" });
    panel.series.push(c.before, c.after, ...(served ? [c.computed] : []));
  }
  return panels;
}

export function drawSliders(figure, { array, host, clock: shared, document: doc }) {
  const { x, parameters } = figure;
  const xs = array(x.data) ?? [];
  const clock = x.scale === "time" ? shared : new Clock();
  const curves = figure.curves.map((c) => ({
    name: c.name, unit: c.unit, panel: c.panel, scale: c.scale, error: c.error, hidden: c.hidden,
    base: array(c.base) ?? [],
    derivative: parameters.map((p, k) => array(c.derivative[k])),
  }));
  const values = parameters.map((p) => p.null);
  const ask = doc.serve?.token ? createServer(doc.serve.token) : null;
  const panels = arrange(curves, xs, Boolean(ask));

  const chart = el("div", { class: "whatif-chart" });
  const list = el("div", { class: "whatif-list" });
  const status = el("p", { class: "whatif-status", role: "status" });
  host.append(el("div", { class: "whatif" }, chart, el("div", { class: "whatif-controls" }, head(), list, status)));
  const drawing = createPanels({ host: chart, clock, title: figure.title, x, xs, shades: figure.shade ?? [], panels, dashed: "as it is" });

  const rows = parameters.map((p, k) => createSliderRow(p, (v) => set(k, v), Boolean(ask)));
  const ranked = parameters.map((p, k) => [k, telling(k, p, curves)]).sort((a, b) => b[1] - a[1]).map(([k]) => k);
  rows.forEach((r, k) => r.set(values[k]));

  const redraw = oncePerFrame(draw);

  function head() {
    const search = el("input", {
      type: "search", placeholder: `Search all ${parameters.length} parameters`, "aria-label": "Search parameters", on: { input: () => showRows(search.value) },
    });
    const all = button("Reset all", () => parameters.forEach((p, k) => set(k, p.null)), { class: "reset-all" });
    return el("div", { class: "whatif-head" }, parameters.length > FIRST ? search : null, all);
  }

  /** The most telling parameters, those that were changed, and those that are searched for. */
  function showRows(text) {
    const wanted = text.trim().toLowerCase();
    const matches = (k) => `${parameters[k].label ?? ""} ${parameters[k].name}`.toLowerCase().includes(wanted);
    const chosen = wanted ? ranked.filter(matches) : ranked.filter((k, i) => i < FIRST || values[k] !== parameters[k].null);
    list.replaceChildren(...chosen.slice(0, 40).map((k) => rows[k].node));
    if (chosen.length === 0) list.append(el("p", { class: "soft" }, "No parameter has this in its name."));
  }

  function set(k, value) {
    values[k] = value;
    rows[k].set(value);
    redraw();
    compute();
  }

  function draw() {
    for (const c of curves) {
      const now = moved(c, parameters, values);
      c.after.y.set(now.value);
      c.after.error.set(now.error);
    }
    drawing.refresh();
  }

  let timer = null;
  let turn = 0;
  function compute() {
    if (!ask) return;
    clearTimeout(timer);
    turn += 1;
    const mine = turn;
    const forget = () => curves.forEach((c) => c.computed.y.fill(NaN));
    forget();
    status.classList.remove("bad");
    if (!parameters.some((p, k) => isBeyond(p, values[k]))) {
      status.textContent = "";
      return;
    }
    status.textContent = "Computing beyond the line …";
    chart.setAttribute("aria-busy", "true");
    timer = setTimeout(async () => {
      try {
        const changed = Object.fromEntries(parameters.map((p, k) => [p.name, values[k]]).filter(([, v], k) => v !== parameters[k].null));
        const answer = await ask(changed);
        if (mine !== turn) return;
        for (const c of curves) {
          const found = answer.curves.find((a) => a.name === c.name);
          if (found) c.computed.y.set(Float64Array.from(found.data, (v) => v ?? NaN).subarray(0, c.computed.y.length));
        }
        status.textContent = "Computed: the points. The line is what the derivatives say.";
        drawing.refresh();
      } catch (error) {
        if (error.name === "AbortError" || mine !== turn) return;
        status.classList.add("bad");
        status.textContent = `Not computed: ${error.message}`;
      } finally {
        if (mine === turn) chart.removeAttribute("aria-busy");
      }
    }, WAIT_MS);
  }

  showRows("");
  return {
    clock,
    columns: () => {
      const columns = panelColumns(x, xs, panels).filter((c) => Array.from(c.values).some((v) => Number.isFinite(v)));
      const changed = parameters.map((p, k) => k).filter((k) => values[k] !== parameters[k].null);
      if (changed.length === 0) return columns;
      // What the curves stand for.
      return [...columns, { name: "parameter", values: changed.map((k) => String(parameters[k].name)) }, { name: "value", values: changed.map((k) => values[k]) }];
    },
    series: drawing.drawn,
    plots: drawing.plots,
    /** For tests: sets a parameter by its name. */
    set(name, value) {
      const k = parameters.findIndex((p) => p.name === name);
      if (k < 0) throw new Error(`no parameter '${name}'`);
      set(k, value);
      draw();
    },
  };
}
