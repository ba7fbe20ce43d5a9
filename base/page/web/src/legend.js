/* Names of the curves of a panel beside its own name, with their values at the place of the cursor. Each is a button that hides its curve. */
import { el } from "./dom.js";
import { number } from "./format.js";
import { onTheme } from "./theme.js";

function swatch(mark) {
  return el("span", { class: `swatch ${mark}`, "aria-hidden": "true" });
}

/**
 * An entry that is `quiet` has no button; `with` are hidden and shown together with an entry.
 * @param {{name: string, detail?: string, mark: string, visible: boolean, colour: () => string, dash: number[]}[]} entries
 * @param {(entry: object) => void} toggled after `visible` changed
 * @returns {{node: HTMLElement, show: (values: ({y: number, error?: number}|null)[]) => void}}
 */
export function createLegend(entries, toggled) {
  const rows = entries.map((entry) => {
    if (entry.quiet) return null;
    const sign = swatch(entry.mark === "points" ? "points" : entry.mark === "area" ? "area" : entry.dash.length ? "dashed" : "line");
    const value = el("span", { class: "value" });
    const node = el(
      "button",
      {
        type: "button",
        class: "entry",
        "aria-pressed": String(entry.visible),
        on: {
          click: () => {
            entry.visible = !entry.visible;
            for (const other of entry.with ?? []) other.visible = entry.visible;
            node.setAttribute("aria-pressed", String(entry.visible));
            toggled(entry);
          },
        },
      },
      sign,
      el("span", { class: "entry-name" }, entry.name, entry.detail ? el("span", { class: "entry-set" }, ` ${entry.detail}`) : null),
      value,
    );
    const paint = () => sign.style.setProperty("--colour", entry.colour());
    paint();
    onTheme(paint);
    return { node, value };
  });
  return {
    node: el("div", { class: "legend", role: "group", "aria-label": "curves" }, rows.map((r) => r?.node)),
    show(values) {
      values.forEach((v, i) => {
        if (!rows[i]) return;
        const known = v && Number.isFinite(v.y);
        rows[i].value.textContent = known ? number(v.y) + (Number.isFinite(v.error) && v.error > 0 ? ` ± ${number(v.error, 2)}` : "") : "";
      });
    },
  };
}
