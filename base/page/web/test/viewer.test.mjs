/* The viewer in Chromium, on a made-up page: what is drawn is held against the document. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { launch, open } from "./browser.mjs";
import { Numbers, pageText } from "./page.mjs";
import { HOSTILE, synthetic } from "./synthetic.mjs";

let folder;
let browser;
const made = {};

function write(name, options, more) {
  made[name] = synthetic(options);
  const file = join(folder, `${name}.html`);
  writeFileSync(file, pageText(made[name].document, made[name].numbers, folder, more));
  return file;
}
const url = (name) => pathToFileURL(join(folder, `${name}.html`)).href;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "umbra-viewer-"));
  execFileSync(process.execPath, [fileURLToPath(new URL("../build.mjs", import.meta.url)), folder]);
  write("plain", { sets: true });
  write("hostile", { hostile: true });
  write("serve", { serve: true }, { connect: true });
  browser = await launch();
});

after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true, force: true });
});

/** A fresh view of a page; after `f` nothing may have gone wrong in it. */
async function visit(name, f, options) {
  const opened = await open(browser, url(name), options);
  try {
    await f(opened.page, opened);
    assert.deepEqual(opened.trouble, []);
    assert.deepEqual(await opened.violations(), []);
    // blob: is the file that the reader saves, data: a picture within the page.
    assert.deepEqual(opened.requests.filter((r) => !/^(file|blob|data):/.test(r)), []);
    assert.equal(opened.requests.filter((r) => r.startsWith("file:")).length, 1);
  } finally {
    await opened.context.close();
  }
}

const figureOf = (doc, id) => doc.sections.flatMap((s) => s.figures).find((f) => f.id === id);
const series = (page, id) => page.evaluate((i) => window.umbra.figure(i).series(), id);
/** Numbers as they were put into the page. */
const arrayOf = (index, name = "plain") => made[name].numbers.values[index];
const plot = (id, panel = 0) => `figure[data-id="${id}"] .panel:nth-of-type(${panel + 1}) .plot`;
const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

function sameNumbers(drawn, wanted, what) {
  assert.equal(drawn.length, wanted.length, what);
  wanted.forEach((v, i) => {
    const d = drawn[i] ?? NaN;
    if (!(Number.isNaN(v ?? NaN) && Number.isNaN(d)) && d !== v) assert.fail(`${what}: sample ${i} is ${d}, not ${v}`);
  });
}

test("a page is below 3 MB", () => assert.ok(statSync(join(folder, "plain.html")).size < 3e6));

test("every curve is drawn with the numbers of the document, gaps included", () =>
  visit("plain", async (page) => {
    const doc = made.plain.document;
    let checked = 0;
    for (const figure of doc.sections.flatMap((s) => s.figures).filter((f) => f.kind === "axes")) {
      const drawn = await series(page, figure.id);
      for (const panel of figure.panels)
        for (const s of panel.series) {
          const d = drawn.splice(drawn.findIndex((c) => c.name === s.name && c.panel === panel.name && c.set === s.set), 1)[0];
          const what = `${figure.id}, ${s.name}`;
          const x = arrayOf(s.x ?? figure.x.data);
          const y = arrayOf(s.data);
          if (x.every((v, i) => i === 0 || v >= x[i - 1])) {
            sameNumbers(d.x, x, what);
            sameNumbers(d.y, y, what);
            if (s.error !== undefined) sameNumbers(d.error, arrayOf(s.error), what);
          } else sameNumbers([...d.y].sort((a, b) => a - b), [...y].sort((a, b) => a - b), what);
          if (d.drawn && !panel.stacked) sameNumbers(d.drawn, y.map((v) => (panel.scale === "log" && v <= 0 ? NaN : v)), `${what}, by uPlot`);
          checked += 1;
        }
      assert.equal(drawn.length, 0);
    }
    assert.ok(checked >= 12);
    const stack = await series(page, "lwir-parts");
    const sums = stack.at(-1).drawn;
    sums.forEach((v, i) => assert.ok(Math.abs(v - stack.reduce((a, s) => a + s.y[i], 0)) < 1e-9 * v));
  }));

