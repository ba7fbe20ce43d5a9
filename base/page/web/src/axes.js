/* The figure "axes": curves over one horizontal axis. */
import { Clock } from "./clock.js";
import { createPanels, panelColumns } from "./panels.js";
import { readSeries } from "./series.js";

export function drawAxes(figure, { array, host, clock: shared, document: doc }) {
  const { x } = figure;
  const clock = x.scale === "time" ? shared : new Clock();
  const xs = array(x.data);
  const panels = figure.panels.map((p) => ({ ...p, series: p.series.map((s) => readSeries(s, array, xs, p.unit)) }));
  const drawing = createPanels({ host, clock, title: figure.title, x, xs, shades: figure.shade ?? [], panels, sets: doc.sets });
  return {
    clock,
    columns: () => panelColumns(x, xs, panels, doc.sets),
    series: drawing.drawn,
    plots: drawing.plots,
  };
}
