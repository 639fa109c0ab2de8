// One page of a picture and its pixels: the picture, the tree of steps, the working, the state and the views.

// What is unpacked of a gzip in base64.
async function unpacked(part) {
  const bytes = Uint8Array.from(atob(part), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).json();
}

// Numbers that the data have as distances, each from the one before.
function sums(distances) {
  let sum = 0;
  return distances.map((by) => (sum += by));
}

// Steps from their forms and their numbers, as `forms.rs` writes them.
function stepsOf({ forms, rows }) {
  const last = [];
  return rows.map((row) => {
    const [form, ...marks] = row.split(" ");
    const numbers = [];
    for (const mark of marks) {
      const before = last[form]?.[numbers.length];
      numbers.push(mark === "" ? before : mark === "+" ? Number(before) + 1
        : mark[0] === "@" ? numbers[Number.parseInt(mark.slice(1), 36)] : mark);
    }
    last[form] = numbers;
    return JSON.parse(forms[form].map((piece, place) => piece + (numbers[place] ?? "")).join(""));
  });
}

async function headOf(part) {
  const head = await unpacked(part);
  const { sections, filter } = head;
  head.leaves = sums(head.leaves);
  head.walks = head.walks.map(sums);
  sections.forEach((section) => (section.steps = sums(section.steps)));
  for (const key of ["landing", "led"]) {
    filter[key] = filter[key].map((by, event) => head.leaves[event] + by);
  }
  for (const column of filter.columns) {
    column.of = sums(column.places).map((place) => column.values[place]);
  }
  return head;
}

// The data of a pixel, or nothing where there is none: `head`, and `part(n)`, a promise of some steps in a row. All that is
// shown of a pixel comes from here, so the data may as well be made while the page is read.
async function pixelData(x, y) {
  const element = document.querySelector(`script[data-pixel="${x},${y}"]`);
  if (element === null) {
    return undefined;
  }
  const [head, ...parts] = element.textContent.split(" ");
  const known = new Map();
  const part = (number) => {
    if (!known.has(number)) {
      known.set(number, unpacked(parts[number]).then(stepsOf));
    }
    return known.get(number);
  };
  return { head: await headOf(head), part };
}

const page = JSON.parse(document.getElementById("page").textContent);
const at = (selector) => document.querySelector(selector);
const parts = {
  tree: at(".tree"),
  words: at(".working .raystep-words"),
  choices: at(".working .raystep-choices"),
  message: at(".message"),
  state: at(".state dl"),
  stateTitle: at("#state-title"),
  drawings: at(".drawings"),
  mark: at(".mark"),
  magnifier: at(".magnifier"),
  which: at(".which"),
  heat: at("img.heat"),
  colours: at("img.colours"),
  keys: at("#keys"),
};

// So many siblings are in the tree on each side of the one that is open.
const BESIDE = 12;

// The pixels around the one in the magnifier, on each side.
const AROUND = 4;

const held = [...document.querySelectorAll("script[data-pixel]")].map((of) => of.dataset.pixel);

// Where the reader stands: a pixel, a step, and the walk of its siblings or of its level.
let data;
let here = 0;
let walk = 0;
let predicts = page.predicts;
let seen = new Set();
// the steps that a word was found in, in the order of the log; nothing if none is looked for
let targets;
// the place of each step in each walk, made when it is needed
let places = [];

async function stepOf(number) {
  const { together } = data.head;
  const some = await data.part(Math.floor(number / together));
  return some[number % together];
}

function say(text) {
  parts.message.textContent = text;
}

const asks = (number, step) => predicts && step.question !== undefined && !seen.has(number);

// The place of a step in a walk.
function placeIn(steps, grain, number) {
  places[grain] ??= new Map(steps.map((step, place) => [step, place]));
  return places[grain].get(number);
}

// ---- moves: each is looked up in a table of the step or in a walk

async function along(by) {
  const steps = data.head.walks[walk];
  const place = placeIn(steps, walk, here) + by;
  return place < 0 || steps.length <= place ? undefined : [steps[place], walk];
}

