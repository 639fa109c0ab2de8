// The stepper of a book: a figure that is drawn up to a step, the step's words, and the list of all steps.

class Stepper {
  constructor(figure) {
    this.figure = figure;
    const { steps, until } = JSON.parse(figure.querySelector("script").textContent);
    this.steps = steps;
    this.until = until;
    this.groups = [...figure.querySelectorAll("svg [data-step]")];
    this.predicts = figure.hasAttribute("data-predict");
    // the steps whose question was answered or skipped
    this.seen = new Set();
    this.build();
    figure.addEventListener("keydown", (event) => this.key(event));
    this.go(0);
  }

  build() {
    const last = this.steps.length - 1;
    const move = (text, to) => button(text, { class: "raystep-move" }, () => this.go(to()));
    this.moves = [
      move("First", () => 0),
      move("Previous", () => this.here - 1),
      move("Next", () => this.here + 1),
      move("Last", () => last),
    ];
    this.range = made("input", { type: "range", min: 0, max: last, step: 1, "aria-label": "Step" });
    this.range.addEventListener("input", () => this.go(Number(this.range.value)));
    this.count = made("span", { class: "raystep-count" });
    this.box = made("input", { type: "checkbox" });
    this.box.checked = this.predicts;
    this.box.addEventListener("change", () => this.predict(this.box.checked));
    this.words = made("div", { class: "raystep-words", role: "status", "aria-live": "polite", "aria-atomic": "true" });
    this.choices = made("div", { class: "raystep-choices", role: "group", "aria-label": "Answers" });
    const moves = made("div", { class: "raystep-moves", role: "group", "aria-label": "Moves" }, ...this.moves);
    const along = made("div", { class: "raystep-along" }, this.range, this.count);
    const panel = made("div", { class: "raystep-panel" }, along, moves, this.words, this.choices);
    if (this.steps.some((step) => step.question)) {
      moves.append(made("label", { class: "raystep-predict" }, this.box, "Predict"));
    }
    this.figure.querySelector("svg").after(panel);
    this.buildList();
    // a click on the drawing gives the figure the keys
    this.figure.tabIndex = -1;
    this.figure.classList.add("raystep-live");
  }

  // The list folds behind its heading; in print it is whole.
  buildList() {
    const list = this.figure.querySelector(".raystep-list");
    const heading = this.figure.querySelector(".raystep-heading");
    const toggle = button(heading.textContent, { class: "raystep-toggle", "aria-expanded": "false" }, () => {
      const open = list.classList.toggle("raystep-folded") === false;
      toggle.setAttribute("aria-expanded", String(open));
    });
    list.classList.add("raystep-folded");
    heading.before(toggle);
    this.items = [...list.children].map((item, place) => {
      const name = button("", { class: "raystep-item" }, () => this.go(place));
      item.prepend(name);
      return name;
    });
  }

  // Does the step wait for an answer?
  asks(place) {
    return this.predicts && this.steps[place].question !== undefined && !this.seen.has(place);
  }

  // While questions are asked, no verdict is told that lies behind the step.
  name(place) {
    const { sign, title, subject, question } = this.steps[place];
    const isTold = !this.predicts || place < this.here || (place === this.here && !this.asks(place));
    return isTold ? `${sign} ${title}` : `${question === undefined ? "·" : "?"} ${subject}`;
  }

  go(place) {
    if (place < 0 || this.steps.length <= place) {
      return;
    }
    this.here = place;
    this.show();
  }

  show(choice) {
    const step = this.steps[this.here];
    const asks = this.asks(this.here);
    const [before, after] = step.drawn[0];
    for (const group of this.groups) {
      group.toggleAttribute("data-later", Number(group.dataset.step) > (asks ? before : after));
    }
    const said = choice === undefined ? [] : answered(step, choice);
    this.words.replaceChildren(...(asks ? asked(step) : [...said, ...told(step)]));
    this.choices.replaceChildren(...(asks ? choices(step, (answer) => this.answer(answer)) : []));
    this.range.value = this.here;
    this.range.setAttribute("aria-valuetext", this.name(this.here));
    this.count.textContent = `${this.here + 1} of ${this.steps.length}`;
    const ends = [this.here === 0, this.here === this.steps.length - 1];
    this.moves.forEach((move, place) => move.setAttribute("aria-disabled", ends[place < 2 ? 0 : 1]));
    this.items.forEach((item, place) => {
      item.textContent = this.name(place);
      if (place === this.here) {
        item.setAttribute("aria-current", "step");
      } else {
        item.removeAttribute("aria-current");
      }
    });
  }

  // The place that holds a step of a trace, if this is a stepper of that trace.
  placeOf({ trace, step }) {
    const isShown = this.until?.trace === trace && step <= this.until.step;
    return isShown ? this.steps.findLastIndex(({ at }) => Number(at) <= step) : -1;
  }

  // Shows a step with its verdict; the keys are those of the figure.
  reveal(place) {
    this.seen.add(place);
    this.go(place);
    this.range.focus({ preventScroll: true });
  }

  answer(choice) {
    if (!this.asks(this.here) || (choice !== undefined && this.steps[this.here].question.choices.length <= choice)) {
      return;
    }
    // its buttons go, and the keys stay in the figure
    this.range.focus({ preventScroll: true });
    this.seen.add(this.here);
    this.show(choice);
  }

  predict(asks) {
    this.predicts = asks;
    this.box.checked = asks;
    this.seen.clear();
    this.show();
  }

  // The keys are those of every stepper. What it takes does not reach the page, which would be turned by the arrows.
  key(event) {
    const last = this.steps.length - 1;
    const far = (place) => Math.max(0, Math.min(last, place));
    const does = {
      ArrowDown: () => this.go(this.here + 1),
      ArrowRight: () => this.go(this.here + 1),
      ArrowUp: () => this.go(this.here - 1),
      ArrowLeft: () => this.go(this.here - 1),
      Home: () => this.go(0),
      End: () => this.go(last),
      PageDown: () => this.go(far(this.here + 10)),
      PageUp: () => this.go(far(this.here - 10)),
      p: () => this.predict(!this.predicts),
      a: () => this.answer(0),
      b: () => this.answer(1),
      c: () => this.answer(2),
      d: () => this.answer(3),
      Escape: () => this.answer(),
    }[keyOf(event)];
    if (does !== undefined) {
      event.preventDefault();
      event.stopPropagation();
      does();
    }
  }
}

// A page may hold several chapters, each with this script.
const steppers = [];
function begin() {
  for (const figure of document.querySelectorAll(".raystep-stepper:not(.raystep-live)")) {
    steppers.push(new Stepper(figure));
  }
}

if (document.readyState === "loading") {
  document.addEventListener("DOMContentLoaded", begin);
} else {
  begin();
}
