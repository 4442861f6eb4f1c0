/**
 * "Try it in other mazes": a program in 100 trees of 11 x 11, from the press of the button until the first and
 * the last result stand on the screen; beside one worker that runs the same mazes alone, and the main
 * thread's work meanwhile.
 */
import { encodeLink } from "@corridor/link";
import { mazePresets } from "@corridor/maze";
import { programPresets, type ProgramDocument } from "@corridor/program";
import type { Browser, Page } from "playwright";
import { formatNumber, type Goal } from "../core/goals.ts";
import { median } from "../core/measure.ts";
import { watchPage } from "./main-thread.ts";
import type { PageUnderTest, Section } from "./section.ts";

const ROUNDS = 5;
const WATCH_MS = 1500;
const FRAME_MS = 1000 / 60;
const SIDE = 11;
const MAZES = 100;

/** Follows the right wall, and gets to each goal; drives to and fro, and always needs the whole time. */
const programs = ["right-wall", "left-at-every-wall"] as const;

declare global {
  /** address of the worker that tries mazes, once the page has started one */
  var trialWorker: string | undefined;
}

export const otherMazes: Section = { title: "Other mazes", measure };

async function measure({ browser, url }: PageUnderTest): Promise<readonly Goal[]> {
  const firsts: number[] = [];
  const goals: Goal[] = [];
  for (const id of programs) {
    const program = programPresets.find((preset) => preset.id === id)?.program;
    if (program === undefined) throw new Error(`there is no ${id}`);
    const page = await openWith(browser, url, program);
    const times: { first: number; all: number; raw: number }[] = [];
    for (let round = 0; round <= ROUNDS; round++) {
      const { first, all } = await page.evaluate(pressAndWait, MAZES);
      const raw = await page.evaluate(runAlone, { program, side: SIDE, mazes: MAZES });
      // The first round loads the dialog and its words.
      if (round > 0) times.push({ first, all, raw });
    }
    const cores = await page.evaluate(() => navigator.hardwareConcurrency);
    firsts.push(...times.map(({ first }) => first));
    const all = median(times.map((time) => time.all));
    const raw = median(times.map((time) => time.raw));
    console.log(
      `  ${id}: first ${formatNumber(median(times.map(({ first }) => first)))} ms, all ${formatNumber(all)} ms; alone in one worker ${formatNumber(raw)} ms; ${cores} cores`,
    );
    goals.push({
      label: `${MAZES} trees with ${id}, against the raw ticks divided by the cores`,
      measured: median(times.map((time) => (time.all * cores) / time.raw)),
      bound: { atMost: 1.3 },
      unit: "times",
    });
    if (id === "left-at-every-wall") goals.push(await framesMeanwhile(browser, page));
    await page.close();
  }
  return [
    {
      label: "first of the other mazes, from the press of the button",
      measured: median(firsts),
      bound: { atMost: 150 },
      unit: "ms",
    },
    ...goals,
  ];
}

async function openWith(browser: Browser, url: string, program: ProgramDocument): Promise<Page> {
  const [preset] = mazePresets;
  if (preset === undefined) throw new Error("there are no presets");
  // A name of its own: the program is the student's.
  const link = encodeLink({ maze: preset.maze, program: { ...program, name: "Mine" } });
  if (!link.ok) throw new Error(`the maze fits no link: ${link.code}`);
  // Without a graphics chip the dialog's way in takes a whole core, and the mazes would be measured with one less.
  const viewport = { width: 1440, height: 900 };
  const page = await browser.newPage({ viewport, reducedMotion: "reduce" });
  page.setDefaultTimeout(120_000);
  await page.addInitScript(noteTrialWorker);
  await page.goto(`${url}/#${link.text}`);
  await page.getByRole("button", { name: "Try it in other mazes" }).waitFor();
  // What comes late is the first visit's.
  await page.waitForLoadState("networkidle");
  return page;
}

/** Frames whose work on the main thread was done in time while all cores try mazes. */
async function framesMeanwhile(browser: Browser, page: Page): Promise<Goal> {
  const frames: number[] = [];
  for (let round = 0; round < ROUNDS; round++) {
    const watched = watchPage(browser, page, WATCH_MS);
    await page.waitForTimeout(100);
    await page.evaluate(pressAndWait, MAZES);
    frames.push(...(await watched).mainThread);
  }
  const inTime = frames.filter((milliseconds) => milliseconds <= FRAME_MS).length;
  console.log(`  main thread: most ${Math.max(...frames).toFixed(1)} ms in a frame`);
  return {
    label: "frames whose main thread is done in time while other mazes are tried",
    measured: (100 * inTime) / frames.length,
    bound: { atLeast: 99 },
    unit: "%",
  };
}

/** Runs in the page before its own scripts. */
function noteTrialWorker(): void {
  const PlainWorker = globalThis.Worker;
  globalThis.Worker = class extends PlainWorker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      if (String(address).includes("maze-trial")) globalThis.trialWorker = String(address);
    }
  };
}

/** Runs in the page: opens the dialog and closes it again. @returns milliseconds until results stand there */
async function pressAndWait(mazes: number): Promise<{ first: number; all: number }> {
  const button = [...document.querySelectorAll("button")].find(
    ({ textContent }) => textContent === "Try it in other mazes",
  );
  const begin = performance.now();
  button?.click();
  let first = Number.NaN;
  await new Promise<void>((resolve) => {
    const watch = new MutationObserver(() => {
      const count = document.querySelectorAll("[data-outcome]").length;
      if (count > 0 && Number.isNaN(first)) first = performance.now() - begin;
      if (count < mazes) return;
      watch.disconnect();
      resolve();
    });
    watch.observe(document, { subtree: true, childList: true, attributes: true });
  });
  const all = performance.now() - begin;
  document.querySelector<HTMLElement>("dialog[open] button")?.click();
  await new Promise((later) => setTimeout(later, 200));
  return { first, all };
}

/** Runs in the page: one worker, started and warm, that gets all mazes at once. @returns milliseconds */
async function runAlone(job: {
  program: ProgramDocument;
  side: number;
  mazes: number;
}): Promise<number> {
  const { trialWorker } = globalThis;
  if (trialWorker === undefined) throw new Error("the page has not started the worker");
  const worker = new Worker(trialWorker, { type: "module" });
  const run = async (): Promise<number> => {
    const begin = performance.now();
    const mazes = { kind: "tree", side: job.side };
    const seeds = Array.from({ length: job.mazes }, (_, at) => at + 1);
    worker.postMessage({ type: "try", job: 0, program: job.program, mazes, seeds });
    await new Promise<void>((resolve) => {
      let answers = 0;
      worker.onmessage = () => {
        if (++answers === job.mazes) resolve();
      };
    });
    return performance.now() - begin;
  };
  await run();
  const took = await run();
  worker.terminate();
  return took;
}
