/* A made-up satellite for the synthetic page: a box with a panel on a joint, out of the shadow into the Sun. Rough physics, so that the curves look as curves do. */

const SIGMA = 5.670374e-8;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((v) => v / Math.hypot(...a));

const MATERIALS = [
  { name: "mli_kapton", alpha: 0.4, eps: 0.62, rho: 0.45, capacity: 2600 },
  { name: "white_paint", alpha: 0.22, eps: 0.88, rho: 0.75, capacity: 5200 },
  { name: "solar_cells", alpha: 0.78, eps: 0.83, rho: 0.1, capacity: 5200 },
  { name: "panel_back", alpha: 0.55, eps: 0.86, rho: 0.3, capacity: 5200 },
];

/** Cells of a rectangle: each a surface of two triangles. */
function rectangle(mesh, corner, a, b, na, nb, part, material, body) {
  const normal = unit(cross(a, b));
  const first = mesh.vertices.length / 3;
  for (let j = 0; j <= nb; j += 1)
    for (let i = 0; i <= na; i += 1) mesh.vertices.push(...corner.map((c, k) => c + (a[k] * i) / na + (b[k] * j) / nb));
  for (let j = 0; j < nb; j += 1)
    for (let i = 0; i < na; i += 1) {
      const p = first + j * (na + 1) + i;
      const surface = mesh.surfaces.length;
      mesh.surfaces.push({ part, material, normal, body, area: (Math.hypot(...cross(a, b)) / na) / nb, shade: 1 - 0.25 * (j / nb) - 0.1 * (i / na) });
      mesh.triangles.push(p, p + 1, p + na + 2, p, p + na + 2, p + na + 1);
      mesh.surface.push(surface, surface);
      mesh.body.push(body, body);
    }
}

export function createSatellite() {
  const mesh = { vertices: [], triangles: [], surface: [], body: [], surfaces: [] };
  const [x, y, z] = [0.6, 0.5, 0.9];
  const n = 12;
  rectangle(mesh, [x, -y, -z], [0, 2 * y, 0], [0, 0, 2 * z], n, n, 0, 0, 0);
  rectangle(mesh, [-x, y, -z], [0, -2 * y, 0], [0, 0, 2 * z], n, n, 0, 0, 0);
  rectangle(mesh, [x, y, -z], [-2 * x, 0, 0], [0, 0, 2 * z], n, n, 0, 0, 0);
  rectangle(mesh, [-x, -y, -z], [2 * x, 0, 0], [0, 0, 2 * z], n, n, 0, 0, 0);
  rectangle(mesh, [-x, -y, z], [2 * x, 0, 0], [0, 2 * y, 0], n, n, 1, 1, 0);
  rectangle(mesh, [-x, y, -z], [2 * x, 0, 0], [0, -2 * y, 0], n, n, 0, 0, 0);
  // The panel lies in the plane of its joint, which turns about y.
  rectangle(mesh, [-0.55, 0.3, 0], [1.1, 0, 0], [0, 2.6, 0], 6, 14, 2, 2, 1);
  rectangle(mesh, [0.55, 0.3, 0], [-1.1, 0, 0], [0, 2.6, 0], 6, 14, 2, 3, 1);
  return mesh;
}

/** Instants, directions in body axes, light, temperatures and both light curves. */
export function fly(mesh, count = 421) {
  const t0 = Date.UTC(2016, 8, 21, 20, 31, 0) / 1000;
  const time = Array.from({ length: count }, (v, i) => t0 + 2 * i);
  const umbraEnd = t0 + 335;
  const penumbraEnd = t0 + 393;
  const sunlit = time.map((t) => Math.min(1, Math.max(0, (t - umbraEnd) / (penumbraEnd - umbraEnd))));
  const s = mesh.surfaces.length;
  const out = { time, t0, umbraEnd, penumbraEnd, sunlit, sun: [], nadir: [], observer: [], velocity: [], up: [], pose: [], temperature: [], vis: [], lwir: [], parts: [], azimuth: [], elevation: [], lwirOf: [[], [], []] };
  let T = mesh.surfaces.map((f) => 268 - 25 * (f.part === 2) + 4 * f.normal[2]);
  const bright = (eps, Tk) => (eps * 0.0217 * (Tk / 250) ** 5.6 * 1000) / Math.PI;
  time.forEach((t, i) => {
    const a = (i / count) * 4.1;
    const sun = unit([Math.cos(a), 0.55, Math.sin(a)]);
    const nadir = unit([0.2 * Math.cos(a * 0.4), -0.3, -1]);
    const observer = unit([0.75 * Math.cos(0.6 + 1.3 * a), 0.5 + 0.3 * Math.sin(a), 0.6 * Math.sin(0.6 + 1.3 * a) - 0.2]);
    const velocity = unit(cross([0, 1, 0.1], nadir));
    const up = unit(cross(observer, [0.3, -0.2, 1]));
    out.sun.push(...sun);
    out.nadir.push(...nadir);
    out.observer.push(...observer);
    out.velocity.push(...velocity);
    out.up.push(...up);
    const panel = 0.6 + 0.5 * a;
    out.pose.push(Math.cos(panel / 2), 0, Math.sin(panel / 2), 0, 0, 0.3, 0.1);
    const turned = ([nx, ny, nz]) => [nx * Math.cos(panel) + nz * Math.sin(panel), ny, -nx * Math.sin(panel) + nz * Math.cos(panel)];
    let vis = 1e-3 * (1 + 0.4 * Math.sin(i / 40)); // the Moon
    const lwir = [0, 0, 0];
    const sums = [[0, 0], [0, 0], [0, 0]];
    const next = mesh.surfaces.map((f, k) => {
      const m = MATERIALS[f.material];
      const normal = f.body === 1 ? turned(f.normal) : f.normal;
      const [toSun, toEarth, toEye] = [sun, nadir, observer].map((d) => Math.max(0, dot(normal, d)));
      const half = unit(sun.map((v, j) => v + observer[j]));
      const glint = 60 * Math.max(0, dot(normal, half)) ** 260;
      vis += (1361 * 0.44 * sunlit[i] * toSun * toEye * f.area * (m.rho + (f.material !== 1 ? glint : 0))) / Math.PI;
      lwir[f.part] += bright(m.eps, T[k]) * f.area * toEye * 3;
      sums[f.part][0] += f.area;
      sums[f.part][1] += f.area * T[k];
      const heat = m.alpha * f.shade * 1361 * sunlit[i] * toSun + m.eps * 230 * (0.25 + toEarth) * 0.8 + 60 - m.eps * SIGMA * T[k] ** 4;
      return T[k] + (2 * heat) / m.capacity;
    });
    out.temperature.push(...T);
    out.vis.push(vis);
    out.lwir.push(lwir[0] + lwir[1] + lwir[2]);
    lwir.forEach((v, p) => out.lwirOf[p].push(v));
    out.parts.push(sums.map(([area, sum]) => sum / area));
    T = next;
    const way = i / (count - 1) - 0.5;
    out.azimuth.push(((215 - 150 * (way + 0.5) ** 1.1) + 360) % 360);
    out.elevation.push(62 * Math.exp(-(((way - 0.02) / 0.27) ** 2)) + 2);
  });
  out.count = s;
  out.materials = MATERIALS.map((m) => m.name);
  return out;
}

/** A repeatable stream of normal deviates. */
export function noise(seed) {
  let state = seed;
  const uniform = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return (state + 0.5) / 4294967296;
  };
  return () => Math.sqrt(-2 * Math.log(uniform())) * Math.cos(2 * Math.PI * uniform());
}
