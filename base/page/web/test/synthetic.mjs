/* A page with every kind of figure, gaps, errors and, where asked for, texts that try to be markup. */
import { Numbers } from "./page.mjs";
import { createSatellite, fly, noise } from "./satellite.mjs";

export const HOSTILE = '<img src=x onerror="window.hacked=1"></script><script>window.hacked=1</script>';

const PARAMETERS = [
  ["emittance_factor:solar_cells", "emittance of solar_cells", "1", 1, 0.5, 1.2, 0.07, 0.03, (t) => 0.55 + 0.3 * Math.cos(t / 130)],
  ["interior_power:bus", "power inside the bus", "W", 60, 0, 400, 35, 20, (t) => 0.0016 * (1 + 0.2 * Math.sin(t / 200))],
  ["mli_quality:bus", "MLI effective emittance, factor", "1", 1, 0.2, 5, 0.25, 0.5, (t) => 0.16 + 0.05 * Math.sin(t / 90)],
  ["absorptance_factor:white_paint", "absorptance of white_paint", "1", 1, 0.5, 3, 0.3, 0.2, (t) => 0.02 + 0.03 * Math.max(0, (t - 335) / 500)],
  ["olr_factor", "Earth's infrared, factor", "1", 1, 0.6, 1.4, 0.2, 0.08, (t) => 0.12 + 0.04 * Math.cos(t / 160)],
  ["albedo_factor", "Earth's albedo, factor", "1", 1, 0, 2, 0.5, 0.2, (t) => 0.01 + 0.02 * Math.max(0, (t - 393) / 450)],
  ["capacity_factor:panel", "heat capacity of the panel, factor", "1", 1, 0.3, 3, 0.12, 0.1, (t) => 0.11 * Math.exp(-t / 500)],
  ["panel_angle", "angle of the panel", "deg", 0, -180, 180, 4, 2, (t) => 0.008 * Math.cos(t / 70)],
  ["range_factor", "range, factor", "1", 1, 0.9, 1.1, 0.05, 0.01, () => -0.002],
  ["contact:panel", "conductance of the hinge", "W/K", 0.2, 0.001, 20, 0.06, 0.1, () => 0.03, { logarithmic: true }],
  ["moonlight", "moonlight", "1", 1, 0, 1, 1, 1, () => 1e-4, { switch: true, null: 1 }],
  ["yarkovsky", "something that hardly matters", "1", 0, -1, 1, 1, 0.01, () => 1e-6],
];

const VIS_SHARE = { "albedo_factor": 0.05, "range_factor": -0.01, "panel_angle": 0.02, "moonlight": 0.001, "absorptance_factor:white_paint": -0.18 };

function lightSection(n, f, shade, gap) {
  const gauss = noise(7);
  const visError = f.vis.map((v) => 0.04 * v + 1e-4);
  const vis = f.vis.map((v, i) => (gap(i) ? NaN : Math.max(0, v + 0.2 * visError[i] * gauss())));
  const magnitude = vis.map((v) => (v > 1e-6 ? 14.2 - 2.5 * Math.log10(v / 10) : NaN));
  const measuredAt = f.time.filter((t, i) => i % 9 === 4 && !gap(i));
  const lwirAt = (t) => f.lwir[Math.round((t - f.t0) / 2)];
  const x = { name: "time", unit: "UTC", scale: "time", data: n.f64(f.time) };
  return {
    x,
    section: {
      id: "light",
      question: "What does the telescope see?",
      text: ["Both bands come from one state of the satellite. In the shadow nothing reflects, while its own heat glows on and fades as the panel cools."],
      figures: [
        {
          kind: "axes", id: "light", title: "Light in both bands", text: "The flash at 20:40 is the panel, which mirrors the Sun toward the station.", x, shade,
          panels: [
            { name: "radiant intensity", unit: "W/sr", scale: "log", series: [{ name: "VIS", data: n.f64(vis), error: n.f32(visError), role: "model" }] },
            { name: "AB magnitude", unit: "mag", scale: "magnitude", series: [{ name: "VIS", data: n.f64(magnitude), role: "model" }] },
            {
              name: "radiant intensity", unit: "W/sr", scale: "linear",
              series: [
                { name: "LWIR", data: n.f64(f.lwir), low: n.f64(f.lwir.map((v) => 0.96 * v)), high: n.f64(f.lwir.map((v) => 1.03 * v)), role: "model" },
                { name: "LWIR measured", data: n.f64(measuredAt.map((t) => lwirAt(t) * (1 + 0.02 * gauss()))), error: n.f64(measuredAt.map((t) => 0.02 * lwirAt(t))), x: n.f64(measuredAt), mark: "points", role: "measured" },
              ],
            },
          ],
        },
        { kind: "scene", id: "satellite", title: "The satellite", text: "As the station sees it. Point at a curve and it shows that instant.", quantity: "temperature" },
      ],
    },
  };
}

