/* Pictures of the synthetic page, or of a page that is given, to be looked at: light, dark, narrow, print.
 *
 *   node test/shots.mjs FOLDER [report.html]     the viewer is built first */
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { execFileSync } from "node:child_process";
import { fileURLToPath, pathToFileURL } from "node:url";
import { launch, open } from "./browser.mjs";
import { pageText } from "./page.mjs";
import { synthetic } from "./synthetic.mjs";

const folder = resolve(process.argv[2] ?? ".");
mkdirSync(folder, { recursive: true });
const temporary = mkdtempSync(join(tmpdir(), "umbra-shots-"));
try {
  let file = process.argv[3] && resolve(process.argv[3]);
  if (!file) {
    execFileSync(process.execPath, [fileURLToPath(new URL("../build.mjs", import.meta.url)), temporary]);
    const { document, numbers } = synthetic({ sets: true });
    file = join(temporary, "report.html");
    writeFileSync(file, pageText(document, numbers, temporary));
  }
  const browser = await launch();
  const url = pathToFileURL(file).href;
  for (const [name, options] of [
    ["light", { colorScheme: "light" }],
    ["dark", { colorScheme: "dark" }],
    ["narrow", { colorScheme: "light", viewport: { width: 375, height: 800 } }],
  ]) {
    const { page, context, trouble } = await open(browser, url, options);
    await page.evaluate(() => {
      const { clock } = window.umbra;
      clock.move(clock.steps[Math.round(0.6 * clock.steps.length)]);
    });
    await page.waitForTimeout(300);
    await page.screenshot({ path: join(folder, `${name}.png`), fullPage: true });
    if (trouble.length > 0) console.log(name, trouble);
    if (name === "light") await page.pdf({ path: join(folder, "print.pdf"), format: "A4", printBackground: false });
    await context.close();
  }
  await browser.close();
} finally {
  rmSync(temporary, { recursive: true, force: true });
}
