// A question of a book: it is answered at once, then every choice is told with its reason. What is right, and why, is data
// that was made with the page. The answers stay in this browser; without its storage they are forgotten.

const letterOf = (place) => String.fromCharCode(97 + place);

function stored(key, value) {
  try {
    if (value === undefined) {
      return JSON.parse(localStorage.getItem(key));
    }
    localStorage.setItem(key, JSON.stringify(value));
  } catch {
    // no storage, or another program's: nothing is remembered
  }
  return null;
}

// A number as a person types it.
function numberOf(text, unit) {
  const bare = text.trim().replace("\u2212", "-");
  const digits = unit !== "" && bare.endsWith(unit) ? bare.slice(0, -unit.length).trim() : bare;
  return digits === "" ? NaN : Number(digits);
}

class Quiz {
  constructor(root) {
    this.root = root;
    this.data = JSON.parse(root.querySelector("script").textContent);
    this.key = `raystep-quiz ${this.data.name}`;
    this.details = root.querySelector("details");
    this.items = [...root.querySelectorAll(":scope > ol > li")];
    this.status = made("p", { class: "raystep-verdict", role: "status" });
    this.again = button("Try again", { class: "raystep-choice" }, () => this.retry());
    this.row = made("div", { class: "raystep-choices" });
    this.build(this.data.form);
    this.details.before(this.row, this.status);
    // the keys of a field are not those of the book
    root.addEventListener("keydown", (event) => {
      if (event.target.matches("input")) {
        event.stopPropagation();
      }
    });
    root.classList.add("raystep-live");
    this.look();
    this.show(this.valid(stored(this.key)));
  }

  // Where a stepper of the page shows the step, the words lead there.
  look() {
    const { place } = this.data;
    const words = this.details.querySelector(".raystep-look");
    for (const stepper of place === undefined ? [] : steppers) {
      const step = stepper.placeOf(place);
      if (0 <= step) {
        const link = made("a", { href: `#${stepper.figure.id}` }, words.textContent);
        link.addEventListener("click", () => stepper.reveal(step));
        words.replaceChildren(link);
        return;
      }
    }
  }

  build(form) {
    const check = (does) => this.row.append(button("Check", { class: "raystep-choice" }, does));
    if (form === "one") {
      this.buttons((place) => this.give([place]));
    } else if (form === "several") {
      this.boxes = this.items.map((item) => {
        const box = made("input", { type: "checkbox" });
        item.replaceChildren(made("label", {}, box, ...item.childNodes));
        return box;
      });
      check(() => this.give(this.boxes.flatMap((box, place) => (box.checked ? [place] : []))));
    } else if (form === "order") {
      this.order = [];
      this.said = made("span", {});
      this.row.append(this.said);
      this.buttons((place) => this.put([...this.order.filter((of) => of !== place), place]));
      this.row.append(button("Clear", { class: "raystep-choice" }, () => this.put([])));
      check(() => this.give(this.order));
      this.put([]);
    } else {
      this.fields = this.data.answers.map((_, place) => {
        const name = form === "number" ? "Answer" : `[${place + 1}]`;
        const field = made("input", { type: "text", inputmode: "decimal", autocomplete: "off" });
        field.addEventListener("keydown", (event) => event.key === "Enter" && this.numbers());
        this.row.append(made("label", {}, `${name} `, field, ` ${this.data.unit ?? ""}`));
        return field;
      });
      check(() => this.numbers());
    }
    this.row.append(this.again);
  }

  buttons(does) {
    this.items.forEach((item, place) => {
      const choice = button("", { class: "raystep-choice" }, () => does(place));
      choice.append(...item.childNodes);
      item.append(choice);
    });
  }

  put(order) {
    this.order = order;
    this.said.textContent = `Order: ${order.map(letterOf).join(" ") || "none yet"}`;
  }

  numbers() {
    const given = this.fields.map((field) => numberOf(field.value, this.data.unit ?? ""));
    if (given.every(Number.isFinite)) {
      this.give(given);
    } else {
      this.status.textContent = "Give a number, such as 2.5 or 1e-3.";
    }
  }

  // What was stored may be of an older question.
  valid(given) {
    const { form, answers } = this.data;
    if (!Array.isArray(given) || !given.every(Number.isFinite)) {
      return null;
    }
    const isPlace = (place) => Number.isInteger(place) && 0 <= place && place < this.items.length;
    return (answers ? given.length === answers.length : given.every(isPlace) && (form !== "one" || given.length === 1)) ? given : null;
  }

  isRight(given) {
    const { form, right, before, answers } = this.data;
    if (answers) {
      return answers.every(([value, tolerance], place) => Math.abs(given[place] - value) <= tolerance);
    }
    const isSame = given.length === right.length && right.every((place) => given.includes(place));
    return isSame && (form !== "order" || before.every(([first, later]) => given.indexOf(first) < given.indexOf(later)));
  }

  give(given) {
    stored(this.key, given);
    this.show(given);
  }

  retry() {
    stored(this.key, null);
    this.show(null);
    this.root.querySelector("button, input").focus({ preventScroll: true });
  }

  show(given) {
    const { form, answer } = this.data;
    const isTold = given !== null;
    this.details.hidden = !isTold;
    this.details.open = isTold;
    this.again.hidden = !isTold;
    this.status.textContent = !isTold ? "" : this.isRight(given) ? `right: ${answer}` : `wrong; ${answer} is right`;
    this.items.forEach((item, place) => item.firstElementChild?.classList.toggle("raystep-chosen", isTold && given.includes(place)));
    if (form === "several") {
      this.boxes.forEach((box, place) => (box.checked = isTold && given.includes(place)));
    } else if (form === "order") {
      this.put(given ?? []);
    } else if (this.fields) {
      this.fields.forEach((field, place) => (field.value = isTold ? given[place] : ""));
    }
  }
}

function beginQuizzes() {
  for (const root of document.querySelectorAll(".raystep-quiz:not(.raystep-live)")) {
    new Quiz(root);
  }
}

if (document.readyState === "loading") {
  document.addEventListener("DOMContentLoaded", beginQuizzes);
} else {
  beginQuizzes();
}