function partsSection(n, f, x, shade, names) {
  return {
    id: "parts", question: "Which part makes the light?", text: ["The panel is hottest and largest, so it leads in LWIR wherever its face is seen."], level: "good",
    figures: [
      {
        kind: "axes", id: "lwir-parts", title: "LWIR by part", x, shade,
        panels: [{ name: "radiant intensity", unit: "W/sr", stacked: true, series: f.lwirOf.map((values, p) => ({ name: names[p], data: n.f64(values), mark: "area", role: "part" })) }],
      },
      {
        kind: "bars", id: "what-wins", title: "What explains the measurements", name: "BIC over the best", unit: "1",
        bars: [
          { name: "emittance of solar_cells lower", value: 0, text: "factor 0.91 ± 0.02" },
          { name: "more heat in the bus", value: 14.2, error: 2.1 },
          { name: "MLI worse", value: 38.5, error: 4 },
          { name: "nothing is missing", value: 112.7, error: 6 },
        ],
      },
      {
        kind: "ranges", id: "limits", title: "Temperatures and their limits", name: "temperature", unit: "K",
        ranges: [
          { name: "battery", of: "hot", low: 285, high: 312, error: 2, minimum: 273, maximum: 308, text: "exceeded by 6 K", exceeded: true },
          { name: "battery", of: "cold", low: 276, high: 281, error: 2, minimum: 273, maximum: 308, text: "kept by 1 K" },
          { name: "array", of: "hot", low: 190, high: 371 },
        ],
      },
      { kind: "bars", id: "flows", title: "Heat flows at 20:40", name: "heat flow", unit: "W", bars: [{ name: "solar", value: 812 }, { name: "albedo", value: 96 }, { name: "planet", value: 141 }, { name: "radiated", value: -968, error: 12 }, { name: "stored", value: -81 }] },
    ],
  };
}

function heatSection(n, f, x, shade, names) {
  const at = (p) => f.parts.map((v) => v[p]);
  const ys = Array.from({ length: 24 }, (v, j) => -90 + (180 * (j + 0.5)) / 24);
  const xs = Array.from({ length: 48 }, (v, i) => (360 * (i + 0.5)) / 48);
  const z = ys.flatMap((y) => xs.map((v) => (Math.abs(y) > 80 ? NaN : 12 * Math.cos((y * Math.PI) / 180) * (0.3 + Math.cos(((v - 120) * Math.PI) / 180) ** 8) + Math.sin(v / 20))));
  return {
    id: "heat", question: "How warm does it get?", text: ["Mean temperatures of the parts. The bus hardly notices the shadow."],
    figures: [
      { kind: "axes", id: "temperatures", title: "Temperatures", x, shade, panels: [{ name: "mean temperature", unit: "K", series: [0, 1, 2].map((p) => ({ name: names[p], data: n.f32(at(p)), low: n.f32(at(p).map((v) => v - 6)), high: n.f32(at(p).map((v) => v + 7)) })) }] },
      { kind: "map", id: "reflectivity", title: "Reflectivity by direction", text: "In body axes.", x: { name: "azimuth", unit: "deg", data: n.f64(xs) }, y: { name: "elevation", unit: "deg", data: n.f64(ys) }, z: { name: "cross-section", unit: "m2/sr", data: n.f64(z) } },
      { kind: "map", id: "residual-map", title: "Change by part and time", x: { ...x, name: "time" }, y: { name: "part", unit: "1", data: n.f64([1, 2, 3]), labels: names }, z: { name: "from mean", unit: "K", data: n.f32([0, 1, 2].flatMap((p) => { const v = at(p); const mean = v.reduce((a, b) => a + b) / v.length; return v.map((u) => u - mean); })) }, diverging: true },
    ],
  };
}

