/* Made-up pages in Chromium, for the tests of the viewer: built, opened, watched, and taken away again. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { launch, open } from "./browser.mjs";
import { pageText } from "./page.mjs";
import { synthetic } from "./synthetic.mjs";

/** Where the viewer and the pages of a test file are. */
export let folder;
export let browser;
/** What was made, by the name of the page: document, numbers, flight. */
export const made = {};

/** The pages that are made: options of the document, and of the file. */
const PAGES = { plain: [{ sets: true }], hostile: [{ hostile: true }], serve: [{ serve: true }, { connect: true }] };

/** Writes a page into the folder. */
export function write(name, document, numbers, more) {
  writeFileSync(join(folder, `${name}.html`), pageText(document, numbers, folder, more));
}

/** Builds the viewer and these pages before the tests of a file, and takes them away behind. */
export function prepare(...names) {
  before(async () => {
    folder = mkdtempSync(join(tmpdir(), "umbra-viewer-"));
    execFileSync(process.execPath, [fileURLToPath(new URL("../build.mjs", import.meta.url)), folder]);
    for (const name of names) {
      made[name] = synthetic(PAGES[name][0]);
      write(name, made[name].document, made[name].numbers, PAGES[name][1]);
    }
    browser = await launch();
  });
  after(async () => {
    await browser?.close();
    if (folder) rmSync(folder, { recursive: true, force: true });
  });
}

export const url = (name) => pathToFileURL(join(folder, `${name}.html`)).href;

/** A fresh view of a page; after `f` nothing may have gone wrong in it. */
export async function visit(name, f, options) {
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

export const figureOf = (doc, id) => doc.sections.flatMap((s) => s.figures).find((f) => f.id === id);
export const series = (page, id) => page.evaluate((i) => window.umbra.figure(i).series(), id);
/** Numbers as they were put into the page. */
export const arrayOf = (index, name = "plain") => made[name].numbers.values[index];
export const plot = (id, panel = 0) => `figure[data-id="${id}"] .panel:nth-of-type(${panel + 1}) .plot`;
export const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

export function sameNumbers(drawn, wanted, what) {
  assert.equal(drawn.length, wanted.length, what);
  wanted.forEach((v, i) => {
    const d = drawn[i] ?? NaN;
    if (!(Number.isNaN(v ?? NaN) && Number.isNaN(d)) && d !== v) assert.fail(`${what}: sample ${i} is ${d}, not ${v}`);
  });
}
