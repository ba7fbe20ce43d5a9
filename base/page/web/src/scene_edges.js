/* Edges that show the shape: where a surface ends, bends, or changes its part or material. */
import { BufferAttribute, BufferGeometry, Vector3 } from "three";

/** Facets that meet under less than this are one surface to the eye. */
const FLAT = Math.cos((18 * Math.PI) / 180);
const GRAIN = 1e5;

/**
 * @param {Float32Array} position corners of triangles, nine numbers each
 * @param {(triangle: number, corner: number) => number} vertexOf which vertex of the document a corner is
 * @param {(triangle: number) => number} kindOf what part and material a triangle is of, as a number
 * @returns {BufferGeometry} pairs of points
 */
export function shapeEdges(position, vertexOf, kindOf) {
  const count = position.length / 9;
  const corner = (t, k) => [position[9 * t + 3 * k], position[9 * t + 3 * k + 1], position[9 * t + 3 * k + 2]];
  let size = 0;
  for (const v of position) size = Math.max(size, Math.abs(v));
  const scale = GRAIN / (size || 1);
  const names = new Map();
  const known = new Map();
  // Vertices at one place are one, whatever their number.
  const idOf = (vertex, p) => {
    let id = known.get(vertex);
    if (id !== undefined) return id;
    const key = p.map((v) => Math.round(v * scale)).join(",");
    id = names.get(key) ?? names.size;
    names.set(key, id);
    known.set(vertex, id);
    return id;
  };
  const normals = new Float32Array(3 * count);
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  const edges = new Map();
  for (let t = 0; t < count; t += 1) {
    const corners = [0, 1, 2].map((k) => corner(t, k));
    a.fromArray(corners[0]);
    b.fromArray(corners[1]).sub(a);
    c.fromArray(corners[2]).sub(a);
    b.cross(c).normalize().toArray(normals, 3 * t);
    const ids = corners.map((p, k) => idOf(vertexOf(t, k), p));
    for (let k = 0; k < 3; k += 1) {
      const [from, to] = [ids[k], ids[(k + 1) % 3]];
      if (from === to) continue;
      const key = Math.min(from, to) * 2 ** 26 + Math.max(from, to);
      const edge = edges.get(key);
      if (edge) edge.triangles.push(t);
      else edges.set(key, { ends: [corners[k], corners[(k + 1) % 3]], triangles: [t] });
    }
  }
  const alike = (s, t) =>
    normals[3 * s] * normals[3 * t] + normals[3 * s + 1] * normals[3 * t + 1] + normals[3 * s + 2] * normals[3 * t + 2] > FLAT && kindOf(s) === kindOf(t);
  const points = [];
  for (const { ends, triangles } of edges.values())
    if (triangles.some((s) => !triangles.some((t) => t !== s && alike(s, t)))) points.push(...ends[0], ...ends[1]);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  return geometry;
}