async function jump(number) {
  return number === undefined ? undefined : [number, (await stepOf(number)).grain];
}

function page10(by) {
  const steps = data.head.walks[walk];
  const place = placeIn(steps, walk, here);
  const to = Math.max(0, Math.min(steps.length - 1, place + 10 * by));
  return to === place ? undefined : [steps[to], walk];
}

async function target(by) {
  const step = await stepOf(here);
  if (targets === undefined) {
    return jump(0 < by ? step.target : step.targetBack);
  }
  // a step comes before those that it holds
  const before = (a, b) => a.events[0] - b.events[0] || b.events[1] - a.events[1];
  const found = 0 < by
    ? targets.find((of) => 0 < before(of, step))
    : targets.findLast((of) => before(of, step) < 0);
  return jump(found?.number);
}

async function go(to, none) {
  if (to === undefined) {
    say(none);
    return;
  }
  [here, walk] = to;
  say("");
  await show();
}

const moves = {
  over: async () => go(await along(1), "this is the last step"),
  back: async () => go(await along(-1), "this is the first step"),
  into: async () => go(await jump((await stepOf(here)).into), "this is a single event: nothing is inside"),
  out: async () => go(await jump((await stepOf(here)).out), "nothing is around this step"),
  leaf: async () => go(await jump((await stepOf(here)).leaf), "this is the last step"),
  leafBack: async () => go(await jump((await stepOf(here)).leafBack), "this is the first step"),
  target: async () => go(await target(1), "there is no target after this step"),
  targetBack: async () => go(await target(-1), "there is no target before this step"),
  first: () => go([data.head.walks[walk][0], walk]),
  last: () => go([data.head.walks[walk].at(-1), walk]),
  pageOn: () => go(page10(1), "this is the last step"),
  pageBack: () => go(page10(-1), "this is the first step"),
  level: async (number) => go((await stepOf(here)).levels[number]),
  who: async () => {
    const { who } = await stepOf(here);
    if (who === undefined) {
      say("no step before this one has set it");
      return;
    }
    await go(await jump(who[0]));
    say(who[1]);
  },
};

// Who set a value that a word names, on the innermost ray that has it.
async function whoSet(word) {
  const [, names] = data.head.asked.find(([known]) => known === word);
  const { known, open } = stateAfter((await stepOf(here)).events[0]);
  for (const ray of [...open.toReversed(), undefined]) {
    const held = names.map((name) => known.get(`${ray} ${name}`)).filter((of) => of !== undefined);
    if (0 < held.length) {
      const { name, value, event } = held.reduce((a, b) => (b.event < a.event ? a : b));
      await go(await jump(data.head.filter.landing[event]));
      say(`${name}: ${value}, set by step ${addressOf(event)}`);
      return;
    }
  }
  say("no step before this one has set it");
}

// ---- addresses: the step of the log, as `37`, `#80,60:37` or `#path17:37`

// The step of an address in this pixel; a message where there is none.
function stepAt(address) {
  const named = /^#?(?:(\d+,\d+):)?(path\d+:|building:)?(\d+)$/.exec(address.trim());
  if (named === null) {
    return `"${address}" is no step: give its number in the log, such as 37, #80,60:37, #path17:37 or #building:37`;
  }
  const [, pixel, section = "", step] = named;
  if (pixel !== undefined && pixel !== data.head.pixel.join(",")) {
    return `step ${address} is one of another pixel`;
  }
  const of = data.head.sections.find((known) => known.address === (section === "" ? "" : `#${section}`));
  const place = of?.steps.indexOf(Number(step)) ?? -1;
  return place < 0 ? `there is no step ${address}` : data.head.leaves[of.first + place];
}

const sectionOf = (event) => data.head.sections.findLast(({ first }) => first <= event);

function addressOf(event) {
  const { address, first, steps } = sectionOf(event);
  return `${address}${steps[event - first]}`;
}

