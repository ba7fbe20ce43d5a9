/* Columns as a table, and the figure that is a table. Long tables show their first rows until all are asked for. */
import { button, el } from "./dom.js";
import { nameAndUnit, number, plain, utcClock, utcDate } from "./format.js";

const FIRST = 100;

function shown(value, column) {
  if (value === undefined || value === null) return "";
  if (typeof value !== "number") return String(value);
  if (column.time) return `${utcDate(value)} ${utcClock(value, 3).replace(/\.000$/, "")}`;
  return Number.isFinite(value) ? plain(value, 6) : number(value);
}

const isNumeric = (c) => !Array.isArray(c.values) || c.values.every((v) => typeof v !== "string");

/** A short text stays in one line. */
const cellOf = (text, column) => el("td", { class: isNumeric(column) ? "numeric" : text.length <= 32 ? "short" : undefined }, text);

function order(column, direction) {
  const values = column.values;
  const key = (i) => (typeof values[i] === "number" && !Number.isNaN(values[i]) ? values[i] : null);
  return (a, b) => {
    if (!isNumeric(column)) return direction * String(values[a] ?? "").localeCompare(String(values[b] ?? ""), "en", { numeric: true });
    const [u, v] = [key(a), key(b)];
    if (u === null || v === null) return (u === null) - (v === null);
    return direction * (u - v);
  };
}

/**
 * A table of columns (see csv.js).
 * @param {object[]} columns @param {string} caption read out, not seen
 * @param {boolean} sortable headings become buttons that sort
 */
export function tableOf(columns, caption, sortable = false) {
  const rows = Math.max(0, ...columns.map((c) => c.values.length));
  let sequence = [...Array(rows).keys()];
  let sorted = null;
  let all = rows <= FIRST;
  const body = el("tbody");
  const heads = columns.map((c) => {
    const text = c.time ? `${c.name}, UTC` : nameAndUnit(c.name, c.unit);
    const head = el("th", { scope: "col", class: isNumeric(c) ? "numeric" : undefined }, sortable ? null : text);
    if (sortable)
      head.append(
        button(text, () => {
          const direction = sorted?.column === c ? -sorted.direction : 1;
          sorted = { column: c, direction };
          sequence = [...Array(rows).keys()].sort(order(c, direction));
          for (const h of heads) h.removeAttribute("aria-sort");
          head.setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
          draw();
        }),
      );
    return head;
  });
  const more = button(`Show all ${rows} rows`, () => {
    all = true;
    draw();
  }, { class: "more" });
  const draw = () => {
    body.replaceChildren(
      ...(all ? sequence : sequence.slice(0, FIRST)).map((i) =>
        el("tr", {}, columns.map((c) => cellOf(shown(c.values[i], c), c))),
      ),
    );
    more.hidden = all;
  };
  draw();
  return el(
    "div",
    { class: "table-frame", tabindex: "0", role: "region", "aria-label": caption },
    el("table", {}, el("caption", { class: "unseen" }, caption), el("thead", {}, el("tr", {}, heads)), body),
    more,
  );
}

/** The figure `"table"`. */
export function drawTable(figure, { array, host }) {
  const columns = figure.columns.map((c) => ({
    name: c.name,
    unit: c.unit,
    time: c.unit === "UTC" && !c.values,
    values: c.values ?? array(c.data) ?? [],
  }));
  host.append(tableOf(columns, figure.title, true));
  return { columns: () => columns, series: () => columns, isTable: true };
}
