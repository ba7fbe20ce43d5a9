/* What is drawn is held against the numbers that were put into the page. */
import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { arrayOf, figureOf, folder, made, prepare, sameNumbers, series, settle, visit } from "./pages.mjs";

prepare("plain");

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

test("the satellite fills its picture at the instant at which it is largest, and at none is cut off", () =>
  visit("plain", async (page) => {
    const reach = await page.evaluate(() => {
      const { view } = window.umbra.figure("satellite");
      const [width, height] = [view.canvas.clientWidth, view.canvas.clientHeight];
      const { steps } = window.umbra.clock;
      let [most, cut] = [0, 0];
      for (let k = 0; k < 12; k += 1) {
        window.umbra.clock.move(steps[Math.floor((k * (steps.length - 1)) / 11)]);
        view.draw();
        let [left, right, top, bottom] = [width, 0, height, 0];
        for (let x = 2; x < width; x += 8)
          for (let y = 2; y < height; y += 8) {
            if (view.surfaceAt(x, y) < 0) continue;
            [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
          }
        most = Math.max(most, (right - left) / width, (bottom - top) / height);
        if (left < 8 || top < 8 || right > width - 8 || bottom > height - 8) cut += 1;
      }
      return { most, cut };
    });
    assert.ok(reach.most > 0.75, `${reach.most} of the picture`);
    assert.equal(reach.cut, 0);
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

test("ranges stand between their limits, and what is beyond them is told apart", () =>
  visit("plain", async (page) => {
    const rows = await page.locator('figure[data-id="limits"] .range-row[role="listitem"]').evaluateAll((all) =>
      all.map((row) => {
        const box = (e) => e.getBoundingClientRect();
        const track = box(row.querySelector(".bar-track"));
        const at = (x) => (x - track.left) / track.width;
        const ends = (kind) => [...row.querySelectorAll(kind)].map((e) => [at(box(e).left), at(box(e).right)]);
        return { name: row.children[0].textContent, of: row.children[1].textContent, bars: ends(".range:not(.pale)"), beyond: ends(".range.beyond:not(.pale)"), limits: ends(".range-limit").map(([l]) => l) };
      }),
    );
    assert.deepEqual(rows.map((r) => [r.name, r.of]), [["battery", "hot"], ["", "cold"], ["array", "hot"]]);
    // The axis by two ends that are known, of the widest range: 190 K to 371 K.
    const [left, right] = rows[2].bars[0];
    const kelvin = (share) => 190 + ((share - left) / (right - left)) * (371 - 190);
    const near = (share, value) => assert.ok(Math.abs(kelvin(share) - value) < 0.5, `${kelvin(share)} in place of ${value}`);
    near(rows[0].bars[0][0], 285);
    near(rows[0].bars.at(-1)[1], 312);
    near(rows[0].beyond[0][0], 308);
    near(rows[1].bars[0][0], 276);
    near(rows[1].bars[0][1], 281);
    assert.equal(rows[1].beyond.length, 0);
    near(rows[0].limits[0] + 1 / 600, 273);
    assert.equal(rows[2].limits.length, 0);
  }));

test("several documents beside each other are told apart by name", () =>
  visit("plain", async (page) => {
    const names = await page.locator('figure[data-id="two"] .entry-name').allTextContents();
    assert.deepEqual(names, ["LWIR out/a", "LWIR out/b"]);
    const tints = await page.locator('figure[data-id="two"] .swatch.line').evaluateAll((s) => s.map((e) => e.style.getPropertyValue("--colour")));
    assert.notEqual(tints[0], tints[1]);
    assert.match((await page.evaluate(() => window.umbra.figure("two").csv())).split("\n")[0], /LWIR radiant intensity \(out\/a\) \[W\/sr\],LWIR radiant intensity \(out\/b\)/);
  }));