test("no canvas is blank, magnitudes grow downward", () =>
  visit("plain", async (page) => {
    const blank = await page.evaluate(() =>
      [...document.querySelectorAll("canvas:not(.paper)")].filter((c) => {
        const copy = document.createElement("canvas");
        [copy.width, copy.height] = [c.width, c.height];
        const context = copy.getContext("2d");
        context.drawImage(c, 0, 0);
        const { data } = context.getImageData(0, 0, c.width, c.height);
        const seen = new Set();
        for (let i = 0; i < data.length; i += 4) seen.add(data[i] * 65536 + data[i + 1] * 256 + data[i + 2]);
        return seen.size < 8;
      }).map((c) => c.closest("figure")?.dataset.id),
    );
    assert.deepEqual(blank, []);
    const [bright, faint] = await page.evaluate(() => {
      const u = window.umbra.figure("light").plots[1];
      return [u.valToPos(11, "y"), u.valToPos(20, "y")];
    });
    assert.ok(bright < faint);
  }));

test("a curve's pixels lie where its numbers say, in its colour", () =>
  visit("plain", async (page) => {
    const { time, lwir } = made.plain.flown;
    const off = await page.evaluate(([xs, ys]) => {
      const u = window.umbra.figure("light").plots[2];
      const near = (x, y) => {
        const { data } = u.ctx.getImageData(Math.round(x) - 2, Math.round(y) - 2, 5, 5);
        for (let i = 0; i < data.length; i += 4) if (Math.abs(data[i] - 0xd5) + Math.abs(data[i + 1] - 0x5e) + Math.abs(data[i + 2]) < 60) return true;
        return false;
      };
      // Measured points hide the line where they lie on it.
      return xs.filter((x, i) => i > 4 && i < xs.length - 5 && i % 9 === 0 && !near(u.valToPos(x, "x", true), u.valToPos(ys[i], "y", true))).length;
    }, [time, lwir]);
    assert.equal(off, 0);
  }, { colorScheme: "light" }));

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

