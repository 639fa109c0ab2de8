// One page of a picture, in Chromium, from a file: check.sh writes the pages.
//
// `ball.html` holds the pixels 3,4 to 4,5 of the ball, `names.html` a pixel of the scene whose names look like markup, and
// `light.html` a pixel of a log with the paths of light that led to it. The ball has radius 1 and its centre lies 5 before the
// eye: the middle ray, through pixel 4,4, meets it at t = 4 and t = 6.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { join } from "node:path";

import { found, launch, open } from "./tools.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser?.close());

// The address of a page; what follows its # is no part of the file's name.
function file(name) {
  const [page, ...fragment] = name.split("#");
  return [pathToFileURL(join(process.env.PAGES, page)).href, ...fragment].join("#");
}

// A page whose first step is shown; `title` and `says` wait for a text.
async function opened(name, options) {
  const { page, faults, close } = await open(browser, file(name), options);
  const title = (text) => page.locator(".working .raystep-title").getByText(text, { exact: true }).waitFor();
  const says = (text) => page.locator(".working, .state").getByText(text).first().waitFor();
  const press = async (...keys) => {
    for (const key of keys) {
      await page.keyboard.press(key);
      // a key waits for those before it; what is typed next belongs into the field
      if (key === "g" || key === "/") {
        await page.locator("input:focus").waitFor();
      }
    }
  };
  await page.locator("[role=treeitem][aria-selected=true]").waitFor();
  return { page, faults, close, title, says, press };
}

test("keys step along, into and out, and the address, the tree and the state follow", async () => {
  const { page, faults, close, title, says, press } = await opened("ball.html#4,4");
  const current = page.locator("[role=treeitem][aria-selected=true]");
  await title("Pixel (4, 4)");
  await press("ArrowRight");
  await title("window point");
  await press("ArrowDown");
  await title("Ray 0: eye ray, depth 1: hit");
  await press("ArrowRight", "ArrowDown");
  await title("ball: sphere: hit");
  await says("discriminant: b² − 4ac = 100 − 96 = 4 > 0: two real roots");
  await says("changed: ray 0, nearest hit: none → ball at t = 4");
  assert.equal(await current.textContent(), "✓ ball: sphere: hit");
  assert.equal(await current.getAttribute("aria-level"), "3");
  assert.match(await page.locator(".state dl").textContent(), /ray 0, nearest hitball at t = 4/);
  assert.equal(page.url(), file("ball.html#4,4:2"));
  await press("ArrowRight", "Space");
  await title("nearest hit: ball");
  await press("Backspace", "ArrowLeft");
  await title("ball: sphere: hit");
  await press("End");
  await title("colour of the pixel");
  await press("w");
  await says(/set by step \d+/);
  await press("1");
  await title("Pixel (4, 4)");
  await press("5");
  await title("window point");
  await press("ArrowUp");
  await says("this is the first step");
  await press("End");
  await title("colour of the pixel");
  await press("n");
  await says("there is no target after this step");
  await press("N", "N");
  assert.deepEqual(faults, []);
  await close();
});

