// The questions of a book, in Chromium: the book is built by check.sh.
//
// The ball has radius 1 and its centre lies 5 before the eye: the middle ray meets it at t = 4 and t = 6, and its discriminant
// is 100 − 96 = 4.

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

// A question of a page by its name.
function quiz(page, name) {
  const root = page.getByRole("group", { name: `Question 01-ball/${name}`, exact: true }).first();
  return {
    root,
    button: (name) => root.getByRole("button", { name, exact: true }),
    field: () => root.getByRole("textbox"),
    says: (text) => root.getByRole("status").filter({ hasText: text }).waitFor(),
    details: root.locator("details"),
  };
}

test("a choice is answered at once, every choice is told with its reason, and one may try again", async () => {
  const { page, faults, close } = await open(browser, at("questions.html"));
  const { root, button, says, details } = quiz(page, "root");
  assert.equal(await details.isVisible(), false);
  const choices = root.locator("ol > li > button");
  const texts = await choices.allTextContents();
  const right = texts.findIndex((text) => /(^|\D)4($|\D)/.test(text));
  assert.ok(0 <= right && 2 <= texts.length, texts.join(" | "));
  const letter = "abcd"[right];
  const wrong = (right + 1) % texts.length;
  await choices.nth(wrong).click();
  await says(`wrong; ${letter} is right`);
  assert.equal(await details.locator("li").count(), texts.length);
  await details.getByText(`${letter} is right:`).waitFor();
  await details.getByText("raystep step lessons/01-ball/ball.json 4,4 --at").waitFor();
  await button("Try again").click();
  assert.equal(await details.isVisible(), false);
  await choices.nth(right).focus();
  await page.keyboard.press("Enter");
  await says(`right: ${letter}`);
  assert.deepEqual(faults, []);
  await close();
});

test("a number is typed, and the keys of its field turn no page", async () => {
  const { page, faults, close } = await open(browser, at("questions.html"));
  const { field, button, says, details } = quiz(page, "discriminant");
  await field().fill("many");
  await button("Check").click();
  await says("Give a number");
  assert.equal(await details.isVisible(), false);
  await field().fill("5");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("s");
  assert.equal(page.url(), at("questions.html"));
  await field().fill("\u22124");
  await page.keyboard.press("Enter");
  await says("wrong; 4 is right");
  await button("Try again").click();
  await field().fill("4.0");
  await page.keyboard.press("Enter");
  await says("right: 4");
  assert.deepEqual(faults, []);
  await close();
});

test("an answer stays in this browser, on each page that asks the question", async () => {
  const { page, faults, close } = await open(browser, at("questions.html"));
  const first = quiz(page, "discriminant");
  await first.field().fill("4");
  await first.button("Check").click();
  await first.says("right: 4");
  await page.reload();
  await quiz(page, "discriminant").says("right: 4");
  // what another program has written is no answer
  await page.evaluate(() => localStorage.setItem("raystep-quiz 01-ball/root", '[{"a": 99}'));
  await page.evaluate(() => localStorage.setItem("raystep-quiz 01-ball/discriminant", "[1, 2, 3]"));
  await page.reload();
  assert.equal(await quiz(page, "root").details.isVisible(), false);
  assert.equal(await quiz(page, "discriminant").details.isVisible(), false);
  assert.deepEqual(faults, []);
  await close();
});

test("without storage a question works and forgets", async () => {
  const { page, faults, close } = await open(browser, at("before.html"));
  await page.addInitScript(() => Object.defineProperty(globalThis, "localStorage", { get: () => { throw new Error("none"); } }));
  await page.goto(at("questions.html"));
  const { field, button, says } = quiz(page, "discriminant");
  await field().fill("4");
  await button("Check").click();
  await says("right: 4");
  // mdBook itself complains of what it cannot store
  assert.deepEqual(faults.filter((fault) => !fault.includes("none")), []);
  await close();
});