test("a facet has the colour of its value on the bar, and pointing at it names it", () =>
  visit("plain", async (page) => {
    await page.evaluate(() => window.umbra.clock.move(window.umbra.clock.steps[400]));
    await settle(page);
    const found = await page.evaluate(() => {
      const figure = window.umbra.figure("satellite");
      const { canvas } = figure.view;
      figure.view.draw();
      const copy = document.createElement("canvas");
      [copy.width, copy.height] = [canvas.width, canvas.height];
      const context = copy.getContext("2d");
      context.drawImage(canvas, 0, 0);
      const bar = figure.element.querySelector(".colourbar canvas").getContext("2d");
      const [shown] = figure.series();
      const all = window.umbra.array(window.umbra.document.scene.quantities[0].data);
      let [min, max] = [Infinity, -Infinity];
      for (const v of all) [min, max] = [Math.min(min, v), Math.max(max, v)];
      const out = [];
      for (let x = 20; x < canvas.clientWidth; x += 17)
        for (let y = 20; y < canvas.clientHeight; y += 17) {
          const surface = figure.view.surfaceAt(x, y);
          if (surface < 0) continue;
          const share = (shown.y[surface] - min) / (max - min);
          out.push({ x, y, surface, pixel: [...context.getImageData(2 * x, 2 * y, 1, 1).data.slice(0, 3)], bar: [...bar.getImageData(Math.round(share * 255), 0, 1, 1).data.slice(0, 3)] });
        }
      return out;
    });
    assert.ok(found.length > 20);
    const right = found.filter((f) => f.pixel.every((v, k) => Math.abs(v - f.bar[k]) <= 4));
    // The others lie on an edge or under an arrow.
    assert.ok(right.length > 0.85 * found.length, `${right.length} of ${found.length}`);
    const canvas = page.locator('figure[data-id="satellite"] .scene-view canvas').first();
    await canvas.scrollIntoViewIfNeeded();
    const box = await canvas.boundingBox();
    const one = right[Math.floor(right.length / 2)];
    await page.mouse.move(box.x + one.x, box.y + one.y);
    await settle(page);
    assert.match(await page.locator(".scene-tip").textContent(), /(bus|radiator|panel).*temperature [\d.]+ K/);
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

function parse(text) {
  const rows = [[""]];
  let quoted = false;
  for (let i = 0; i < text.length; i += 1) {
    const c = text[i];
    const row = rows.at(-1);
    if (quoted && c === '"' && text[i + 1] === '"') {
      row[row.length - 1] += '"';
      i += 1;
    } else if (c === '"') quoted = !quoted;
    else if (c === "," && !quoted) row.push("");
    else if (c === "\n" && !quoted) rows.push([""]);
    else row[row.length - 1] += c;
  }
  rows.pop();
  return rows;
}

test("the file that is saved has every digit of the data", () =>
  visit("plain", async (page) => {
    for (const figure of made.plain.document.sections.flatMap((s) => s.figures).filter((f) => f.kind !== "hologram")) {
      const waiting = page.waitForEvent("download");
      await page.locator(`figure[data-id="${figure.id}"]`).getByRole("button", { name: /as CSV/ }).click();
      const download = await waiting;
      assert.equal(download.suggestedFilename(), `${figure.id}.csv`);
      const rows = parse(readFileSync(await download.path(), "utf8"));
      assert.ok(rows.length > 1, figure.id);
      const column = (name) => rows.slice(1).map((r) => r[rows[0].indexOf(name)]);
      if (figure.id === "light") {
        assert.deepEqual(rows[0].slice(0, 4), ["time [UTC]", "time [s since 1970]", "VIS radiant intensity [W/sr]", "VIS radiant intensity sigma [W/sr]"]);
        const y = arrayOf(figure.panels[0].series[0].data);
        column("VIS radiant intensity [W/sr]").forEach((text, i) => assert.equal(text === "" ? NaN : Number(text), y[i]));
        const e = arrayOf(figure.panels[0].series[0].error);
        column("VIS radiant intensity sigma [W/sr]").forEach((text, i) => assert.equal(Math.fround(Number(text)), e[i]));
        const measured = arrayOf(figure.panels[2].series[1].data);
        assert.deepEqual(column("LWIR measured radiant intensity [W/sr]").filter((t) => t !== "").map(Number), measured);
      }
      if (figure.id === "reflectivity") {
        const z = arrayOf(figure.z.data);
        column("cross-section [m2/sr]").forEach((text, i) => assert.equal(text === "" ? NaN : Number(text), z[i]));
      }
    }
    const figure = page.locator('figure[data-id="light"]');
    await figure.getByRole("button", { name: "Table" }).click();
    assert.equal(await figure.locator("tbody tr").count(), 100);
    await figure.getByRole("button", { name: "Show all 421 rows" }).click();
    assert.equal(await figure.locator("tbody tr").count(), 421);
  }));

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

test("bars, maps and the sky show their numbers", () =>
  visit("plain", async (page) => {
    const bars = figureOf(made.plain.document, "flows").bars;
    const widths = await page.locator('figure[data-id="flows"] .bar').evaluateAll((all) => all.map((b) => parseFloat(b.style.width)));
    bars.forEach((b, i) => assert.ok(Math.abs(widths[i] / widths[0] - Math.abs(b.value) / bars[0].value) < 1e-3, b.name));
    const { z } = figureOf(made.plain.document, "reflectivity");
    const values = arrayOf(z.data);
    const [drawn] = await series(page, "reflectivity");
    sameNumbers(drawn.z, values, "map");
    const [low, high] = [Math.min(...values.filter(Number.isFinite)), Math.max(...values.filter(Number.isFinite))];
    const wrong = await page.evaluate(([zs, min, max]) => {
      const figure = window.umbra.figure("reflectivity");
      const u = figure.plots[0];
      const bar = figure.element.querySelector(".colourbar canvas").getContext("2d");
      const [s] = figure.series();
      let off = 0;
      s.y.forEach((y, j) => s.x.forEach((x, i) => {
        const v = zs[j * s.x.length + i];
        const p = u.ctx.getImageData(Math.round(u.valToPos(x, "x", true)), Math.round(u.valToPos(y, "y", true)), 1, 1).data;
        const q = v === null ? [0, 0, 0, 0] : bar.getImageData(Math.round((255 * (v - min)) / (max - min)), 0, 1, 1).data;
        if (v === null ? p[3] > 60 : [0, 1, 2].some((k) => Math.abs(p[k] - q[k]) > 4)) off += 1;
      }));
      return off;
    }, [values.map((v) => (Number.isFinite(v) ? v : null)), low, high]);
    assert.equal(wrong, 0);
    const { flown } = made.plain;
    await page.evaluate((t) => window.umbra.clock.move(t), flown.time[300]);
    const dot = await page.locator(".sky-now").evaluate((d) => [Number(d.getAttribute("cx")) - 180, 180 - Number(d.getAttribute("cy"))]);
    // East is left: the azimuth runs against the clock.
    const azimuth = (Math.atan2(-dot[0], dot[1]) * 180) / Math.PI;
    assert.ok(Math.abs(((azimuth - flown.azimuth[300] + 540) % 360) - 180) < 0.01);
    assert.ok(Math.abs(90 - (90 * Math.hypot(...dot)) / 150 - flown.elevation[300]) < 0.01);
  }));

test("several documents beside each other are told apart by name", () =>
  visit("plain", async (page) => {
    const names = await page.locator('figure[data-id="two"] .entry-name').allTextContents();
    assert.deepEqual(names, ["LWIR out/a", "LWIR out/b"]);
    const tints = await page.locator('figure[data-id="two"] .swatch.line').evaluateAll((s) => s.map((e) => e.style.getPropertyValue("--colour")));
    assert.notEqual(tints[0], tints[1]);
    assert.match((await page.evaluate(() => window.umbra.figure("two").csv())).split("\n")[0], /LWIR radiant intensity \(out\/a\) \[W\/sr\],LWIR radiant intensity \(out\/b\)/);
  }));

test("a figure of a kind to come shows its title and a word", () =>
  visit("plain", async (page) => {
    const figure = page.locator('figure[data-id="future"]');
    assert.equal(await figure.locator("h3").textContent(), "A figure of a kind to come");
    assert.match(await figure.locator(".unknown").textContent(), /does not know figures of the kind "hologram"/);
  }));

test("every control is reached by the keyboard, and the focus is seen", () =>
  visit("plain", async (page) => {
    const wanted = await page.evaluate(() => {
      const all = [...document.querySelectorAll("a[href], button, input, select, [tabindex='0']")].filter((e) => e.checkVisibility({ visibilityProperty: true }) && !e.disabled);
      all.forEach((e, i) => (e.dataset.reached = String(i)));
      return all.length;
    });
    await page.evaluate(() => document.activeElement?.blur());
    const reached = new Set();
    let unseen = 0;
    for (let i = 0; i < wanted + 20; i += 1) {
      await page.keyboard.press("Tab");
      const now = await page.evaluate(() => {
        const e = document.activeElement;
        return { id: e.dataset.reached, outline: getComputedStyle(e).outlineStyle, text: e.textContent.slice(0, 30) };
      });
      if (i === 0) assert.equal(now.text, "Skip to the results");
      if (now.id !== undefined) reached.add(now.id);
      if (now.id !== undefined && now.outline === "none") unseen += 1;
    }
    assert.equal(reached.size, wanted);
    assert.equal(unseen, 0);
    await page.locator(plot("light", 0)).focus();
    await page.keyboard.press("Home");
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.evaluate(() => window.umbra.clock.at), made.plain.flown.time[1]);
    assert.match(await page.locator(plot("light", 0)).getAttribute("aria-valuetext"), /2016-09-21 20:31:02 UTC, VIS/);
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.evaluate(() => window.umbra.clock.at), made.plain.flown.time[2]);
    const levels = await page.evaluate(() => [...document.querySelectorAll("h1, h2, h3")].map((h) => Number(h.tagName[1])));
    assert.equal(levels[0], 1);
    levels.forEach((l, i) => assert.ok(i === 0 || l <= levels[i - 1] + 1));
    const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select")].filter((e) => !(e.textContent.trim() || e.ariaLabel || e.labels?.length)).length);
    assert.equal(nameless, 0);
  }));

test("light, dark, paper and a narrow screen", async () => {
  const shots = process.env.UMBRA_SHOTS;
  const shoot = (page, name) => (shots ? page.screenshot({ path: join(shots, `${name}.png`), fullPage: true }) : null);
  const paper = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  await visit("plain", async (page) => {
    assert.equal(await paper(page), "rgb(250, 250, 248)");
    await shoot(page, "light");
    await page.getByRole("button", { name: /^Colours/ }).click();
    await page.getByRole("button", { name: /^Colours/ }).click();
    assert.equal(await page.getByRole("button", { name: /^Colours/ }).textContent(), "Colours: dark");
    assert.equal(await paper(page), "rgb(17, 20, 24)");
  }, { colorScheme: "light" });
  await visit("plain", async (page) => {
    assert.equal(await paper(page), "rgb(17, 20, 24)");
    await shoot(page, "dark");
    await page.emulateMedia({ media: "print" });
    // Without a window the change of medium is only told when a picture is taken.
    await page.screenshot();
    await page.waitForTimeout(300);
    assert.equal(await paper(page), "rgb(255, 255, 255)");
    assert.equal(await page.locator(".bar-top").isVisible(), false);
    assert.equal(await page.locator(".tools").first().isVisible(), false);
    assert.equal(await page.locator("section").count(), made.plain.document.sections.length);
    assert.deepEqual(await page.evaluate(() => [...new Set(window.umbra.figure("light").plots.map((u) => u.width))]), [660]);
    await shoot(page, "print");
    await page.emulateMedia({ media: "screen" });
    const pdf = await page.pdf({ format: "A4" });
    assert.ok((pdf.toString("latin1").match(/\/Type\s*\/Page\b/g) ?? []).length >= 4);
    if (shots) writeFileSync(join(shots, "print.pdf"), pdf);
  }, { colorScheme: "dark" });
  await visit("plain", async (page) => {
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 375);
    const wide = await page.evaluate(() => [...document.querySelectorAll("main *")].filter((e) => e.getBoundingClientRect().right > 376 && !e.closest(".table-frame, .scene-view, .u-over")).map((e) => e.className));
    assert.deepEqual(wide, []);
    await shoot(page, "narrow");
  }, { viewport: { width: 375, height: 760 } });
});

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
    { kind: "sky", id: "sky", title: "Sky", time: n.f64([]), azimuth_deg: n.f64([]), elevation_deg: n.f64([]) },
    { kind: "table", id: "table", title: "Table", columns: [] },
    { kind: "sliders", id: "sliders", title: "Sliders", x, parameters: [], curves: [] },
    { kind: "scene", id: "scene", title: "Scene", quantity: "temperature" },
  ];
  const document = { format: "umbra page", version: 1, title: "Little", lead: [], sections: [{ id: "s", question: "What?", figures }, { id: "t" }], scene };
  writeFileSync(join(folder, "little.html"), pageText(document, n, folder));
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