function fragment(step) {
  return `#${data.head.pixel.join(",")}:${step.at.replace("#", "")}`;
}

// The command that steps through this pixel in a terminal, as a shell reads it.
function command(step) {
  const [before, behind] = page.command;
  const address = step.at.startsWith("#") ? `'${step.at}'` : step.at;
  return `${before} ${data.head.pixel.join(",")}${behind} --at ${address}`;
}

// ---- what is shown

// While questions are asked, no verdict is told that lies behind the step.
function showTree(chain, known) {
  const nameOf = (step) => (!predicts || step.events[1] <= known
    ? `${step.sign} ${step.title}` : `${step.question === undefined ? "·" : "?"} ${step.subject}`);
  const focused = parts.tree.contains(document.activeElement);
  const more = (depth, count, where) => (count <= 0 ? []
    : [made("div", { "aria-hidden": "true", class: "more", style: `--depth: ${depth}` }, `${count} more ${where}`)]);
  const rows = (depth) => {
    const { number: opened, siblings: [start, end], faces } = chain[depth];
    const row = ({ number, step }) => {
      const isOpen = number === opened && depth + 1 < chain.length;
      const item = made("div", {
        role: "treeitem", "aria-level": depth + 1, "aria-setsize": end - start, "aria-posinset": number - start + 1,
        "aria-selected": number === here, tabindex: number === here ? 0 : -1, style: `--depth: ${depth}`,
        ...(step.children === undefined ? {} : { "aria-expanded": isOpen }),
      }, nameOf(step));
      item.addEventListener("click", () => queue(async () => go(await jump(number))));
      return [item, ...(isOpen ? rows(depth + 1) : [])];
    };
    return [
      ...more(depth, faces[0].number - start, "above"),
      ...faces.flatMap(row),
      ...more(depth, end - 1 - faces.at(-1).number, "below"),
    ];
  };
  parts.tree.replaceChildren(...rows(0));
  const item = parts.tree.querySelector("[aria-selected=true]");
  if (focused) {
    item.focus({ preventScroll: true });
  }
  const { offsetTop, offsetHeight } = item;
  const { scrollTop, clientHeight } = parts.tree;
  if (offsetTop < scrollTop || scrollTop + clientHeight < offsetTop + offsetHeight) {
    parts.tree.scrollTop = offsetTop - clientHeight / 2;
  }
}

// The steps around the one that is shown, from the section to it, each with its siblings beside it.
async function chainTo(number) {
  const chain = [];
  for (let at = number; at !== undefined; at = (await stepOf(at)).out) {
    const { out } = await stepOf(at);
    const siblings = out === undefined ? data.head.tops : (await stepOf(out)).children;
    const faces = [];
    for (let near = Math.max(siblings[0], at - BESIDE); near < Math.min(siblings[1], at + BESIDE + 1); near += 1) {
      faces.push({ number: near, step: await stepOf(near) });
    }
    chain.unshift({ number: at, siblings, faces });
  }
  return chain;
}

// What is known after an event: the changes from the first of its section to it; of a ray that has ended nothing.
function stateAfter(events) {
  const known = new Map();
  let open = [];
  for (let event = sectionOf(Math.max(0, events - 1)).first; event < events; event += 1) {
    for (const { ray, name, value, open: rays } of data.head.changes[event]) {
      const key = `${ray} ${name}`;
      if (value === undefined) {
        known.delete(key);
      } else {
        known.set(key, { ray, name, value, event });
      }
      if (rays !== undefined) {
        open = rays;
        known.forEach((held, of) => held.ray !== undefined && !open.includes(held.ray) && known.delete(of));
      }
    }
  }
  return { known, open };
}

function showState(events, isTold) {
  const { known } = stateAfter(events);
  const rows = [...known.values()].flatMap(({ ray, name, value }) => [
    made("dt", {}, ray === undefined ? name : `ray ${ray}, ${name}`),
    made("dd", {}, value),
  ]);
  const none = (text) => [made("dt", {}, text), made("dd", {})];
  const all = rows.length === 0 ? none("nothing is known yet") : rows;
  parts.state.replaceChildren(...(isTold ? all : none("shown with the answer")));
}

