/* Arrows from the satellite to the Sun, nadir, observer and along its velocity, with names beside their tips. */
import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";
import { el } from "./dom.js";
import { colours } from "./theme.js";

export const ARROWS = [
  { id: "sun", name: "Sun" },
  { id: "nadir", name: "nadir" },
  { id: "observer", name: "observer" },
  { id: "velocity", name: "velocity" },
];
const UP = new Vector3(0, 1, 0);

function arrow(radius) {
  // Where the satellite fills the picture an arrow stands before it.
  const material = new MeshBasicMaterial({ transparent: true, depthTest: false });
  const shaft = new Mesh(new CylinderGeometry(radius * 0.011, radius * 0.011, 1, 8), material);
  shaft.position.y = 0.5;
  const head = new Mesh(new ConeGeometry(radius * 0.04, radius * 0.12, 16), material);
  const group = new Group();
  group.add(shaft, head);
  shaft.renderOrder = head.renderOrder = 1;
  return { group, shaft, head, material };
}

/**
 * @param {object} scene arrays of the document's scene @param {Vector3} centre @param {number} radius
 * @param {HTMLElement} layer where the names stand
 */
export function createArrows(scene, centre, radius, layer) {
  const root = new Group();
  const arrows = ARROWS.filter((a) => scene[a.id]).map((a) => {
    const parts = arrow(radius);
    const label = el("span", { class: "arrow-label" }, a.name);
    layer.append(label);
    root.add(parts.group);
    return { ...a, ...parts, label, direction: new Vector3(), known: false, word: a.name };
  });
  const inner = 0.92 * radius;
  const outer = 1.2 * radius;
  return {
    root,
    set(i) {
      for (const a of arrows) {
        a.direction.fromArray(scene[a.id], 3 * i);
        a.known = Number.isFinite(a.direction.lengthSq()) && a.direction.lengthSq() > 0;
        if (!a.known) continue;
        a.direction.normalize();
        a.group.quaternion.setFromUnitVectors(UP, a.direction);
        a.shaft.scale.y = outer - inner;
        a.shaft.position.y = (outer - inner) / 2;
        a.head.position.y = outer - inner;
        const dark = a.id === "sun" && scene.sunlit && scene.sunlit[i] < 0.001;
        a.material.opacity = dark ? 0.35 : 1;
        a.word = dark ? "(Sun)" : a.name;
        a.label.title = dark ? "behind the Earth" : "";
      }
    },
    /** Colours of the theme. */
    tint() {
      for (const a of arrows) {
        a.material.color.set(colours().arrows[a.id]);
        a.label.style.color = colours().arrows[a.id];
      }
    },
    /** Puts the names beside the tips. An arrow that points at the eye or away is a sign: ⊙ or ⊗; that to the observer is left out there. */
    place(camera, width, height, shown) {
      const sight = camera.getWorldDirection(new Vector3());
      const [right, up] = [0, 1].map((c) => new Vector3().setFromMatrixColumn(camera.matrixWorld, c));
      const at = new Vector3();
      const middle = new Vector3().copy(centre).project(camera);
      for (const a of arrows) {
        const along = sight.dot(a.direction);
        // Outside the satellite, but within the picture, with room for the name.
        const [across, upward] = [right, up].map((v) => Math.abs(a.direction.dot(v)) * (outer + 0.07 * radius));
        const size = Math.min(1, (0.84 * camera.right) / camera.zoom / across, (0.86 * camera.top) / camera.zoom / upward);
        a.group.scale.setScalar(size);
        a.group.position.copy(centre).addScaledVector(a.direction, size * inner);
        const end = Math.abs(along) > 0.985;
        a.group.visible = shown && a.known && !end;
        a.label.hidden = !(shown && a.known) || (end && a.id === "observer");
        a.label.textContent = end ? `${along > 0 ? "⊗" : "⊙"} ${a.word}` : a.word;
        // What points away may stand behind the satellite.
        a.label.style.opacity = along > 0.6 ? 0.55 : 1;
        at.copy(centre).addScaledVector(a.direction, size * (outer + 0.07 * radius)).project(camera);
        // The name stands beyond the tip, as seen from the middle.
        const [dx, dy] = [(at.x - middle.x) * width, (middle.y - at.y) * height];
        const [ux, uy] = [dx, dy].map((v) => v / (Math.hypot(dx, dy) || 1));
        const [left, top] = [((at.x + 1) / 2) * width + ux * (8 + a.label.offsetWidth / 2), ((1 - at.y) / 2) * height + uy * 14];
        const half = a.label.offsetWidth / 2 + 4;
        const inside = [Math.min(width - half, Math.max(half, left)), Math.min(height - 12, Math.max(12, top))];
        a.label.style.transform = `translate(-50%, -50%) translate(${inside[0]}px, ${inside[1]}px)`;
      }
    },
  };
}
