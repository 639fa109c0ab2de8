// What the tests share: a server of a folder on this machine, and Chromium with a page that must not complain.

import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { extname, join, normalize } from "node:path";

// the packages lie where they were installed
const require = createRequire(join(process.env.BROWSER_PACKAGES, "package.json"));
const { chromium } = require("playwright-core");
const axe = require.resolve("axe-core/axe.min.js");

const TYPES = { ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".svg": "image/svg+xml", ".png": "image/png" };

// Serves a folder to this machine alone; `address` begins each of its pages.
export async function serve(folder) {
  const server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://here").pathname));
    try {
      const content = await readFile(join(folder, path));
      response.writeHead(200, { "content-type": TYPES[extname(path)] ?? "application/octet-stream" });
      response.end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  return { address: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

export function launch() {
  const args = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
  ];
  return chromium.launch({ executablePath: process.env.CHROMIUM, args });
}

// Opens a page in a window of its own. `faults` fills with errors, messages of the console, dialogs, and requests to
// other hosts.
export async function open(browser, url, { width = 1440, theme = "light", script = true, media } = {}) {
  const context = await browser.newContext({
    viewport: { width, height: 900 },
    colorScheme: theme === "light" || theme === "rust" ? "light" : "dark",
    javaScriptEnabled: script,
  });
  const page = await context.newPage();
  const faults = [];
  const host = new URL(url).host;
  page.on("pageerror", (error) => faults.push(`error: ${error}`));
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) {
      faults.push(`console: ${message.text()}`);
    }
  });
  page.on("dialog", (dialog) => {
    faults.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  page.on("request", (request) => {
    const { protocol, host: asked } = new URL(request.url());
    if (asked !== host && !["data:", "blob:"].includes(protocol)) {
      faults.push(`request: ${request.url()}`);
    }
  });
  if (script) {
    await page.addInitScript((theme) => localStorage.setItem("mdbook-theme", theme), theme);
  }
  if (media !== undefined) {
    await page.emulateMedia({ media });
  }
  await page.goto(url);
  return { page, faults, close: () => context.close() };
}

// What axe-core finds within a part of a page, each with its elements.
export async function found(page, part) {
  await page.addScriptTag({ path: axe });
  const { violations } = await page.evaluate((part) => globalThis.axe.run(part), part);
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 200)).join(" | ")}`);
}
