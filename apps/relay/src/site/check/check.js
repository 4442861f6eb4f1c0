/* /check: runs the probes, and shows each result and a summary. */
import { probes } from "./probes.js";

const words = JSON.parse(document.querySelector("#words").textContent);
const verdict = document.querySelector("#verdict");
const list = document.querySelector("#checks");
const buttons = document.querySelector(".buttons");

const MARKS = { waits: "", trying: "…", passes: "✓", blocked: "✕" };
/** Scripts cannot drive a robot without these features. The others are optional. */
const NEEDED = ["get", "post", "authorization"];

const results = new Map();

function element(name, className, text = "") {
  const created = document.createElement(name);
  created.className = className;
  created.textContent = text;
  return created;
}

const rows = new Map(
  Object.keys(probes).map((name) => {
    const row = document.createElement("li");
    const mark = element("span", "mark");
    mark.setAttribute("aria-hidden", "true");
    const advice = element("p", "advice", words[`${name}Advice`]);
    row.append(mark, element("span", "name", words[name]), element("span", "state"), advice);
    list.append(row);
    return [name, row];
  }),
);

function show(name, state) {
  const row = rows.get(name);
  row.dataset.state = state;
  row.querySelector(".mark").textContent = MARKS[state];
  row.querySelector(".state").textContent = words[state];
  row.querySelector(".advice").hidden = state !== "blocked";
}

async function run(name) {
  show(name, "trying");
  const passes = await probes[name]().catch(() => false);
  results.set(name, passes);
  show(name, passes ? "passes" : "blocked");
}

async function runAll() {
  buttons.hidden = true;
  verdict.textContent = words.running;
  for (const name of rows.keys()) show(name, "waits");
  await Promise.all([...rows.keys()].map(run));
  const works = NEEDED.every((name) => results.get(name));
  const isAll = [...results.values()].every(Boolean);
  verdict.textContent = isAll ? words.all : works ? words.https : words.none;
  buttons.hidden = false;
}

async function copy() {
  const lines = [...rows].map(([name, row]) => `${words[name]}: ${words[row.dataset.state]}`);
  const text = [location.origin, verdict.textContent, ...lines, navigator.userAgent].join("\n");
  await navigator.clipboard.writeText(text);
  document.querySelector("#copy").textContent = words.copied;
}

document.querySelector("#again").addEventListener("click", () => {
  // The buttons are hidden during a run, so the summary receives the focus.
  verdict.tabIndex = -1;
  verdict.focus();
  void runAll();
});

document.querySelector("#copy").addEventListener("click", () => void copy());

await runAll();
