/* What the reader does: pointing, zooming, turning, moving sliders. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { test } from "node:test";
import { open } from "./browser.mjs";
import { arrayOf, browser, figureOf, folder, made, plot, prepare, sameNumbers, series, settle, visit } from "./pages.mjs";

prepare("plain", "serve");

test("hovering a curve moves the time of all figures and of the scene", () =>
  visit("plain", async (page) => {
    const over = page.locator(`${plot("light", 0)} .u-over`);
    await over.scrollIntoViewIfNeeded();
    const box = await over.boundingBox();
    await page.mouse.move(box.x + 0.8 * box.width, box.y + 40);
    await settle(page);
    const { flown } = made.plain;
    const at = await page.evaluate(() => window.umbra.clock.at);
    const i = flown.time.indexOf(at);
    assert.ok(Math.abs(i - 0.8 * 420) <= 3, `sample ${i}`);
    const [scene] = await series(page, "satellite");
    assert.equal(scene.time, at);
    const { quantities, surfaces } = made.plain.document.scene;
    const stored = arrayOf(quantities[0].data).slice(i * surfaces.count, (i + 1) * surfaces.count);
    sameNumbers(scene.y, stored, "temperatures of the scene");
    const readout = await page.locator('figure[data-id="temperatures"] .readout').textContent();
    assert.equal(readout, `2016-09-21 ${new Date(at * 1000).toISOString().slice(11, 19)} UTC`);
    assert.match(await page.locator('figure[data-id="light"] .entry').first().textContent(), /VIS\d/);
    assert.match(await page.locator('figure[data-id="sky"] .readout').textContent(), /elevation [\d.]+°/);
  }));

test("the scene shows what is chosen, from the observer or freely", () =>
  visit("plain", async (page) => {
    const figure = page.locator('figure[data-id="satellite"]');
    await figure.locator("select").selectOption("material");
    assert.deepEqual(await figure.locator(".kinds li").allTextContents(), ["mli_kapton", "white_paint", "solar_cells", "panel_back"]);
    const canvas = figure.locator(".scene-view canvas").first();
    await canvas.scrollIntoViewIfNeeded();
    const box = await canvas.boundingBox();
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 260, box.y + 220, { steps: 4 });
    await page.mouse.up();
    assert.equal(await figure.getByRole("button", { name: "Free view" }).getAttribute("aria-pressed"), "true");
    const slider = figure.getByRole("slider", { name: "Time" });
    await slider.focus();
    await page.keyboard.press("End");
    assert.equal(await page.evaluate(() => window.umbra.clock.at), made.plain.flown.time.at(-1));
    assert.match(await figure.locator(".time-output").textContent(), /in sunlight/);
    await page.keyboard.press("Home");
    assert.match(await figure.locator(".time-output").textContent(), /in umbra/);
    await figure.getByRole("button", { name: "Play" }).click();
    await page.waitForTimeout(400);
    await figure.getByRole("button", { name: "Pause" }).click();
    assert.ok((await page.evaluate(() => window.umbra.clock.at)) > made.plain.flown.time[0]);
    await figure.getByRole("button", { name: "Keep in view" }).click();
    assert.equal(await figure.evaluate((f) => getComputedStyle(f).position), "fixed");
  }));

test("dragging zooms every figure over time, double click shows all", () =>
  visit("plain", async (page) => {
    const over = page.locator(`${plot("light", 0)} .u-over`);
    await over.scrollIntoViewIfNeeded();
    const box = await over.boundingBox();
    await page.mouse.move(box.x + 0.25 * box.width, box.y + 50);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 60, { steps: 5 });
    await page.mouse.up();
    await settle(page);
    const spans = () =>
      page.evaluate(() => ["light", "lwir-parts", "temperatures", "whatif"].flatMap((id) => window.umbra.figure(id).plots.map((u) => u.scales.x.max - u.scales.x.min)));
    for (const span of await spans()) assert.ok(Math.abs(span - 210) < 5, `${span} s`);
    await page.locator('figure[data-id="lwir-parts"]').getByRole("button", { name: "Whole range" }).click();
    for (const span of await spans()) assert.equal(span, 840);
  }));

test("a slider moves both curves by the exact sum, and says where the line ends", () =>
  visit("plain", async (page) => {
    const figure = page.locator('figure[data-id="whatif"]');
    const described = figureOf(made.plain.document, "whatif");
    assert.equal(await figure.locator(".slider-row").count(), 8);
    const row = figure.locator('.slider-row[data-name="olr_factor"]');
    await row.getByRole("slider").evaluate((s) => {
      s.value = "620";
      s.dispatchEvent(new Event("input"));
    });
    const second = figure.locator('.slider-row[data-name="albedo_factor"] input[type=number]');
    await second.fill("1.4");
    await second.press("Enter");
    await settle(page);
    const slider = Number(await row.getByRole("slider").inputValue());
    const value = 0.6 + (0.8 * slider) / 1000;
    for (const c of described.curves) {
      const drawn = (await series(page, "whatif")).find((s) => s.name === c.name);
      const base = arrayOf(c.base);
      const change = base.map(() => 0);
      for (const [name, by] of [["olr_factor", value - 1], ["albedo_factor", 1.4 - 1]]) {
        const d = arrayOf(c.derivative[described.parameters.findIndex((p) => p.name === name)]);
        d.forEach((v, i) => (change[i] += by * v));
      }
      drawn.y.forEach((v, i) => assert.ok(Math.abs(v - base[i] - change[i]) <= 1e-12 * Math.abs(base[i]) + 1e-15, `${c.name} ${i}`));
      sameNumbers(drawn.drawn, drawn.y, `${c.name} by uPlot`);
      assert.ok(change.some((v) => Math.abs(v) > 0));
    }
    assert.match(await row.locator(".slider-note").textContent(), /the line is good to 1 % from 0.8 to 1.2/);
    await row.getByRole("slider").evaluate((s) => {
      s.value = "980";
      s.dispatchEvent(new Event("input"));
    });
    assert.match(await row.locator(".slider-note").textContent(), /^Beyond 0.8 to 1.2 the straight line is off by more than 1 %; umbra serve computes it.$/);
    await figure.getByRole("button", { name: "Reset all" }).click();
    await settle(page);
    for (const c of described.curves) sameNumbers((await series(page, "whatif")).find((s) => s.name === c.name).y, arrayOf(c.base), "after reset");
    await figure.getByRole("searchbox").fill("moon");
    assert.equal(await figure.locator(".slider-row").count(), 1);
    await figure.getByRole("checkbox").uncheck();
    await settle(page);
    const lwir = described.curves[1];
    const [base, d] = [arrayOf(lwir.base), arrayOf(lwir.derivative[10])];
    sameNumbers((await series(page, "whatif")).find((s) => s.name === "LWIR").y, base.map((v, i) => v - d[i]), "without the Moon");
  }));

test("beyond its interval a slider asks the program, with the token", async () => {
  const asked = [];
  let answer = null;
  const server = createServer((request, response) => {
    if (request.url === "/") {
      response.setHeader("Content-Type", "text/html; charset=utf-8");
      response.end(readFileSync(join(folder, "serve.html")));
      return;
    }
    let body = "";
    request.on("data", (d) => (body += d));
    request.on("end", () => {
      asked.push({ url: request.url, method: request.method, token: request.headers.authorization, body: JSON.parse(body) });
      response.statusCode = answer ? 200 : 500;
      response.end(answer ? JSON.stringify(answer) : "the model refuses 1.39");
    });
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  try {
    const lwir = made.serve.flown.lwir.map((v, i) => (i === 5 ? null : 1.2 * v));
    answer = { curves: [{ name: "LWIR", data: lwir }] };
    const { page, context, trouble, violations } = await open(browser, `http://127.0.0.1:${server.address().port}/`);
    const row = page.locator('.slider-row[data-name="olr_factor"]');
    const to = (v) => row.getByRole("slider").evaluate((s, value) => {
      s.value = value;
      s.dispatchEvent(new Event("input"));
    }, v);
    await to("600");
    await page.waitForTimeout(600);
    assert.equal(asked.length, 0);
    await to("985");
    await page.waitForFunction(() => /^Computed/.test(document.querySelector(".whatif-status").textContent));
    assert.equal(asked.length, 1);
    assert.deepEqual({ ...asked[0], body: undefined }, { url: "/compute", method: "POST", token: "Bearer secret-token", body: undefined });
    assert.deepEqual(Object.keys(asked[0].body.values), ["olr_factor"]);
    assert.ok(Math.abs(asked[0].body.values.olr_factor - 1.388) < 1e-9);
    sameNumbers((await series(page, "whatif")).find((s) => s.name === "LWIR computed").y, lwir.map((v) => v ?? NaN), "computed");
    answer = null;
    await to("990");
    await page.waitForFunction(() => /^Not computed/.test(document.querySelector(".whatif-status").textContent));
    assert.match(await page.locator(".whatif-status").textContent(), /the model refuses 1.39/);
    assert.deepEqual(await violations(), []);
    assert.deepEqual(trouble.filter((t) => !/500/.test(t)), []);
    await context.close();
  } finally {
    server.close();
  }
});