test("a question and its answer lead to each other", async () => {
  const { page, faults, close } = await open(browser, at("questions.html"));
  const { root, details } = quiz(page, "root");
  await root.locator("ol > li > button").first().click();
  await details.getByRole("link", { name: "All answers" }).click();
  await page.waitForURL(/answers\.html#raystep-answer-01-ball-root$/);
  const answer = page.locator("#raystep-answer-01-ball-root");
  await answer.getByRole("link").click();
  await page.waitForURL(/questions\.html#raystep-question-01-ball-root$/);
  assert.equal(await page.locator("#raystep-question-01-ball-root").count(), 1);
  assert.deepEqual(faults, []);
  await close();
});

test("a question leads to its step in a stepper of the page, and the verdict is shown there", async () => {
  const { page, faults, close } = await open(browser, at("look.html"));
  const { root, details } = quiz(page, "root");
  await root.locator("ol > li > button").first().click();
  // the command stays
  await details.getByText("raystep step lessons/01-ball/ball.json 4,4 --at").waitFor();
  await details.getByRole("link", { name: "the step" }).click();
  const steppers = page.locator(".raystep-stepper");
  const [before, other, right] = await steppers.all();
  assert.equal(await steppers.count(), 3);
  assert.equal(new URL(page.url()).hash, `#${await right.getAttribute("id")}`);
  assert.equal(await right.locator(".raystep-words[role=status] .raystep-title").textContent(), "ball: sphere: hit");
  // the stepper asks before each verdict, but not before this one
  assert.equal(await right.locator(".raystep-panel .raystep-choices button").count(), 0);
  for (const stays of [before, other]) {
    assert.match(await stays.locator(".raystep-count").textContent(), /^1 of /);
  }
  // the keys are those of the stepper
  const here = Number.parseInt(await right.locator(".raystep-count").textContent(), 10);
  await page.keyboard.press("ArrowDown");
  assert.match(await right.locator(".raystep-count").textContent(), new RegExp(`^${here + 1} of `));
  assert.deepEqual(faults, []);
  await close();
});

test("where no stepper shows the step of a question, the command alone leads to it", async () => {
  const { page, faults, close } = await open(browser, at("questions.html"));
  const { root, details } = quiz(page, "root");
  await root.locator("ol > li > button").first().click();
  await details.getByText("raystep step lessons/01-ball/ball.json 4,4 --at").waitFor();
  assert.equal(await details.locator(".raystep-look").textContent(), "the step");
  assert.equal(await details.locator(".raystep-look a").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});

test("the letter of a choice stands beside its first line", async () => {
  const { page, close } = await open(browser, at("questions.html"), { width: 390 });
  // a letter stands on the first baseline: that of a box in the line of the item
  const off = await page.evaluate(() => {
    const item = document.querySelector(".raystep-quiz > ol > li");
    const button = item.querySelector("button");
    button.textContent = "word ".repeat(30);
    const mark = document.createElement("span");
    mark.textContent = "a";
    item.prepend(mark);
    button.style.width = "auto";
    button.style.maxWidth = "80%";
    const letter = mark.getBoundingClientRect();
    const box = button.getBoundingClientRect();
    return [letter.top - box.top, letter.height, box.height];
  });
  assert.ok(off[1] * 3 < off[2], `one line: ${off}`);
  assert.ok(off[0] < off[1], `the letter is ${off[0]} below the top of its choice`);
  await close();
});

for (const theme of ["light", "rust", "coal", "navy", "ayu"]) {
  test(`axe-core finds nothing in questions and answers: ${theme}`, async () => {
    for (const width of [390, 1440]) {
      const { page, faults, close } = await open(browser, at("questions.html"), { width, theme });
      assert.deepEqual(await found(page, "main"), [], `${width}`);
      await quiz(page, "root").root.locator("ol > li > button").first().click();
      assert.deepEqual(await found(page, "main"), [], `${width}, answered`);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.equal(wide, 0, `${width}`);
      await page.goto(at("answers.html"));
      assert.deepEqual(await found(page, "main"), [], `${width}, answers`);
      assert.deepEqual(faults, []);
      await close();
    }
  });
}

test("without its script a question has its answer behind a line that opens", async () => {
  const { page, close } = await open(browser, at("questions.html"), { script: false });
  const { root, details } = quiz(page, "root");
  assert.equal(await root.locator("button, input").count(), 0);
  assert.ok(await root.locator("ol > li").first().isVisible());
  assert.equal(await details.locator("li").first().isVisible(), false);
  await details.locator("summary").click();
  assert.ok(await details.locator("li").first().isVisible());
  await close();
});

test("in print a question has its choices and no buttons to press, on the page of all chapters too", async () => {
  for (const file of ["questions.html", "print.html"]) {
    const { page, faults, close } = await open(browser, at(file));
    await page.emulateMedia({ media: "print" });
    const { root } = quiz(page, "root");
    assert.ok(await root.locator("ol > li").first().isVisible(), file);
    assert.equal(await root.locator(".raystep-choices").isVisible(), false, file);
    assert.deepEqual(faults, [], file);
    await close();
  }
});
