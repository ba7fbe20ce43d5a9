/* What the scene can show of each surface: part, material, and quantities over time, with their colours. */
import { extent, kindColour, mapColour, shareOf } from "./colour.js";

/** The document's scene with its arrays in place. */
export function readScene(scene, array) {
  const out = { ...scene };
  for (const key of ["vertices", "triangles", "surface", "body", "time", "observer", "sun", "nadir", "velocity", "up", "sunlit"]) out[key] = array(scene[key]);
  out.bodies = (scene.bodies ?? []).map((b) => ({ ...b, pose: array(b.pose) }));
  out.part = array(scene.surfaces?.part) ?? [];
  out.material = array(scene.surfaces?.material) ?? [];
  out.count = scene.surfaces?.count ?? out.part.length;
  if (!out.time || out.time.length === 0) for (const key of ["observer", "sun", "nadir", "velocity", "up", "sunlit"]) out[key] = null;
  if (!out.time) out.time = new Float64Array(0);
  return out;
}

/** A choice of names, as parts and materials are. */
function kinds(id, name, names, ofSurface) {
  const used = [...new Set(ofSurface)].sort((a, b) => a - b);
  return {
    id, name, kinds: used.map((k) => ({ name: names[k] ?? `${name} ${k}`, colour: kindColour(k) })),
    text: (i, surface) => names[ofSurface[surface]] ?? "",
    colours: () => (surface) => kindColour(ofSurface[surface] ?? 0),
  };
}

/** A quantity of the document. Its data are read when it is shown first. */
function quantity(q, scene, array) {
  const log = q.scale === "log";
  let data = null;
  const values = () => (data ??= array(q.data) ?? new Float64Array(0));
  const at = (i) => values().subarray(i * scene.count, (i + 1) * scene.count);
  let whole = null;
  return {
    id: q.id, name: q.name, unit: q.unit, log, at,
    value: (i, surface) => values()[i * scene.count + surface],
    range: (i, instant) => (instant ? extent(at(i), log) : (whole ??= extent(values(), log))),
    colours(i, instant) {
      const share = shareOf(...this.range(i, instant), { log });
      return (surface) => mapColour(share(this.value(i, surface)));
    },
  };
}

/** All that can be shown, quantities first. */
export function choices(scene, array) {
  const quantities = scene.time.length > 0 ? (scene.quantities ?? []).map((q) => quantity(q, scene, array)) : [];
  return [...quantities, kinds("material", "material", scene.materials ?? [], scene.material), kinds("part", "part", scene.parts ?? [], scene.part)];
}
