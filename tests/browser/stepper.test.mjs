// The stepper of a book, in Chromium: the book is built by check.sh.
//
// The ball has radius 1 and its centre lies 5 before the eye: the middle ray meets it at t = 4 and t = 6.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { found, launch, open, serve } from "./tools.mjs";

let browser;
let server;
before(async () => {
  server = await serve(process.env.BOOK);
  browser = await launch();
});
after(async () => {
  await browser?.close();
  server?.close();
});

const at = (file) => `${server.address}/${file}`;

// A stepper of a page by its place, and what it shows. Waiting for a text fails by itself if it does not come.
function stepper(page, place) {
  const figure = page.locator(".raystep-stepper").nth(place);
  const title = figure.locator(".raystep-panel .raystep-title");
  return {
    figure,
    range: figure.locator("input[type=range]"),
    button: (name) => figure.getByRole("button", { name, exact: true }),
    title: async (text) => title.filter({ hasText: new RegExp(`^${text}$`) }).waitFor(),
    says: async (text) => figure.locator(".raystep-panel").getByText(text).first().waitFor(),
    later: () => figure.locator("svg [data-later]").count(),
  };
}

test("keys and buttons step, and the drawing follows", async () => {
  const { page, faults, close } = await open(browser, at("steps.html"));
  const { range, button, title, says, later, figure } = stepper(page, 0);
  await title("window point");
  const first = await later();
  assert.ok(0 < first, "the drawing is whole at the first step");
  await range.focus();
  await page.keyboard.press("ArrowRight");
  await title("start of ray 0");
  await page.keyboard.press("ArrowDown");
  await title("ball: sphere: hit");
  await says("discriminant: b² − 4ac = 100 − 96 = 4 > 0: two real roots");
  await says("changed: ray 0, nearest hit: none → ball at t = 4");
  assert.ok((await later()) < first, "the drawing has nothing new");
  assert.equal(await range.getAttribute("aria-valuetext"), "✓ ball: sphere: hit");
  await page.keyboard.press("ArrowLeft");
  await title("start of ray 0");
  await page.keyboard.press("End");
  await title("colour of the pixel");
  assert.equal(await later(), 0);
  await page.keyboard.press("Home");
  await title("window point");
  await button("Next").click();
  await title("start of ray 0");
  await button("Last").click();
  await title("colour of the pixel");
  // the button at the end keeps the focus, and with it the keys
  assert.equal(await button("Last").getAttribute("aria-disabled"), "true");
  await page.keyboard.press("ArrowUp");
  await button("Previous").click();
  await button("First").click();
  await title("window point");
  await range.fill("2");
  await title("ball: sphere: hit");
  assert.equal(await figure.locator("[aria-live=polite] .raystep-title").textContent(), "ball: sphere: hit");
  assert.deepEqual(faults, []);
  await close();
});

test("the list goes to a step and is told which one is shown", async () => {
  const { page, faults, close } = await open(browser, at("steps.html"));
  const { figure, title, button } = stepper(page, 0);
  const items = figure.locator(".raystep-item");
  assert.equal(await items.first().isVisible(), false);
  const count = await items.count();
  await button(`All ${count} steps`).click();
  assert.equal(await button(`All ${count} steps`).getAttribute("aria-expanded"), "true");
  await figure.getByRole("button", { name: "✗ far: sphere: rejected, no root" }).first().click();
  await title("far: sphere: rejected, no root");
  const current = figure.locator(".raystep-item[aria-current=step]");
  assert.deepEqual(await current.allTextContents(), ["✗ far: sphere: rejected, no root"]);
  assert.deepEqual(faults, []);
  await close();
});

test("predict asks before the verdict, and nothing tells it", async () => {
  const { page, faults, close } = await open(browser, at("steps.html"));
  const { figure, range, title, says, button } = stepper(page, 1);
  await says("The roots of ball are t = 4 and t = 6; every t above 0 counts. Which root is the hit?");
  await title("ball: sphere");
  const all = await figure.locator(".raystep-panel, .raystep-item").allTextContents();
  assert.doesNotMatch(all.join("\n"), /sphere: hit/);
  assert.equal(await range.getAttribute("aria-valuetext"), "? ball: sphere");
  assert.equal(await figure.locator("svg [data-step='3']:not([data-later])").count(), 0);
  const choices = await figure.locator(".raystep-choice").allTextContents();
  await range.focus();
  await page.keyboard.press("a");
  await title("ball: sphere: hit");
  const right = choices.findIndex((choice) => choice.endsWith(": t = 4"));
  const letter = "abc"[right];
  await says(letter === "a" ? "right: a" : `wrong: a; ${letter} is right`);
  await says(new RegExp(`^${letter} is right: `));
  // the answer is remembered; asked anew it can be skipped
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowLeft");
  await title("ball: sphere: hit");
  await page.keyboard.press("p");
  await page.keyboard.press("p");
  await title("ball: sphere");
  await button("Show the step").click();
  await title("ball: sphere: hit");
  // the keys are still those of the figure
  await page.keyboard.press("ArrowRight");
  await title("nearest hit: ball");
  await figure.getByLabel("Predict").uncheck();
  await page.keyboard.press("ArrowLeft");
  await title("ball: sphere: hit");
  assert.deepEqual(faults, []);
  await close();
});

