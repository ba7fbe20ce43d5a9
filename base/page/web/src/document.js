/* Reads the document of the page and its numbers (../../format.md). */

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
  return Float64Array.from(stored, (v) => (v === NONE_U16 ? NaN : offset + scale * v));
}

/**
 * The document with a way to its numbers.
 * @returns {Promise<{document: object, array: (index: number|undefined) => (ArrayLike<number>|null)}>}
 *   `array` gives null where a document names no array.
 */
export async function readDocument(root = document) {
  const doc = JSON.parse(root.getElementById("umbra-document").textContent);
  if (doc.format !== "umbra page") throw new Error(`this is a '${doc.format}', not an 'umbra page'`);
  if (doc.version !== 1) throw new Error(`the page is of version ${doc.version}, this viewer reads 1`);
  const buffer = await inflate(root.getElementById("umbra-numbers")?.textContent ?? "");
  const kept = new Map();
  const array = (index) => {
    if (index === undefined || index === null) return null;
    if (!doc.arrays?.[index]) throw new Error(`the document has no array ${index}`);
    if (!kept.has(index)) kept.set(index, readArray(buffer, doc.arrays[index]));
    return kept.get(index);
  };
  return { document: doc, array };
}