function showViews(step, asking) {
  [...parts.drawings.children].forEach((figure, view) => {
    const [before, after] = step.drawn[view];
    for (const group of figure.querySelectorAll("[data-step]")) {
      group.toggleAttribute("data-later", (asking ? before : after) < Number(group.dataset.step));
    }
  });
}

async function show(choice) {
  const step = await stepOf(here);
  const asking = asks(here, step);
  const said = choice === undefined ? [] : answered(step, choice);
  parts.words.replaceChildren(...(asking ? asked(step) : [...said, ...told(step)]));
  parts.choices.replaceChildren(...(asking ? choices(step, (answer) => queue(() => give(answer))) : []));
  showTree(await chainTo(here), step.events[asking ? 0 : 1]);
  showState(step.events[1], !asking);
  showViews(step, asking);
  history.replaceState(null, "", fragment(step));
}

// Keys go on from the tree.
function toTree() {
  parts.tree.querySelector("[aria-selected=true]").focus({ preventScroll: true });
}

async function give(choice) {
  const step = await stepOf(here);
  if (!asks(here, step) || (choice !== undefined && step.question.choices.length <= choice)) {
    return;
  }
  seen.add(here);
  await show(choice);
  toTree();
}

async function predict(does) {
  predicts = does;
  seen.clear();
  say("");
  at(".predicts").checked = predicts;
  await show();
}

// The filter that holds, as it was typed; the field shows it.
let filter = "";
const findInput = at(".find input");

