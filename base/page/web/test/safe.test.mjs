/* What must not break a page: hostile texts, kinds to come, no WebGL, little or broken documents. */
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { launch, open } from "./browser.mjs";
import { Numbers } from "./page.mjs";
import { browser, folder, plot, prepare, series, url, visit, write } from "./pages.mjs";
import { HOSTILE } from "./synthetic.mjs";

prepare("plain", "hostile");

test("texts that try to be markup are shown as texts", () =>
  visit("hostile", async (page) => {
    assert.equal(await page.locator("h1").textContent(), HOSTILE);
    assert.equal(await page.evaluate(() => window.hacked), undefined);
    assert.equal(await page.locator("img").count(), 0);
    const scripts = await page.evaluate(() => [...document.scripts].map((s) => s.type));
    assert.deepEqual(scripts, ["application/json", "text/plain", ""]);
    assert.match(await page.locator('figure[data-id="future"] .unknown').textContent(), /does not know figures of the kind "__proto__"/);
    await page.locator('figure[data-id="satellite"] select').selectOption("part");
    assert.equal(await page.locator(".kinds li").first().textContent(), HOSTILE);
    await page.locator('figure[data-id="light"]').getByRole("button", { name: "Table" }).click();
    assert.equal(await page.evaluate(() => window.hacked), undefined);
  }));

test("a figure of a kind to come shows its title and a word", () =>
  visit("plain", async (page) => {
    const figure = page.locator('figure[data-id="future"]');
    assert.equal(await figure.locator("h3").textContent(), "A figure of a kind to come");
    assert.match(await figure.locator(".unknown").textContent(), /does not know figures of the kind "hologram"/);
  }));

test("without WebGL the scene says so, and the rest works", async () => {
  const poor = await launch(["--disable-3d-apis"]);
  try {
    const { page, violations } = await open(poor, url("plain"));
    assert.match(await page.locator(".scene-view").textContent(), /gives no WebGL/);
    assert.equal((await series(page, "light")).length, 4);
    await page.locator('figure[data-id="satellite"]').getByRole("button", { name: "Table" }).click();
    assert.match(await page.locator('figure[data-id="satellite"] thead').textContent(), /surface.*material.*temperature at/);
    assert.deepEqual(await violations(), []);
  } finally {
    await poor.close();
  }
});

test("a broken document leaves what needs no script", async () => {
  const file = join(folder, "broken.html");
  writeFileSync(file, readFileSync(join(folder, "plain.html"), "utf8").replace('"version":1', '"version":2'));
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector(".failed");
  assert.match(await page.locator(".failed").textContent(), /version 2, this viewer reads 1/);
  assert.equal(await page.locator("#umbra-static h1").textContent(), "EXAMPLESAT over Graz, 2016-09-21");
  await context.close();
});

test("little is enough: no facts, no numbers, one sample, gaps alone, a satellite without time", async () => {
  const n = new Numbers();
  const scene = {
    vertices: n.f32([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]), triangles: n.u32([0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2]), surface: n.u32([0, 1, 2, 3]),
    surfaces: { count: 4, part: n.u32([0, 0, 1, 1]), material: n.u32([0, 1, 0, 1]) }, parts: ["a", "b"], materials: ["m", "n"],
  };
  const x = { name: "time", unit: "UTC", scale: "time", data: n.f64([1e9]) };
  const panel = (series, more = {}) => [{ name: "v", unit: "1", scale: "linear", series, ...more }];
  const figures = [
    { kind: "axes", id: "one", title: "One sample", x, panels: panel([{ name: "a", data: n.f64([3]) }]) },
    { kind: "axes", id: "gaps", title: "Gaps alone", x: { ...x, data: n.f64([1e9, 1e9 + 1]) }, panels: panel([{ name: "a", data: n.f64([NaN, NaN]), error: n.f64([NaN, NaN]) }], { scale: "log" }) },
    { kind: "axes", id: "none", title: "Nothing", x: { ...x, data: n.f64([]) }, panels: panel([{ name: "a", data: n.f64([]) }]) },
    { kind: "axes", id: "equal", title: "All equal", x: { name: "x", unit: "m", scale: "log", data: n.f64([1, 10, 100]) }, panels: panel([{ name: "a", data: n.f64([5, 5, 5]) }], { zero: true }) },
    { kind: "axes", id: "absent", title: "An array that is not there", x, panels: panel([{ name: "a", data: 999 }]) },
    { kind: "bars", id: "bars", title: "Bars", name: "v", unit: "1", scale: "log", bars: [{ name: "a", value: null }, { name: "b", value: 1e-9, error: 1e-10 }] },
    { kind: "map", id: "map", title: "Map", x: { name: "x", unit: "1", data: n.f64([1]) }, y: { name: "y", unit: "1", data: n.f64([1]) }, z: { name: "z", unit: "1", data: n.f64([NaN]) } },
    { kind: "ranges", id: "ranges", title: "Ranges", name: "v", unit: "K", ranges: [{ name: "a", low: null, high: 3 }, { name: "b", of: "c", low: 2, high: 2, minimum: 5 }] },
    { kind: "ranges", id: "no-ranges", title: "Ranges", name: "v", unit: "K", ranges: [] },
    { kind: "sky", id: "sky", title: "Sky", time: n.f64([]), azimuth_deg: n.f64([]), elevation_deg: n.f64([]) },
    { kind: "table", id: "table", title: "Table", columns: [] },
    { kind: "sliders", id: "sliders", title: "Sliders", x, parameters: [], curves: [] },
    { kind: "scene", id: "scene", title: "Scene", quantity: "temperature" },
  ];
  const document = { format: "umbra page", version: 1, title: "Little", lead: [], sections: [{ id: "s", question: "What?", figures }, { id: "t" }], scene };
  write("little", document, n);
  const { page, context, trouble, violations } = await open(browser, url("little"));
  assert.deepEqual(await page.locator(".unknown").allTextContents(), ["This figure could not be drawn: the document has no array 999."]);
  assert.deepEqual(await page.locator("figure select option").allTextContents(), ["material", "part"]);
  assert.equal(trouble.filter((t) => !/absent/.test(t)).length, 0, trouble.join("\n"));
  assert.deepEqual(await violations(), []);
  await page.locator(plot("equal", 0)).focus();
  await page.keyboard.press("End");
  assert.match(await page.locator('figure[data-id="equal"] .readout').textContent(), /^x 100 m/);
  for (const id of figures.map((f) => f.id)) assert.equal(typeof (await page.evaluate((i) => window.umbra.figure(i).csv(), id)), "string");
  await context.close();
});