function skySection(n, f) {
  return {
    id: "sky", question: "Where in the sky?", text: [],
    figures: [
      {
        kind: "sky", id: "sky", title: "Path over Graz", time: n.f64(f.time), azimuth_deg: n.f64(f.azimuth), elevation_deg: n.f64(f.elevation), sunlit: n.f32(f.sunlit),
        marks: [{ time: f.t0, name: "20:31" }, { time: f.penumbraEnd, name: "leaves the shadow" }, { time: f.time.at(-1), name: "20:45" }],
      },
      {
        kind: "table", id: "summary", title: "Numbers of the pass",
        columns: [
          { name: "part", values: ["bus", "radiator", "panel"] },
          { name: "lowest", unit: "K", data: n.f64([0, 1, 2].map((p) => Math.min(...f.parts.map((v) => v[p])))) },
          { name: "highest", unit: "K", data: n.f64([0, 1, 2].map((p) => Math.max(...f.parts.map((v) => v[p])))) },
          { name: "remark", values: ["wrapped in MLI", "faces +z", "on a joint"] },
        ],
      },
    ],
  };
}

function whatIfSection(n, f, x, shade) {
  const parameters = PARAMETERS.map(([name, label, unit, zero, minimum, maximum, reach, width, d, more]) => ({ name, label, unit, null: zero, minimum, maximum, reach, width, switch: false, logarithmic: false, ...more }));
  parameters[0].text = "It bends since a warmer surface radiates by the fourth power of its temperature.";
  return {
    id: "whatif", question: "What if?", text: ["Each slider moves both bands at once, by the matrix of derivatives."],
    figures: [
      {
        kind: "sliders", id: "whatif", title: "Move what is unknown", x, shade, parameters,
        curves: [
          { name: "VIS", unit: "W/sr", panel: "VIS", base: n.f64(f.vis), derivative: PARAMETERS.map(([name]) => n.f64(f.vis.map((v) => v * (VIS_SHARE[name] ?? 0)))), error: PARAMETERS.map(() => 0.002) },
          { name: "LWIR", unit: "W/sr", panel: "LWIR", base: n.f64(f.lwir), derivative: PARAMETERS.map(([, , , , , , , , d]) => n.f64(f.lwir.map((v, i) => v * d(2 * i)))), error: PARAMETERS.map(() => 0.01) },
        ],
      },
    ],
  };
}

function residualSection(n, f) {
  const gauss = noise(3);
  const phase = f.time.map((t, i) => 40 + 70 * Math.abs(Math.sin(i / 140)));
  const chosen = f.time.map((t, i) => i).filter((i) => i % 5 === 0);
  return {
    id: "residuals", question: "What remains?", text: ["Measured less model, in units of the error."], level: "warning",
    figures: [
      {
        kind: "axes", id: "residual-phase", title: "Residuals by phase angle", x: { name: "phase angle", unit: "deg", scale: "linear", data: n.f64(chosen.map((i) => phase[i])) },
        panels: [{ name: "residual", unit: "sigma", zero: true, series: [{ name: "before", data: n.f64(chosen.map((i) => gauss() + (phase[i] - 70) / 14)), mark: "points", role: "before" }, { name: "after", data: n.f64(chosen.map(() => gauss())), mark: "points", role: "after" }] }],
      },
      { kind: "hologram", id: "future", title: "A figure of a kind to come" },
    ],
  };
}

