// What the stepper of a book and the page of a pixel share: the words of a step, and its question.
// All words are data that was made with the page. Nothing is computed here, and a text is never markup.

// An element with its attributes and with what it holds.
function made(name, attributes, ...held) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    element.setAttribute(key, value);
  }
  element.append(...held);
  return element;
}

function button(text, attributes, does) {
  const element = made("button", { type: "button", ...attributes }, text);
  element.addEventListener("click", does);
  return element;
}

function lineOf({ tone, indent, gap, text }) {
  const style = `--indent: ${indent}`;
  return made("div", { class: `raystep-line ${tone}${gap ? " gap" : ""}`, style }, text);
}

// What a step says: its title, where it is, its lines, and what it changed.
function told(step) {
  const facts = step.facts.map((fact) => made("div", {}, fact));
  return [
    made("p", { class: "raystep-title" }, step.title),
    made("p", { class: "raystep-place" }, step.place),
    made("div", { class: "raystep-lines" }, ...step.lines.map(lineOf)),
    made("div", { class: "raystep-facts" }, ...facts),
  ];
}

// What a step asks: its subject without the verdict, and the question.
function asked(step) {
  return [
    made("p", { class: "raystep-title" }, step.subject),
    made("p", { class: "raystep-place" }, step.place),
    made("p", { class: "raystep-question" }, step.question.text),
  ];
}

// The choices of a question; `answer` is called with the place of the one that is chosen, or without any.
function choices(step, answer) {
  const buttons = step.question.choices.map((choice, place) =>
    button(choice, { class: "raystep-choice" }, () => answer(place)),
  );
  return [...buttons, button("Show the step", { class: "raystep-choice" }, () => answer())];
}

// What is said to a choice: whether it is right, and why each choice is right or wrong.
function answered({ question }, choice) {
  const reasons = question.reasons.map((reason) => made("li", {}, reason));
  return [
    made("p", { class: "raystep-verdict" }, question.verdicts[choice]),
    made("ul", { class: "raystep-reasons" }, ...reasons),
  ];
}

// The key of an event, with `Shift+` before an arrow; none where the key belongs to the browser.
function keyOf(event) {
  if (event.altKey || event.ctrlKey || event.metaKey) {
    return undefined;
  }
  return event.shiftKey && event.key.startsWith("Arrow") ? `Shift+${event.key}` : event.key;
}
