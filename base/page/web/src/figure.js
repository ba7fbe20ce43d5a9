/* The frame of a figure: title, text, drawing, its table and its file. A kind that this viewer does not know, or that fails, shows its title and says so. */
import { drawAxes } from "./axes.js";
import { drawBars } from "./bars.js";
import { csvText, saveText } from "./csv.js";
import { button, el, freshId } from "./dom.js";
import { drawMap } from "./map.js";
import { drawRanges } from "./ranges.js";
import { drawScene } from "./scene.js";
import { drawSky } from "./sky.js";
import { drawSliders } from "./sliders.js";
import { drawTable, tableOf } from "./table.js";

const KINDS = { axes: drawAxes, bars: drawBars, map: drawMap, ranges: drawRanges, table: drawTable, sky: drawSky, sliders: drawSliders, scene: drawScene };

/** A name of a file from an identifier of a document. */
const fileName = (id) => `${String(id).replace(/[^A-Za-z0-9._-]+/g, "-").replace(/^[.-]+/, "") || "figure"}.csv`;

/**
 * Draws a figure. The frame has to stand in the page before `draw` is called: drawings take its width.
 * @param {object} figure of the document
 * @param {{document: object, array: function, clock: object}} page
 * @returns {{node: HTMLElement, draw: () => object}} `draw` gives what tests ask: {id, kind, series, columns, csv}
 */
export function createFigure(figure, page) {
  const heading = freshId("figure-title");
  const host = el("div", { class: "figure-body" });
  const tools = el("div", { class: "tools" });
  const node = el(
    "figure",
    { class: "figure", "aria-labelledby": heading, data: { id: figure.id, kind: figure.kind, ...(figure.file ? { file: figure.file } : {}) } },
    el("div", { class: "figure-head" }, el("h3", { id: heading }, figure.title ?? figure.id), tools),
    figure.text ? el("p", { class: "figure-text" }, figure.text) : null,
    host,
  );

  function draw() {
    let drawing = null;
    const kind = Object.hasOwn(KINDS, figure.kind) ? KINDS[figure.kind] : null;
    if (!kind) {
      host.append(el("p", { class: "unknown" }, `This viewer does not know figures of the kind "${figure.kind}".`));
    } else {
      try {
        drawing = kind(figure, { ...page, host, frame: node });
      } catch (error) {
        console.warn(`figure ${figure.id}: ${error.stack}`);
        host.replaceChildren(el("p", { class: "unknown" }, `This figure could not be drawn: ${error.message}.`));
      }
    }
    const csv = () => csvText(drawing.columns());
    if (drawing) addTools(drawing, csv);
    return {
      ...drawing,
      id: figure.id,
      kind: figure.kind,
      element: node,
      series: () => drawing?.series() ?? [],
      columns: () => drawing?.columns() ?? [],
      csv: () => (drawing ? csv() : ""),
    };
  }

  function addTools(drawing, csv) {
    const clock = drawing.clock;
    if (clock && figure.kind !== "scene" && figure.kind !== "sky") {
      const all = button("Whole range", () => clock.setZoom(null), { hidden: true });
      clock.zoomed.add((zoom) => (all.hidden = !zoom));
      tools.append(all);
    }
    if (!drawing.isTable) {
      const table = el("div", { class: "figure-table", hidden: true, id: freshId("table") });
      const toggle = button(
        "Table",
        () => {
          table.hidden = !table.hidden;
          toggle.setAttribute("aria-expanded", String(!table.hidden));
          if (!table.hidden) table.replaceChildren(tableOf(drawing.columns(), `${figure.title}: values`));
        },
        { "aria-expanded": "false", "aria-controls": table.id },
      );
      tools.append(toggle);
      node.append(table);
    }
    tools.append(button("Save CSV", () => saveText(fileName(figure.id), csv()), { "aria-label": `Save ${figure.title} as CSV` }));
  }

  return { node, draw };
}
