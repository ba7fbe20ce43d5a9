/* The satellite as triangles of three.js: one group a joint, colours of surfaces, edges. */
import {
  BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Quaternion, Vector3,
} from "three";
import { shapeEdges } from "./scene_edges.js";

/** So many corners of a joint are looked at for the size of the satellite. */
const MANY = 4000;

/** Triangles of one joint, each with corners of its own, so that each has one colour. */
function piece(scene, chosen) {
  const position = new Float32Array(chosen.length * 9);
  chosen.forEach((t, n) => {
    for (let corner = 0; corner < 3; corner += 1)
      for (let axis = 0; axis < 3; axis += 1) position[9 * n + 3 * corner + axis] = scene.vertices[3 * scene.triangles[3 * t + corner] + axis];
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(position, 3));
  geometry.setAttribute("color", new BufferAttribute(new Uint8Array(chosen.length * 9), 3, true));
  const mesh = new Mesh(geometry, new MeshBasicMaterial({ vertexColors: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
  mesh.userData.triangles = chosen;
  const kindOf = (n) => {
    const surface = scene.surface[chosen[n]];
    return (scene.part[surface] ?? 0) * 65536 + (scene.material[surface] ?? 0);
  };
  const edges = new LineSegments(shapeEdges(position, (n, k) => scene.triangles[3 * chosen[n] + k], kindOf), new LineBasicMaterial({ color: 0x20262b, transparent: true, opacity: 0.6 }));
  const group = new Group();
  group.add(mesh, edges);
  return { group, mesh, edges };
}

/**
 * @param {object} scene of scene_values.js
 * @returns {{root: Group, meshes: Mesh[], centre: Vector3, radius: number, paint: (colour: (surface: number) => number[]) => void,
 *   pose: (i: number) => void, visit: (i: number, f: (corner: Vector3) => void) => void, edgeColour: (colour: string) => void}}
 */
export function createMesh(scene) {
  const count = scene.triangles.length / 3;
  const ofBody = new Map();
  for (let t = 0; t < count; t += 1) {
    const b = scene.body ? scene.body[t] : 0;
    if (!ofBody.has(b)) ofBody.set(b, []);
    ofBody.get(b).push(t);
  }
  const root = new Group();
  const pieces = [...ofBody].map(([body, chosen]) => ({ body, ...piece(scene, chosen) }));
  for (const p of pieces) root.add(p.group);

  const turn = new Quaternion();
  const pose = (i) => {
    for (const p of pieces) {
      const poses = scene.bodies?.[p.body]?.pose;
      if (!poses || poses.length < 7 * (i + 1)) continue;
      const q = poses.subarray(7 * i, 7 * i + 7);
      if (!q.every(Number.isFinite)) continue;
      p.group.quaternion.copy(turn.set(q[1], q[2], q[3], q[0]).normalize());
      p.group.position.set(q[4], q[5], q[6]);
    }
  };

  const corner = new Vector3();
  /** Calls f with corners of the satellite as it stands at an instant. */
  const visit = (i, f) => {
    pose(i);
    root.updateMatrixWorld(true);
    for (const p of pieces) {
      const place = p.mesh.geometry.getAttribute("position");
      // Many corners: a part of them tells the size as well.
      const stride = Math.ceil(place.count / MANY);
      for (let k = 0; k < place.count; k += stride) f(corner.fromBufferAttribute(place, k).applyMatrix4(p.mesh.matrixWorld));
    }
  };
  const { centre, radius } = bounds(visit, scene.time?.length ?? 0);
  return {
    root,
    meshes: pieces.map((p) => p.mesh),
    centre,
    radius,
    pose,
    visit,
    paint(colour) {
      for (const p of pieces) {
        const attribute = p.mesh.geometry.getAttribute("color");
        p.mesh.userData.triangles.forEach((t, n) => {
          const c = colour(scene.surface[t]);
          for (let corner = 0; corner < 3; corner += 1) attribute.array.set(c, 9 * n + 3 * corner);
        });
        attribute.needsUpdate = true;
      }
    },
    edgeColour(colour) {
      for (const p of pieces) p.edges.material.color.set(colour);
    },
  };
}

/** Some instants of `times`, the first among them; the first alone of none. */
export function someInstants(times, most) {
  const every = Math.max(1, Math.floor(times / most));
  return Array.from({ length: Math.ceil(Math.max(1, times) / every) }, (v, i) => i * every);
}

/** A ball about the satellite in all its poses, by its corners. */
function bounds(visit, times) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = new Vector3(-Infinity, -Infinity, -Infinity);
  const instants = someInstants(times, 12);
  for (const i of instants)
    visit(i, (v) => {
      low.min(v);
      high.max(v);
    });
  const centre = low.add(high).multiplyScalar(0.5);
  let radius = 0;
  for (const i of instants)
    visit(i, (v) => {
      radius = Math.max(radius, v.distanceTo(centre));
    });
  return Number.isFinite(radius) && radius > 0 ? { centre, radius } : { centre: new Vector3(), radius: 1 };
}
