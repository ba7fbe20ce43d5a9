/* The canvas of the scene: camera, picture, and which facet is under the pointer. Throws where there is no WebGL. */
import "./sharp.js";
import { ColorManagement, LinearSRGBColorSpace, OrthographicCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { el, oncePerFrame } from "./dom.js";
import { createArrows } from "./scene_arrows.js";
import { createMesh, someInstants } from "./scene_mesh.js";
import { colours, isPrinting, onTheme } from "./theme.js";

/* Colours are data: what the colour bar shows is what the screen gets, without conversion. */
ColorManagement.enabled = false;

/** Room about the satellite, of its size. */
const ROOM = 1.12;
/** So many instants are looked at for how large the observer sees it. */
const INSTANTS = 30;

/**
 * @param {HTMLElement} host takes the canvas @param {object} scene arrays of the document's scene
 * @param {() => void} freed called when the reader turns the view away from the observer's
 */
export function createView(host, scene, freed) {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.setPixelRatio(2);
  renderer.setClearColor(0x000000, 0);
  const canvas = renderer.domElement;
  // On paper a plain canvas stands in: what WebGL draws in time for the printer is not sure to be shown.
  const paper = el("canvas", { class: "paper", "aria-hidden": "true" });
  host.prepend(canvas, paper);

  const mesh = createMesh(scene);
  const arrows = createArrows(scene, mesh.centre, mesh.radius, host);
  const world = new Scene();
  world.add(mesh.root, arrows.root);
  const { centre, radius } = mesh;

  const make = () => new OrthographicCamera(-1, 1, 1, -1, 0.01 * radius, 40 * radius);
  const observer = make();
  const free = make();
  free.up.set(0, 0, 1);
  free.position.copy(centre).add(new Vector3(1.1, -1.5, 0.8).normalize().multiplyScalar(12 * radius));
  const controls = new OrbitControls(free, canvas);
  controls.target.copy(centre);
  controls.enableDamping = false;
  controls.enableZoom = false;
  controls.minZoom = 0.3;
  controls.maxZoom = 20;
  controls.update();
  let mode = scene.observer ? "observer" : "free";
  let withArrows = true;
  let size = [0, 0];

  const camera = () => (mode === "observer" ? observer : free);

  function aim(i) {
    const to = new Vector3();
    if (!scene.observer) return;
    to.fromArray(scene.observer, 3 * i);
    if (!(to.lengthSq() > 0)) return;
    to.normalize();
    observer.up.set(0, 0, 1);
    if (scene.up && Number.isFinite(scene.up[3 * i])) observer.up.fromArray(scene.up, 3 * i);
    observer.position.copy(centre).addScaledVector(to, 12 * radius);
    observer.lookAt(centre);
  }

  /** How far the satellite reaches across and along the observer's picture, at the instants where it reaches far. */
  const reaches = scene.observer
    ? someInstants(scene.time?.length ?? 0, INSTANTS).map((i) => {
        aim(i);
        observer.updateMatrixWorld();
        const [right, up] = [0, 1].map((c) => new Vector3().setFromMatrixColumn(observer.matrixWorld, c));
        const reach = [0, 0];
        mesh.visit(i, (v) => {
          v.sub(centre);
          reach[0] = Math.max(reach[0], Math.abs(v.dot(right)));
          reach[1] = Math.max(reach[1], Math.abs(v.dot(up)));
        });
        return reach;
      })
    : [];
  /** Half of the picture's height: the observer's shows the satellite at all instants, so that its size does not jump; the free one from all sides. */
  function halfOf(c, ratio) {
    const all = ROOM * radius * Math.max(1, 1 / ratio);
    if (c === free) return all;
    const most = ROOM * Math.max(0, ...reaches.map(([across, along]) => Math.max(along, across / ratio)));
    return most > 0.05 * radius ? most : all;
  }

  function resize() {
    const width = isPrinting() ? 420 : host.clientWidth;
    const height = isPrinting() ? 315 : host.clientHeight;
    if (width === 0 || height === 0) return;
    size = [width, height];
    renderer.setSize(width, height, false);
    const ratio = width / height;
    for (const c of [observer, free]) {
      const half = halfOf(c, ratio);
      [c.left, c.right, c.top, c.bottom] = [-half * ratio, half * ratio, half, -half];
      c.updateProjectionMatrix();
    }
    draw();
  }

  function draw() {
    if (size[0] === 0) return;
    const c = camera();
    c.updateMatrixWorld();
    arrows.place(c, ...size, withArrows);
    renderer.render(world, c);
    if (!isPrinting()) return;
    [paper.width, paper.height] = [canvas.width, canvas.height];
    paper.getContext("2d").drawImage(canvas, 0, 0);
  }
  // Out of sight nothing is drawn until it comes back.
  let inSight = true;
  const later = oncePerFrame(() => inSight && draw());
  new IntersectionObserver((entries) => {
    const was = inSight;
    inSight = entries.at(-1).isIntersecting;
    if (inSight && !was) draw();
  }).observe(host);

  controls.addEventListener("start", () => {
    if (mode === "free") return;
    // The free view begins where the observer's was.
    free.position.copy(observer.position);
    free.zoom = observer.zoom * (free.top / observer.top);
    free.updateProjectionMatrix();
    mode = "free";
    controls.update();
    freed();
  });
  controls.addEventListener("change", later);
  canvas.addEventListener(
    "wheel",
    (e) => {
      // The page scrolls unless the reader asks for the picture.
      if (!e.ctrlKey && document.activeElement !== host) return;
      e.preventDefault();
      zoom(Math.exp(-e.deltaY * 0.0015));
    },
    { passive: false },
  );

  function zoom(factor) {
    const c = camera();
    c.zoom = Math.min(20, Math.max(0.3, c.zoom * factor));
    c.updateProjectionMatrix();
    draw();
  }

  new ResizeObserver(oncePerFrame(resize)).observe(host);
  const retheme = () => {
    mesh.edgeColour(colours().edge);
    arrows.tint();
    resize();
    draw();
  };
  onTheme(retheme);

  const ray = new Raycaster();
  const triangleAt = (x, y) => {
    ray.setFromCamera(new Vector2((2 * x) / size[0] - 1, 1 - (2 * y) / size[1]), camera());
    const hit = ray.intersectObjects(mesh.meshes, false)[0];
    return hit ? hit.object.userData.triangles[hit.faceIndex] : -1;
  };

  mesh.pose(0);
  if (scene.time?.length > 0) arrows.set(0);
  aim(0);
  retheme();
  return {
    canvas,
    zoom,
    /** Surface under a place of the canvas, -1 where there is none. */
    surfaceAt: (x, y) => {
      const t = triangleAt(x, y);
      return t < 0 ? -1 : scene.surface[t];
    },
    setTime(i) {
      mesh.pose(i);
      arrows.set(i);
      aim(i);
      later();
    },
    paint(colour) {
      mesh.paint(colour);
      later();
    },
    setMode(next) {
      mode = next;
      draw();
    },
    showArrows(on) {
      withArrows = on;
      draw();
    },
    /** Turns the free view by angles in radians. */
    turn(azimuth, elevation) {
      if (mode === "observer") controls.dispatchEvent({ type: "start" });
      const offset = free.position.clone().sub(centre);
      const r = offset.length();
      const polar = Math.min(Math.PI - 0.01, Math.max(0.01, Math.acos(offset.z / r) - elevation));
      const angle = Math.atan2(offset.y, offset.x) + azimuth;
      free.position.copy(centre).add(new Vector3(Math.sin(polar) * Math.cos(angle), Math.sin(polar) * Math.sin(angle), Math.cos(polar)).multiplyScalar(r));
      controls.update();
      draw();
    },
    draw,
    hasObserver: Boolean(scene.observer),
  };
}
