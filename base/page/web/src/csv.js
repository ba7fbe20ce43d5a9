/* Columns of a figure as a file that the reader saves: names with units on top, every digit of the data.
 *
 * A column: {name, unit?, values: array of numbers or texts, time?: true where these are seconds since 1970}. */
import { exact, utcIso } from "./format.js";

function cell(text) {
  // A spreadsheet may run what begins so; "+x" and "-x" are names of sides and stay.
  const safe = /^([=@\t\r]|[+-].*[(|!])/.test(text) ? `'${text}` : text;
  return /[",\n\r]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

function heading({ name, unit, time }) {
  if (time) return `${name} [UTC]`;
  return unit && unit !== "1" ? `${name} [${unit}]` : String(name);
}

/** The text of a file of these columns. A time has two: UTC to the millisecond, and seconds since 1970 with all digits. */
export function csvText(columns) {
  const wide = columns.flatMap((c) => (c.time ? [c, { name: `${c.name}`, unit: "s since 1970", values: c.values }] : [c]));
  const rows = Math.max(0, ...wide.map((c) => c.values.length));
  const lines = [wide.map((c) => cell(heading(c))).join(",")];
  for (let i = 0; i < rows; i += 1)
    lines.push(
      wide
        .map((c) => {
          const v = c.values[i];
          if (v === undefined || v === null) return "";
          if (typeof v !== "number") return cell(String(v));
          return c.time ? utcIso(v) : exact(v, c.values instanceof Float32Array);
        })
        .join(","),
    );
  return `${lines.join("\n")}\n`;
}

/** Hands a text to the reader as a file. */
export function saveText(name, text, type = "text/csv") {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10e3);
}