test("inside the figure the arrows step and the address stays, outside they turn the page", async () => {
  const { page, faults, close } = await open(browser, at("steps.html"));
  const { figure, range, title, button } = stepper(page, 0);
  for (const focus of [
    () => range.focus(),
    () => button("Next").focus(),
    () => figure.locator("svg").click(),
    () => figure.getByLabel("Predict").focus(),
  ]) {
    await focus();
    await page.keyboard.press("Home");
    await title("window point");
    await page.keyboard.press("ArrowRight");
    await title("start of ray 0");
    await page.keyboard.press("ArrowLeft");
    await title("window point");
    await page.keyboard.press("ArrowLeft");
    await title("window point");
    assert.equal(page.url(), at("steps.html"));
  }
  await page.locator("h1").first().click();
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("ArrowRight");
  await page.waitForURL(at("names.html"));
  await page.keyboard.press("ArrowLeft");
  await page.waitForURL(at("steps.html"));
  assert.deepEqual(faults, []);
  await close();
});

test("names that look like markup stay text", async () => {
  const { page, faults, close } = await open(browser, at("names.html"));
  const { figure, range, says } = stepper(page, 0);
  await range.focus();
  const count = Number(await range.getAttribute("max")) + 1;
  const seen = [];
  for (let step = 1; step <= count; step += 1) {
    await says(`${step} of ${count}`);
    await page.keyboard.press("Escape");
    seen.push(await figure.locator(".raystep-panel .raystep-title").textContent());
    await page.keyboard.press("ArrowRight");
  }
  const name = "</script><img src=x onerror=alert(1)>{{#include x}}$x$`";
  assert.ok(seen.some((title) => title.startsWith(`${name}: sphere: hit`)), seen.join("\n"));
  assert.ok(seen.some((title) => title.includes("<!-- <script>alert(2)</script>")), seen.join("\n"));
  assert.ok(seen.some((title) => title.startsWith("&lt;b&gt;")), seen.join("\n"));
  assert.equal(await page.locator("main img, main b").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});

// Does anything stick out of the page, or lie under another thing of the same stepper?
async function sticksOut(page) {
  return page.evaluate(() => {
    const wide = document.documentElement.scrollWidth - document.documentElement.clientWidth;
    const parts = [...document.querySelectorAll(".raystep-panel *, .raystep-list *")].filter((part) => part.checkVisibility());
    const out = parts.filter((part) => {
      const { left, right } = part.getBoundingClientRect();
      return left < 0 || document.documentElement.clientWidth < right;
    });
    return [...(0 < wide ? [`the page is ${wide} too wide`] : []), ...out.map((part) => part.outerHTML.slice(0, 100))];
  });
}

for (const theme of ["light", "rust", "coal", "navy", "ayu"]) {
  for (const width of [390, 1440]) {
    test(`axe-core finds nothing and nothing sticks out: ${theme}, ${width} pixels`, async () => {
      const { page, faults, close } = await open(browser, at("steps.html"), { width, theme });
      assert.ok(await page.evaluate((theme) => document.documentElement.classList.contains(theme), theme));
      const parts = ["first", "second"];
      for (const part of parts) {
        assert.deepEqual(await found(page, "main"), [], part);
        assert.deepEqual(await sticksOut(page), [], part);
        // open lists, another step
        for (const toggle of await page.locator(".raystep-toggle").all()) {
          if ((await toggle.getAttribute("aria-expanded")) === "false") {
            await toggle.click();
          }
        }
        const { range, title } = stepper(page, 0);
        await range.fill("2");
        await title("ball: sphere: hit");
      }
      assert.deepEqual(faults, []);
      await close();
    });
  }
}

test("without its script the figure is whole and the list says all", async () => {
  const { page, close } = await open(browser, at("steps.html"), { script: false });
  const figure = page.locator(".raystep-stepper").first();
  assert.equal(await page.locator(".raystep-panel, .raystep-stepper button, .raystep-stepper input").count(), 0);
  for (const group of await figure.locator("svg [data-step]").all()) {
    assert.equal(await group.evaluate((of) => getComputedStyle(of).visibility), "visible");
  }
  const list = figure.locator(".raystep-list > li");
  assert.ok(await list.filter({ hasText: "100 − 96 = 4 > 0: two real roots" }).first().isVisible());
  await figure.getByText(`All ${await list.count()} steps`).waitFor();
  await close();
});

test("in print the figure is whole and the list says all, on the page of all chapters too", async () => {
  for (const file of ["steps.html", "print.html"]) {
    const { page, faults, close } = await open(browser, at(file));
    await page.locator(".raystep-live").nth(2).waitFor();
    assert.ok(0 < (await page.locator("svg [data-later]").count()), file);
    await page.emulateMedia({ media: "print" });
    for (const group of await page.locator("svg [data-later]").all()) {
      assert.equal(await group.evaluate((of) => getComputedStyle(of).visibility), "visible", file);
    }
    const figure = page.locator(".raystep-stepper").first();
    assert.ok(await figure.getByText("100 − 96 = 4 > 0: two real roots").last().isVisible(), file);
    assert.equal(await page.locator(".raystep-panel").first().isVisible(), false, file);
    assert.equal(await page.locator(".raystep-toggle").first().isVisible(), false, file);
    assert.deepEqual(faults, [], file);
    await close();
  }
});

test("every stepper of the page of all chapters works", async () => {
  const { page, faults, close } = await open(browser, at("print.html"));
  await page.locator(".raystep-live").nth(6).waitFor();
  assert.equal(await page.locator(".raystep-panel").count(), 7);
  const { range, title } = stepper(page, 0);
  await range.fill("2");
  await title("ball: sphere: hit");
  assert.deepEqual(faults, []);
  await close();
});
