/* Starts Chromium with a WebGL made in software, and watches what a page does. */
import { chromium } from "playwright-core";

/** UMBRA_CHROMIUM names another browser than Debian's. */
export function launch(more = []) {
  return chromium.launch({
    executablePath: process.env.UMBRA_CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", ...more],
  });
}

/**
 * A page with what it complains of and asks for.
 * @returns {Promise<{page, trouble: string[], requests: string[]}>} `trouble`: errors, warnings and violations of the policy
 */
export async function open(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1360, height: 900 }, ...options });
  const page = await context.newPage();
  const trouble = [];
  const requests = [];
  page.on("pageerror", (e) => trouble.push(`error: ${e.message}`));
  // What Chromium says of software WebGL, and of tests that read pixels, is not the page's.
  page.on("console", (m) => ["error", "warning"].includes(m.type()) && !/GPU stall|swiftshader|SwiftShader|Multiple readback/.test(m.text()) && trouble.push(`${m.type()}: ${m.text()}`));
  page.on("request", (r) => requests.push(r.url()));
  await page.addInitScript(() => {
    window.violations = [];
    document.addEventListener("securitypolicyviolation", (e) => window.violations.push(`${e.violatedDirective} ${e.blockedURI} ${e.sample}`));
  });
  await page.goto(url);
  await page.evaluate(() => window.umbra.ready);
  await page.waitForTimeout(300);
  return { context, page, trouble, requests, violations: () => page.evaluate(() => window.violations) };
}
