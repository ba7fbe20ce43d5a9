/* Reads the document of the page and its numbers (../../format.md). */
import { beside } from "./beside.js";

/** Longer arrays of u16 become single precision, which holds 16 bits as well in half the memory. */
const LONG = 2e6;
/** u16 that stands for NaN. */
const NONE_U16 = 65535;

async function inflate(base64) {
  const text = atob(base64.replace(/\s+/g, ""));
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i += 1) bytes[i] = text.charCodeAt(i);
  if (bytes.length === 0) return new ArrayBuffer(0);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

function readArray(buffer, { type, count, at, scale = 1, offset = 0 }) {
  const size = { f64: 8, f32: 4, u32: 4, u16: 2 }[type];
  if (!size) throw new Error(`array of an unknown type '${type}'`);
  if (!(at >= 0 && at % 8 === 0 && at + size * count <= buffer.byteLength))
    throw new Error(`array of ${count} ${type} at ${at} lies outside the ${buffer.byteLength} bytes of numbers`);
  if (type === "f64") return new Float64Array(buffer, at, count);
  if (type === "f32") return new Float32Array(buffer, at, count);
  if (type === "u32") return new Uint32Array(buffer, at, count);
  const stored = new Uint16Array(buffer, at, count);
  const out = new (count > LONG ? Float32Array : Float64Array)(count);
  for (let i = 0; i < count; i += 1) out[i] = stored[i] === NONE_U16 ? NaN : offset + scale * stored[i];
  return out;
}

/** A document and its numbers, of the elements whose ids end in `suffix`. */
async function readOne(root, suffix) {
  const doc = JSON.parse(root.getElementById(`umbra-document${suffix}`).textContent);
  if (doc.format !== "umbra page") throw new Error(`this is a '${doc.format}', not an 'umbra page'`);
  if (doc.version !== 1) throw new Error(`the page is of version ${doc.version}, this viewer reads 1`);
  return { doc, buffer: await inflate(root.getElementById(`umbra-numbers${suffix}`)?.textContent ?? "") };
}

/** A way to the arrays of documents, one behind the other's; what is an array already is itself. */
function reader(all) {
  const entries = all.flatMap(({ doc, buffer }) => (doc.arrays ?? []).map((about) => ({ about, buffer })));
  const kept = new Map();
  return (index) => {
    if (index === undefined || index === null) return null;
    if (typeof index === "object") return index;
    if (!entries[index]) throw new Error(`the document has no array ${index}`);
    if (!kept.has(index)) kept.set(index, readArray(entries[index].buffer, entries[index].about));
    return kept.get(index);
  };
}

/**
 * The document with a way to its numbers; where the page has several, one of all (beside.js).
 * @returns {Promise<{document: object, array: (index: number|undefined) => (ArrayLike<number>|null)}>}
 *   `array` gives null where a document names no array.
 */
export async function readDocument(root = document) {
  const all = [await readOne(root, "")];
  while (root.getElementById(`umbra-document-${all.length}`)) all.push(await readOne(root, `-${all.length}`));
  const array = reader(all);
  if (all.length === 1) return { document: all[0].doc, array };
  const names = JSON.parse(root.getElementById("umbra-sets").textContent);
  return { document: beside(all.map((a) => a.doc), names, array), array };
}
