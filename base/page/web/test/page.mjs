/* Writes a page as the program does (../../format.md): numbers packed, texts in place, the viewer with its hashes. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { deflateSync } from "node:zlib";

/** Collects arrays; `add` gives the index that the document names. */
export class Numbers {
  constructor() {
    this.parts = [];
    this.arrays = [];
    /** What a reader must get of each array. */
    this.values = [];
    this.at = 0;
  }

  #put(type, values, more = {}) {
    const bytes = Buffer.from(values.buffer, values.byteOffset, values.byteLength);
    this.values.push(Array.from(values, (v) => (type !== "u16" ? v : v === 65535 ? NaN : more.offset + more.scale * v)));
    this.arrays.push({ type, count: values.length, at: this.at, ...more });
    const padding = (8 - (bytes.length % 8)) % 8;
    this.parts.push(bytes, Buffer.alloc(padding));
    this.at += bytes.length + padding;
    return this.arrays.length - 1;
  }

  f64(values) {
    return this.#put("f64", Float64Array.from(values));
  }
  f32(values) {
    return this.#put("f32", Float32Array.from(values));
  }
  u32(values) {
    return this.#put("u32", Uint32Array.from(values));
  }
  /** NaN becomes 65535. */
  u16(values, scale, offset) {
    const stored = Uint16Array.from(values, (v) => (Number.isFinite(v) ? Math.min(65534, Math.max(0, Math.round((v - offset) / scale))) : 65535));
    return this.#put("u16", stored, { scale, offset });
  }

  text() {
    return deflateSync(Buffer.concat(this.parts), { level: 9 }).toString("base64");
  }
}

const escape = (text) => String(text).replaceAll("&", "&amp;").replaceAll("<", "&lt;");

/**
 * The file of a page.
 * @param {object} document without `arrays` @param {Numbers} numbers @param {string} viewer folder with viewer.js, .css and .sha256
 */
export function pageText(document, numbers, viewer, { connect = false } = {}) {
  const read = (name) => readFileSync(join(viewer, name), "utf8");
  const [js, css] = read("viewer.sha256").trim().split("\n");
  const policy = [
    "default-src 'none'", `script-src 'sha256-${js}'`, `style-src 'sha256-${css}'`, "img-src data: blob:",
    ...(connect ? ["connect-src 'self'"] : []), "base-uri 'none'", "form-action 'none'",
  ].join("; ");
  // No "<" is left that could end the element.
  const json = JSON.stringify({ ...document, arrays: numbers.arrays }).replaceAll("<", "\\u003c");
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>${escape(document.title)}</title>
<style>${read("viewer.css")}</style>
</head>
<body>
<main id="umbra-static">
<h1>${escape(document.title)}</h1>
${document.lead.map((t) => `<p>${escape(t)}</p>`).join("\n")}
</main>
<script type="application/json" id="umbra-document">${json}</script>
<script type="text/plain" id="umbra-numbers">${numbers.text()}</script>
<script>${read("viewer.js")}</script>
</body>
</html>
`;
}