function sceneOf(n, mesh, f, names) {
  const low = f.temperature.reduce((a, b) => Math.min(a, b));
  const scale = (f.temperature.reduce((a, b) => Math.max(a, b)) - low) / 65000;
  return {
    vertices: n.f32(mesh.vertices), triangles: n.u32(mesh.triangles), surface: n.u32(mesh.surface), body: n.u32(mesh.body),
    surfaces: { count: f.count, part: n.u32(mesh.surfaces.map((s) => s.part)), material: n.u32(mesh.surfaces.map((s) => s.material)) },
    parts: names, materials: f.materials, time: n.f64(f.time),
    observer: n.f32(f.observer), sun: n.f32(f.sun), nadir: n.f32(f.nadir), velocity: n.f32(f.velocity), up: n.f32(f.up), sunlit: n.f32(f.sunlit),
    bodies: [{ name: "bus" }, { name: "panel joint", pose: n.f64(f.pose) }],
    quantities: [
      { id: "temperature", name: "temperature", unit: "K", scale: "linear", data: n.u16(f.temperature, scale, low) },
      { id: "lwir", name: "LWIR radiance", unit: "W/m2/sr", scale: "log", data: n.u16(f.temperature.map((T) => 0.003 * (T / 250) ** 5.6 * 1000), 0.001, 0) },
    ],
  };
}

/**
 * @param {{hostile?: boolean, serve?: boolean, sets?: boolean}} [o]
 * @returns {{document: object, numbers: Numbers, flown: object}}
 */
export function synthetic({ hostile = false, serve = false, sets = false } = {}) {
  const mesh = createSatellite();
  const f = fly(mesh);
  const n = new Numbers();
  const names = hostile ? [HOSTILE, "__proto__", "constructor"] : ["bus", "radiator", "panel"];
  const shade = [{ from: f.t0, to: f.umbraEnd, name: "umbra" }, { from: f.umbraEnd, to: f.penumbraEnd, name: "penumbra" }];
  const gap = (i) => i > 300 && i < 312;
  const { x, section } = lightSection(n, f, shade, gap);
  const sections = [section, partsSection(n, f, x, shade, names), heatSection(n, f, x, shade, names), skySection(n, f), whatIfSection(n, f, x, shade), residualSection(n, f)];
  if (sets)
    sections.push({
      id: "sets", question: "What differs?", figures: [{
        kind: "axes", id: "two", title: "Two runs", x, shade,
        panels: [{ name: "radiant intensity", unit: "W/sr", series: [{ name: "LWIR", set: 0, data: n.f64(f.lwir) }, { name: "LWIR", set: 1, data: n.f64(f.lwir.map((v) => 1.1 * v)) }] }],
      }],
    });
  if (hostile) {
    sections[0].question = HOSTILE;
    sections[0].figures[0].title = HOSTILE;
    sections[0].figures[0].panels[0].series[0].name = HOSTILE;
    sections[3].figures[0].marks[0].name = HOSTILE;
    sections[3].figures[1].columns[0].values[0] = HOSTILE;
    sections[4].figures[0].parameters[0].label = HOSTILE;
    sections.at(-1).figures.at(-1).kind = "__proto__";
  }
  return {
    flown: f,
    numbers: n,
    document: {
      format: "umbra page", version: 1, program: "umbra 0.4.0", command: "umbra run scenarios/example", kind: "run",
      title: hostile ? HOSTILE : "EXAMPLESAT over Graz, 2016-09-21",
      lead: ["It leaves the shadow at 20:36:35 and flashes to AB 10.6 four minutes later.", "In LWIR it is seen all the way; the panel cools by 30 K in the dark."],
      facts: [
        { name: "VIS, brightest", value: "AB 10.6 at 20:40:12" }, { name: "LWIR, brightest", value: "138 W/sr at 20:43:10" }, { name: "Panel", value: "236 to 318 K" },
        { name: "Range at culmination", value: "812 km" }, { name: "Energy audit", value: "1.2e-8 of the turnover" },
      ],
      sections,
      ...(sets ? { sets: [{ name: "out/a" }, { name: "out/b" }] } : {}),
      ...(serve ? { serve: { token: "secret-token" } } : {}),
      scene: sceneOf(n, mesh, f, names),
    },
  };
}