// The steps that a filter names, as in a terminal.
async function find(text) {
  // the stroke that the key wrote in a terminal may stand before them
  const words = text.replace(/^\//, "").match(/(?:"[^"]*"|[^\s"])+/g) ?? [];
  if (words.length === 0) {
    targets = undefined;
    filter = "";
    say("the targets are what is of interest");
    return;
  }
  const { columns, landing, led } = data.head.filter;
  const of = Object.fromEntries(columns.map((column) => [column.key, column.of]));
  const conditions = words.map((word) => {
    const [, key, value] = /^(?:([^=]*)=)?(.*)$/s.exec(word.replaceAll('"', ""));
    return { key, value: key === undefined ? value : value.replace(/^\[|\]$/g, ""), small: value.toLowerCase() };
  });
  const unknown = conditions.find(({ key }) => key !== undefined && of[key] === undefined);
  if (unknown !== undefined) {
    say(`this page looks at ${Object.keys(of).join(", ")}; raystep step looks at "${unknown.key}" too`);
    return;
  }
  const steps = [];
  for (let part = 0; part * data.head.together < data.head.count; part += 1) {
    steps.push(...await data.part(part));
  }
  const holds = (event, step, { key, value, small }) => (key === undefined
    ? columns.some((column) => column.of[event] === value) || steps[step].title.toLowerCase().includes(small)
    : of[key][event] === value);
  const kind = conditions.find(({ key }) => key === "kind");
  const found = new Set();
  data.head.leaves.forEach((_, event) => {
    const step = led[event];
    if (kind === undefined) {
      if (conditions.every((condition) => holds(event, step, condition))) {
        found.add(landing[event]);
      }
    } else if (of.kind[event] === kind.value) {
      const [first, behind] = steps[step].events;
      const own = Array.from({ length: behind - first }, (_, place) => first + place)
        .filter((other) => of.ray?.[other] === of.ray?.[event]);
      if (conditions.every((condition) => condition === kind || own.some((other) => holds(other, step, condition)))) {
        found.add(step);
      }
    }
  });
  filter = text;
  targets = [...found].map((number) => ({ number, events: steps[number].events }));
  targets.sort((a, b) => a.events[0] - b.events[0] || b.events[1] - a.events[1]);
  const many = found.size === 0 ? "no step is" : found.size === 1 ? "1 step is" : `${found.size} steps are`;
  say(`${many} named by the filter${found.size === 0 ? "" : "; n goes to the next"}`);
}

// ---- the picture

function showPixel() {
  const [x, y] = data.head.pixel;
  const [width, height] = page.size;
  const percent = (part, whole) => `${(100 * part) / whole}%`;
  Object.assign(parts.mark.style, {
    left: percent(x, width), top: percent(y, height), width: percent(1, width), height: percent(1, height),
  });
  const across = 2 * AROUND + 1;
  const shown = parts.heat !== null && !parts.heat.hidden ? parts.heat : parts.colours;
  parts.magnifier.setAttribute("aria-label", `Pixel ${x},${y} and the pixels around it`);
  const picture = shown === null ? [] : [made("img", {
    alt: "", src: shown.src,
    style: `width: ${percent(width, across)}; height: ${percent(height, across)}; left: ${percent(AROUND - x, across)}; top: ${percent(AROUND - y, across)}`,
  })];
  parts.magnifier.replaceChildren(...picture, made("span", {}));
  const many = held.length === 1 ? "" : `, one of ${held.length} in this page`;
  parts.which.textContent = `Pixel ${x},${y} of ${width} × ${height}${many}`;
}

async function toPixel(x, y, address) {
  const next = await pixelData(x, y);
  if (next === undefined) {
    const [width, height] = page.size;
    const inside = 0 <= x && 0 <= y && x < width && y < height;
    say(inside ? `this page does not hold pixel ${x},${y}` : "the picture ends here");
    return;
  }
  data = next;
  seen = new Set();
  places = [];
  targets = undefined;
  // as in a terminal, the filter stays from pixel to pixel
  if (filter !== "") {
    await find(filter);
  }
  parts.drawings.replaceChildren(...data.head.views.map(({ title, svg }) => {
    const figure = made("figure", { tabindex: 0, "aria-label": title }, made("figcaption", {}, title));
    // made by the program, with every name in it as text
    figure.insertAdjacentHTML("afterbegin", svg);
    return figure;
  }));
  whoList.replaceChildren(new Option("Who set …", ""), ...data.head.asked.map(([word]) => new Option(word)));
  showPixel();
  const step = address === undefined ? undefined : stepAt(address);
  await go(await jump(typeof step === "number" ? step : data.head.tops[0]));
  if (typeof step === "string") {
    say(step);
  }
}

function beside(dx, dy) {
  const [x, y] = data.head.pixel;
  return toPixel(x + dx, y + dy);
}

// Saves the first view up to the step.
async function save() {
  const drawing = parts.drawings.querySelector("svg")?.cloneNode(true);
  if (drawing === undefined) {
    say("there is no drawing of this pixel");
    return;
  }
  drawing.querySelectorAll("[data-later]").forEach((group) => group.remove());
  const file = URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(drawing)], { type: "image/svg+xml" }));
  const name = `pixel-${data.head.pixel.join("-")}-step-${(await stepOf(here)).at.replace(/\W/g, "")}.svg`;
  made("a", { href: file, download: name }).click();
  URL.revokeObjectURL(file);
  say(`saved as ${name}`);
}

async function copy() {
  const text = command(await stepOf(here));
  const copied = await navigator.clipboard?.writeText(text).then(() => true, () => false);
  say(copied ? `copied: ${text}` : text);
}

// ---- keys

const KEYS = {
  ArrowDown: moves.over,
  ArrowUp: moves.back,
  ArrowRight: moves.into,
  ArrowLeft: moves.out,
  " ": moves.leaf,
  Backspace: moves.leafBack,
  n: moves.target,
  N: moves.targetBack,
  "/": () => {
    findInput.value = "";
    findInput.focus();
  },
  w: moves.who,
  W: () => whoList.focus(),
  g: () => at(".goto input").select(),
  Home: moves.first,
  End: moves.last,
  PageDown: moves.pageOn,
  PageUp: moves.pageBack,
  1: () => moves.level(0),
  2: () => moves.level(1),
  3: () => moves.level(2),
  4: () => moves.level(3),
  5: () => moves.level(4),
  x: () => say("another strategy needs a page of its own: raystep inspect … --strategy hierarchy -o other.html"),
  "Shift+ArrowRight": () => beside(1, 0),
  "Shift+ArrowLeft": () => beside(-1, 0),
  "Shift+ArrowDown": () => beside(0, 1),
  "Shift+ArrowUp": () => beside(0, -1),
  p: () => predict(!predicts),
  a: () => give(0),
  b: () => give(1),
  c: () => give(2),
  d: () => give(3),
  Escape: () => give(),
  v: () => parts.stateTitle.focus(),
  s: save,
  y: copy,
  "?": () => parts.keys.showModal(),
};

