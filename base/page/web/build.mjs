/* Bundles src/ into viewer.js and viewer.css, and writes their SHA-256 for the page's
 * Content-Security-Policy.
 *
 *   node build.mjs [FOLDER]     FOLDER: where the three files go (default: dist beside this file)
 *
 * viewer.sha256 has two lines, base64: that of viewer.js, that of viewer.css. They hold for the files'
 * bytes between <script> and </script>, <style> and </style>, with nothing added, not even a line end. */
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const folder = resolve(process.argv[2] ?? join(here, "dist"));
const LARGEST = 700e3;

/** Licenses travel with the code that they are of. */
const license = (name) => readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim().replaceAll("*/", "* /").replaceAll("\u00a9", "(c)");
const notice = `/* Umbra page viewer, GPL-3.0-or-later. It contains three.js and uPlot.\n\nthree.js: ${license("three")}\n\nuPlot: ${license("uplot")}\n*/`;

const result = await build({
  absWorkingDir: here,
  entryPoints: { viewer: "src/main.js" },
  outdir: folder,
  bundle: true,
  minify: true,
  format: "iife",
  target: ["chrome100", "firefox113", "safari16.4"],
  charset: "ascii",
  legalComments: "none",
  banner: { js: notice },
  logLevel: "warning",
  write: false,
});

const text = (name) => {
  const file = result.outputFiles.find((f) => f.path.endsWith(name));
  if (!file) throw new Error(`the bundle has no ${name}`);
  const content = file.text.trim();
  // Either would end the element that holds the text, or change how it is read.
  for (const bad of ["</script", "</style", "<!--"])
    if (content.toLowerCase().includes(bad)) throw new Error(`${name} contains ${bad}`);
  return content;
};
const hash = (content) => createHash("sha256").update(content, "utf8").digest("base64");

const js = text("viewer.js");
const css = text("viewer.css");
if (js.length + css.length > LARGEST)
  throw new Error(`viewer.js and viewer.css have ${js.length + css.length} bytes, at most ${LARGEST} are wanted`);
mkdirSync(folder, { recursive: true });
writeFileSync(join(folder, "viewer.js"), js);
writeFileSync(join(folder, "viewer.css"), css);
writeFileSync(join(folder, "viewer.sha256"), `${hash(js)}\n${hash(css)}\n`);
