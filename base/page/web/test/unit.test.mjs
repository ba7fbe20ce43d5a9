/* What needs no browser: marks of axes, numbers, files, what-ifs, the shared instant. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { Clock, clockKey, nearest } from "../src/clock.js";
import { csvText } from "../src/csv.js";
import { exact, nameAndUnit, number, plain, position, utcClock, utcDate, utcIso } from "../src/format.js";
import { shapeEdges } from "../src/scene_edges.js";
import { commonPower, niceStep, tickLabels, ticks } from "../src/ticks.js";
import { isBeyond, moved, rangeOf, statedInterval, telling } from "../src/whatif.js";
import { createSatellite } from "./satellite.mjs";

const at = Date.UTC(2016, 8, 21, 20, 36, 59) / 1000;

test("numbers have the digits that say something", () => {
  assert.equal(number(273.15), "273.1");
  assert.equal(number(0.012345), "0.01235");
  assert.equal(number(-1.5e-7), "−1.5×10⁻⁷");
  assert.equal(number(0), "0");
  assert.equal(number(NaN), "–");
  assert.equal(number(200), "200");
  assert.equal(plain(0.8), "0.8");
  assert.equal(nameAndUnit("irradiance", "W/m^2"), "irradiance, W/m²");
  assert.equal(nameAndUnit("cross-section", "m2/sr"), "cross-section, m²/sr");
  assert.equal(nameAndUnit("share", "1"), "share");
});

test("instants are of UTC, and seconds are rounded, not cut", () => {
  assert.equal(utcDate(at), "2016-09-21");
  assert.equal(utcClock(at), "20:36:59");
  assert.equal(utcClock(at + 0.9996), "20:37:00");
  assert.equal(utcClock(at + 0.25, 2), "20:36:59.25");
  assert.equal(utcIso(at + 0.001), "2016-09-21T20:36:59.001Z");
  assert.equal(position(at, { scale: "time" }), "2016-09-21 20:36:59 UTC");
});

test("marks stand at round places within the axis", () => {
  assert.deepEqual(ticks(0, 10, 5, "linear"), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(tickLabels([0, 0.25, 0.5], "linear"), ["0.00", "0.25", "0.50"]);
  assert.deepEqual(tickLabels([-10, 0, 10], "linear"), ["−10", "0", "10"]);
  assert.deepEqual(tickLabels([0, 2.5, 5], "linear"), ["0.0", "2.5", "5.0"]);
  assert.deepEqual(tickLabels([0, 25, 50], "linear"), ["0", "25", "50"]);
  assert.deepEqual(tickLabels([0, 2.5e-11, 5e-11, 7.5e-11], "linear"), ["0.0", "2.5", "5.0", "7.5"]);
  assert.equal(commonPower([0, 2.5e-11, 5e-11, 7.5e-11], "linear"), -11);
  assert.equal(commonPower([0, 500], "linear"), 0);
  assert.equal(niceStep(10, 5), 2);
  const decades = ticks(1e-4, 1e3, 4, "log");
  assert.ok(decades.every((v) => Math.abs(Math.log10(v) - Math.round(Math.log10(v))) < 1e-9));
  assert.deepEqual(tickLabels([1e-4, 1e-2], "log"), ["10⁻⁴", "10⁻²"]);
  const times = ticks(at, at + 600, 6, "time");
  assert.ok(times.every((t) => t % 120 === 0));
  assert.deepEqual(tickLabels(times.slice(0, 2), "time"), ["20:38", "20:40"]);
  const midnight = Date.UTC(2016, 8, 22) / 1000;
  assert.deepEqual(tickLabels([midnight - 3600, midnight, midnight + 3600], "time"), ["23:00", "2016-09-22", "01:00"]);
  for (const type of ["linear", "log", "time", "magnitude"])
    for (const span of [1e-9, 1e-3, 1, 7e4, 3e9]) {
      const marks = ticks(1, 1 + span, 6, type);
      assert.ok(marks.length >= 1 && marks.length <= 40, `${type} ${span}: ${marks.length}`);
      assert.equal(tickLabels(marks, type).length, marks.length);
    }
});

test("a file has every digit, names with units, and no formula", () => {
  const single = Float32Array.from([0.1, 1 / 3]);
  const text = csvText([
    { name: "time", unit: "UTC", time: true, values: Float64Array.from([at, at + 0.5]) },
    { name: "VIS", unit: "W/sr", values: Float64Array.from([0.1 + 0.2, NaN]) },
    { name: "single", unit: "1", values: single },
    { name: "text", values: ["=1+1", 'a "b", c'] },
    { name: "side", values: ["+x", "-x"] },
  ]);
  const lines = text.split("\n");
  assert.equal(lines[0], "time [UTC],time [s since 1970],VIS [W/sr],single,text,side");
  assert.equal(lines[1], `2016-09-21T20:36:59.000Z,${at},0.30000000000000004,0.1,'=1+1,+x`);
  assert.equal(lines[2], `2016-09-21T20:36:59.500Z,${at + 0.5},,0.33333334,"a ""b"", c",-x`);
  for (const v of single) assert.equal(Math.fround(Number(exact(v, true))), v);
});

test("what-ifs are base and sum of changes, with the stated share of error", () => {
  const parameters = [{ null: 1 }, { null: 0 }];
  const curve = { base: Float64Array.from([10, 20]), derivative: [Float64Array.from([1, -2]), Float64Array.from([0.5, 0.25])], error: [0.1, 0] };
  const now = moved(curve, parameters, [1.5, 4]);
  assert.deepEqual([...now.value], [12.5, 20]);
  assert.deepEqual([...now.error].map((v) => Number(v.toFixed(12))), [0.1, 0.1]);
  assert.deepEqual([...moved(curve, parameters, [1, 0]).value], [10, 20]);
  assert.equal(telling(0, { null: 1, width: 0.5 }, [curve]), 0.05);
});

test("a slider leaves its interval where the document says so, and stays within what is possible", () => {
  const p = { null: 1, minimum: 0.5, maximum: 3, reach: 0.07, width: 0.1 };
  assert.deepEqual(statedInterval(p), [0.9299999999999999, 1.07]);
  assert.equal(isBeyond(p, 1.07), false);
  assert.equal(isBeyond(p, 0.92), true);
  const { low, high } = rangeOf(p);
  assert.ok(low >= p.minimum && high <= p.maximum && low < 0.93 && high > 1.07);
});

test("the clock steps through samples, and keys zoom", () => {
  const clock = new Clock();
  clock.offer([0, 1, 2, 3]);
  const key = (name, more = {}) => clockKey(clock, { key: name, preventDefault() {}, ...more });
  key("ArrowRight");
  assert.equal(clock.at, 0);
  key("ArrowRight");
  assert.equal(clock.at, 1);
  key("End");
  assert.equal(clock.at, 3);
  key("ArrowRight");
  assert.equal(clock.at, 3);
  key("+");
  assert.deepEqual(clock.zoom, [1.5, 3]);
  key("Escape");
  assert.equal(clock.zoom, null);
  assert.equal(key("x"), false);
  assert.equal(nearest([0, 1, 2], 1.6), 2);
  assert.equal(nearest([], 1), -1);
});

test("edges show the shape, not the mesh", () => {
  const mesh = createSatellite();
  const of = (chosen) => {
    const position = new Float32Array(chosen.flatMap((t) => [0, 1, 2].flatMap((k) => mesh.vertices.slice(3 * mesh.triangles[3 * t + k], 3 * mesh.triangles[3 * t + k] + 3))));
    const geometry = shapeEdges(position, (t, k) => mesh.triangles[3 * chosen[t] + k], (t) => mesh.surfaces[mesh.surface[chosen[t]]].material);
    return geometry.getAttribute("position").count / 2;
  };
  const all = [...mesh.body.keys()];
  // The box has twelve edges of twelve cells; front and back of the panel share its rim of 6 and 14.
  assert.equal(of(all.filter((t) => mesh.body[t] === 0)), 12 * 12);
  assert.equal(of(all.filter((t) => mesh.body[t] === 1)), 2 * (6 + 14));
});