// One after the other: what a key does may wait for data.
let last = Promise.resolve();
function queue(does) {
  last = last.then(() => does()).catch((error) => say(String(error)));
  return last;
}

document.addEventListener("keydown", (event) => {
  const { target } = event;
  const types = target.matches("input:not([type=checkbox]), select");
  const presses = target.matches("button, input, summary, a") && [" ", "Enter"].includes(event.key);
  const does = KEYS[keyOf(event)];
  if (does === undefined || types || presses || parts.keys.open) {
    if (types && event.key === "Escape") {
      target.blur();
    }
    return;
  }
  event.preventDefault();
  queue(does);
});

// ---- buttons and forms

const labels = [
  ["↑ Back", moves.back], ["↓ Over", moves.over], ["← Out", moves.out], ["→ Into", moves.into],
  ["Next event", moves.leaf], ["Next target", moves.target], ["Who set it", moves.who],
];
const box = made("input", { type: "checkbox", class: "predicts" });
box.checked = predicts;
box.addEventListener("change", () => queue(() => predict(box.checked)));
const whoList = made("select", { "aria-label": "Who set which value" });
whoList.addEventListener("change", () => {
  const word = whoList.value;
  whoList.value = "";
  queue(() => whoSet(word).then(toTree));
});
at(".moves").append(
  ...labels.map(([text, does]) => button(text, { class: "raystep-move" }, () => queue(does))),
  whoList,
  button("? Keys", { class: "raystep-move" }, () => parts.keys.showModal()),
  made("label", {}, box, " Predict"),
);

at(".goto").addEventListener("submit", (event) => {
  event.preventDefault();
  const address = new FormData(event.target).get("to");
  queue(async () => {
    const step = stepAt(address);
    await (typeof step === "number" ? go(await jump(step)) : say(step));
    toTree();
  });
});

at(".find").addEventListener("submit", (event) => {
  event.preventDefault();
  queue(async () => {
    await find(findInput.value);
    toTree();
  });
});
// what is left without Enter is not the filter
findInput.addEventListener("blur", () => {
  findInput.value = filter;
});

at(".layers").addEventListener("click", (event) => {
  const { left, top, width, height } = at(".layers").getBoundingClientRect();
  const [columns, rows] = page.size;
  const x = Math.floor(((event.clientX - left) / width) * columns);
  const y = Math.floor(((event.clientY - top) / height) * rows);
  queue(() => toPixel(x, y));
});

at(".heat-on")?.addEventListener("change", (event) => {
  parts.heat.hidden = !event.target.checked;
  showPixel();
});

// ---- the beginning: the step of the fragment, or the one that the page was made for

function fromFragment() {
  const named = /^#(\d+),(\d+)(?::(.+))?$/.exec(decodeURIComponent(location.hash));
  return named === null ? undefined : [Number(named[1]), Number(named[2]), named[3]];
}

window.addEventListener("hashchange", () => {
  const to = fromFragment();
  if (to !== undefined) {
    queue(() => toPixel(...to));
  }
});
queue(async () => {
  const [x, y] = held[0].split(",").map(Number);
  const to = fromFragment();
  if (to !== undefined && held.includes(`${to[0]},${to[1]}`)) {
    await toPixel(...to);
  } else {
    await toPixel(x, y, page.at ?? undefined);
  }
});
