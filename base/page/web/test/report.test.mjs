/* A page that the program wrote, held against the tables that it wrote beside it.
 *
 *   UMBRA_REPORT=FOLDER npm test     FOLDER has report.html, lightcurve.csv and what else its figures name as `file` */
import assert from "node:assert/strict";
import { existsSync, readFileSync, statSync } from "node:fs";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { launch, open } from "./browser.mjs";

const folder = process.env.UMBRA_REPORT && resolve(process.env.UMBRA_REPORT);
const only = { skip: folder ? false : "UMBRA_REPORT names no folder" };

/** Columns of a table of the program: numbers, NaN where empty; times as seconds since 1970. */
function readTable(name) {
  const [head, ...rows] = readFileSync(join(folder, name), "utf8").split("\n").filter((l) => l && !l.startsWith("#")).map((l) => l.split(","));
  return Object.fromEntries(
    head.map((h, k) => [h, rows.map((r) => (r[k] === "" || r[k] === undefined ? NaN : h === "time_utc" ? Date.parse(r[k]) / 1000 : Number(r[k])))]),
  );
}

let browser;
let opened;
before(async () => {
  if (!folder) return;
  browser = await launch();
  opened = await open(browser, pathToFileURL(join(folder, "report.html")).href);
});
after(() => browser?.close());

/** What an array of the document may lose against the digits of a table. */
const slack = (array, v) => (array.type === "u16" ? 0.51 * array.scale : 0) + (array.type === "f64" ? 2e-8 : 2e-6) * Math.abs(v);

/** Largest excess of a curve over what may be lost against a column; Infinity where gaps differ. */
function excess(curve, array, column, times) {
  let worst = 0;
  curve.x.forEach((x, i) => {
    const row = times.findIndex((t) => Math.abs(t - x) < 2e-3);
    const [drawn, wanted] = [curve.y[i] ?? NaN, row < 0 ? undefined : column[row]];
    if (wanted === undefined || Number.isNaN(drawn) !== Number.isNaN(wanted)) worst = Infinity;
    else if (!Number.isNaN(wanted)) worst = Math.max(worst, Math.abs(drawn - wanted) - slack(array, wanted));
  });
  return worst;
}

test("the page is whole: no error, no request, no violation, below 3 MB", only, async () => {
  assert.deepEqual(opened.trouble, []);
  assert.deepEqual(await opened.violations(), []);
  assert.deepEqual(opened.requests.filter((r) => !/^(blob|data):/.test(r)), [pathToFileURL(join(folder, "report.html")).href]);
  assert.ok(statSync(join(folder, "report.html")).size < 3e6);
  assert.equal(await opened.page.locator(".unknown").count(), 0);
  assert.equal(await opened.page.locator("#umbra-static").count(), 0);
});

test("every curve of a figure with a file is a column of that file", only, async () => {
  const doc = await opened.page.evaluate(() => window.umbra.document);
  const figures = doc.sections.flatMap((s) => s.figures).filter((f) => f.kind === "axes" && (f.file || f.id === "light"));
  assert.ok(figures.some((f) => f.id === "light"), "no figure 'light'");
  for (const figure of figures) {
    const file = figure.file ?? "lightcurve.csv";
    assert.ok(existsSync(join(folder, file)), `${figure.id} names ${file}, which is not there`);
    const table = readTable(file);
    const drawn = await opened.page.evaluate((id) => window.umbra.figure(id).series(), figure.id);
    const described = figure.panels.flatMap((p) => p.series);
    assert.equal(drawn.length, described.length);
    described.forEach((s, k) => {
      const array = doc.arrays[s.data];
      const what = `${figure.id}, ${s.name} (${figure.panels.map((p) => p.name).join(", ")})`;
      if (s.column) {
        assert.ok(table[s.column], `${what}: ${file} has no column ${s.column}`);
        assert.ok(excess(drawn[k], array, table[s.column], table.time_utc) <= 0, `${what} differs from ${file}, ${s.column}`);
      } else {
        const same = Object.keys(table).filter((c) => c !== "time_utc" && excess(drawn[k], array, table[c], table.time_utc) <= 0);
        assert.ok(same.length > 0, `${what} is no column of ${file}`);
      }
      if (drawn[k].drawn && !figure.panels.some((p) => p.stacked))
        drawn[k].drawn.forEach((v, i) => assert.ok(v === null || v === drawn[k].y[i], `${what}: uPlot draws another number at ${i}`));
    });
  }
});

test("hovering the light moves the scene", only, async () => {
  const { page } = opened;
  const doc = await page.evaluate(() => window.umbra.document);
  if (!doc.scene) return;
  const id = doc.sections.flatMap((s) => s.figures).find((f) => f.kind === "scene").id;
  const over = page.locator('figure[data-id="light"] .u-over').first();
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 30);
  await page.waitForTimeout(200);
  const [at, times] = await page.evaluate(() => [window.umbra.clock.at, Array.from(window.umbra.array(window.umbra.document.scene.time))]);
  const [scene] = await page.evaluate((i) => window.umbra.figure(i).series(), id);
  const nearest = times.reduce((a, b) => (Math.abs(b - at) < Math.abs(a - at) ? b : a));
  assert.ok(Math.abs(scene.time - at) === Math.abs(nearest - at));
});