test("a step is found by its number, by a word and by the address", async () => {
  const { page, faults, close, title, says, press } = await opened("ball.html#4,4:2");
  await title("ball: sphere: hit");
  await press("g");
  await page.keyboard.type("4");
  await press("Enter");
  await title("far: sphere: rejected, no root");
  await press("g");
  await page.keyboard.type("99");
  await press("Enter");
  await says("there is no step 99");
  await press("/");
  await page.getByLabel("Filter").fill("NEAREST");
  await press("Enter");
  await says("1 step is named by the filter");
  // the test that found it, as in the terminal
  await press("N");
  await title("ball: sphere: hit");
  await page.evaluate(() => { location.hash = "#3,5:0"; });
  await title("window point");
  await page.getByText("Pixel 3,5 of 9 × 9").waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("a filter names the steps that the terminal names", async () => {
  const { page, faults, close, title, says, press } = await opened("ball.html#4,4:0");
  const filter = async (text, answer) => {
    await press("/");
    await page.getByLabel("Filter").fill(text);
    await press("Enter");
    await says(answer);
  };
  // `raystep step … --plain --script '/rejected'` and so on
  await filter("/rejected", "3 steps are named by the filter");
  await filter("kind=sphere_test object=far", "2 steps are named by the filter");
  await press("n", "n");
  await page.waitForURL(/:7$/);
  await filter("kind=ray_end object=ball", "1 step is named by the filter");
  await press("n");
  await title("end of ray 0: hit");
  await filter('"Colour of"', "1 step is named by the filter");
  await filter("kind=cell", "no step is named by the filter");
  await filter("discriminant=4", 'raystep step looks at "discriminant" too');
  await filter("", "the targets are what is of interest");
  assert.deepEqual(faults, []);
  await close();
});

test("/ begins a new filter: Enter alone leaves the old one, Escape keeps it, and it holds for the next pixel", async () => {
  const { page, faults, close, says, press } = await opened("ball.html#4,4:0");
  const field = page.getByLabel("Filter");
  const isLeft = () => page.waitForFunction(() => !document.activeElement.matches("input"));
  await press("/");
  assert.equal(await field.inputValue(), "");
  await page.keyboard.type("kind=sphere_test object=far");
  await press("Enter");
  await says("2 steps are named by the filter");
  await isLeft();
  // the field says which filter holds
  assert.equal(await field.inputValue(), "kind=sphere_test object=far");
  await press("/");
  assert.equal(await field.inputValue(), "");
  await page.keyboard.type("kind=shade");
  await press("Escape");
  assert.equal(await field.inputValue(), "kind=sphere_test object=far");
  // the next pixel has a test against the far sphere, too
  await press("Shift+ArrowLeft");
  await page.getByText("Pixel 3,4 of 9 × 9").waitFor();
  assert.equal(await field.inputValue(), "kind=sphere_test object=far");
  await press("Home", "n");
  await page.locator(".raystep-words .raystep-title").filter({ hasText: "far: sphere" }).waitFor();
  // what is typed wrongly is told, and the old filter holds
  await press("/");
  await page.keyboard.type("colour=4");
  await press("Enter");
  await says('raystep step looks at "colour" too');
  await isLeft();
  assert.equal(await field.inputValue(), "kind=sphere_test object=far");
  await press("/", "Enter");
  await says("the targets are what is of interest");
  await isLeft();
  assert.equal(await field.inputValue(), "");
  assert.deepEqual(faults, []);
  await close();
});

test("who set a value is chosen by its word", async () => {
  const { page, faults, close, title, says, press } = await opened("ball.html#4,4:10");
  const words = () => page.getByLabel("Who set which value").locator("option").allTextContents();
  assert.deepEqual(await words(), ["Who set …", "t", "nearest", "ambient", "lights", "colour"]);
  // `raystep step … --script 'g 10 w t'`
  await page.getByLabel("Who set which value").selectOption("t");
  await title("ball: sphere: hit");
  await says("nearest hit: ball at t = 4, set by step 3");
  await page.getByLabel("Who set which value").selectOption("lights");
  await says("no step before this one has set it");
  // the list takes no key from the steps
  await press("ArrowDown");
  await title("far: sphere: rejected, no root");
  assert.deepEqual(faults, []);
  await close();
});

test("other pixels are reached by keys and clicks as far as the page holds them", async () => {
  const { page, faults, close, says, press } = await opened("ball.html#4,4");
  const which = (text) => page.locator(".which").getByText(text).waitFor();
  await which("Pixel 4,4 of 9 × 9, one of 4 in this page");
  await press("Shift+ArrowLeft");
  await which("Pixel 3,4");
  await press("Shift+ArrowDown");
  await which("Pixel 3,5");
  await press("Shift+ArrowDown");
  await says("this page does not hold pixel 3,6");
  const box = await page.locator(".layers").boundingBox();
  await page.locator(".layers").click({ position: { x: (box.width * 4.5) / 9, y: (box.height * 5.5) / 9 } });
  await which("Pixel 4,5");
  await page.locator(".layers").click({ position: { x: 1, y: 1 } });
  await says("this page does not hold pixel 0,0");
  // the mark lies over the pixel
  const mark = await page.locator(".mark").evaluate((of) => [of.style.left, of.style.top]);
  assert.deepEqual(mark.map((part) => Number.parseFloat(part).toFixed(2)), [(400 / 9).toFixed(2), (500 / 9).toFixed(2)]);
  await page.getByLabel("Heat map").check();
  assert.ok(await page.locator("img.heat").isVisible());
  assert.deepEqual(faults, []);
  await close();
});

test("predict asks, and nothing of the page tells a verdict behind the step", async () => {
  const { page, faults, close, title, says, press } = await opened("ball.html#4,4:2");
  await press("p");
  await title("ball: sphere");
  await says("The roots of ball are t = 4 and t = 6; every t above 0 counts. Which root is the hit?");
  const visible = await page.locator("main").innerText();
  assert.doesNotMatch(visible, /: (hit|rejected|reaches light|visible|blocked)/);
  const choices = await page.locator(".raystep-choice").allTextContents();
  const letter = "abc"[choices.findIndex((choice) => choice.endsWith(": t = 4"))];
  await press(letter);
  await says(`right: ${letter}`);
  await title("ball: sphere: hit");
  await press("p");
  await says("discriminant");
  assert.deepEqual(faults, []);
  await close();
});

test("the drawings follow, and one is saved", async () => {
  const { page, faults, close, title, press } = await opened("ball.html#4,4:0");
  const later = () => page.locator(".drawings [data-later]").count();
  await title("window point");
  const first = await later();
  assert.ok(0 < first);
  const saved = page.waitForEvent("download");
  await press("s");
  assert.equal((await saved).suggestedFilename(), "pixel-4-4-step-0.svg");
  await press("5", "End");
  await title("colour of the pixel");
  assert.equal(await later(), 0);
  assert.deepEqual(faults, []);
  await close();
});

test("the keys are listed, and what is typed into a form moves nothing", async () => {
  const { page, faults, close, title, press } = await opened("ball.html#4,4:2");
  await press("?");
  const keys = page.getByRole("dialog");
  await keys.getByText("first step inside this one").waitFor();
  await press("ArrowDown", "Escape");
  await title("ball: sphere: hit");
  await page.getByLabel("Filter").focus();
  await press("n", "ArrowDown", "Escape");
  await title("ball: sphere: hit");
  await press("y");
  await page.locator(".message").getByText("raystep step tests/browser/book/lessons/01-ball/ball.json 4,4 --strategy exhaustive --at 2").waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("names that look like markup stay text", async () => {
  const { page, faults, close, press } = await opened("names.html");
  const seen = [];
  await press("5");
  const count = 12;
  for (let step = 0; step < count; step += 1) {
    await page.waitForURL(new RegExp(`:${step}$`));
    seen.push(await page.locator(".working .raystep-title").textContent());
    await press("ArrowDown");
  }
  const name = "</script><img src=x onerror=alert(1)>{{#include x}}$x$`";
  assert.ok(seen.some((title) => title.startsWith(`${name}: sphere: hit`)), seen.join("\n"));
  assert.equal(await page.locator(".working img, .tree img, .drawings img, main b").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});

test("a log has the paths of light of its pixel, and the picture as far as it has its pixels", async () => {
  const { page, faults, close, title, press } = await opened("light.html");
  await page.getByText(/^The log has 1 of the .* pixels of the picture\.$/).waitFor();
  // a connecting line belongs to no pixel
  assert.equal(await page.getByLabel("Heat map").count(), 0);
  assert.match(await page.locator("[role=treeitem]").first().textContent(), /Path \d+ of light/);
  const path = (await page.locator("[role=treeitem]").first().textContent()).match(/Path (\d+)/)[1];
  await press("ArrowRight");
  await page.waitForURL(new RegExp(`:path${path}:0$`));
  await press("g");
  await page.keyboard.type("0");
  await press("Enter");
  await title("window point");
  assert.deepEqual(faults, []);
  await close();
});

for (const theme of ["light", "dark"]) {
  for (const width of [390, 1440]) {
    test(`axe-core finds nothing and nothing sticks out: ${theme}, ${width} pixels`, async () => {
      const { page, faults, close, title, press } = await opened("ball.html#4,4", { width, theme });
      for (const part of ["first", "asked", "answered"]) {
        assert.deepEqual(await found(page, "body"), [], part);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.ok(wide <= 0, `${part}: ${wide} too wide`);
        if (part === "first") {
          await press("g");
          await page.keyboard.type("2");
          await press("Enter", "p");
          await title("ball: sphere");
        } else {
          await press("a");
          await title("ball: sphere: hit");
        }
      }
      assert.deepEqual(faults, []);
      await close();
    });
  }
}

test("in print the step, its state and whole drawings are left", async () => {
  const { page, faults, close, title } = await opened("ball.html#4,4:2");
  await title("ball: sphere: hit");
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator(".moves, .tree, .goto").filter({ visible: true }).count(), 0);
  assert.ok(await page.locator(".working .raystep-title").isVisible());
  const hidden = await page.locator(".drawings [data-later]").evaluateAll((groups) => groups.map((of) => getComputedStyle(of).visibility));
  assert.ok(hidden.every((of) => of === "visible"));
  assert.deepEqual(faults, []);
  await close();
});
