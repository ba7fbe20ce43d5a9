/* Who and what a page reaches: files, keyboards, dark rooms, paper, small screens. */
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { arrayOf, made, plot, prepare, visit } from "./pages.mjs";

prepare("plain");

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
      await page.waitForTimeout(500); // Chromium lets ten files through within seconds, and drops the next
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
