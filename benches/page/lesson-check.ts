/**
 * Measures the check of a program in 1,000 unseen trees of 11 x 11: the time from the click until the
 * first result and the end are displayed, the time of Stop, and the frames of the main thread. The
 * baseline is workers that run the program in the same mazes without a page, and do not judge it.
 */
import { encodeLink } from "@corridor/link";
import { programPresets, type ProgramDocument } from "@corridor/program";
import type { Browser, Page } from "playwright";
import { formatNumber, type Goal } from "../core/goals.ts";
import { median } from "../core/measure.ts";
import { benchLesson } from "./bench-lesson.ts";
import { traceFrames } from "./frame-times.ts";
import { capturePoolWorkerUrl, runOnCores } from "./pool-worker.ts";
import type { PageUnderTest, Section } from "./section.ts";
import { waitUntilStored } from "./wait-until-stored.ts";

const ROUNDS = 11;
const TRACE_MS = 2500;
const FRAME_MS = 1000 / 60;
const SIDE = 11;
const MAZES = 1_000;
const SEED = 7;
/** Unseen maze n has the seed `SEED * SEEDS + n`. */
const SEEDS = 1_000;

export const lessonCheck: Section = { title: "Check", measure };

async function measure({ browser, url }: PageUnderTest): Promise<readonly Goal[]> {
  const program = programPresets.find(({ id }) => id === "right-wall")?.program;
  if (program === undefined) throw new Error("no preset program right-wall");
  const page = await openLesson(browser, url, program);
  const times: { first: number; all: number; raw: number }[] = [];
  const stops: number[] = [];
  for (let round = 0; round <= ROUNDS; round++) {
    const { first, all } = await page.evaluate(checkAndWait);
    const raw = await page.evaluate(runOnCores, {
      program,
      side: SIDE,
      mazes: MAZES,
      first: SEED * SEEDS + 1,
    });
    const stop = await page.evaluate(checkAndStop);
    // The first round loads texts and compiles the simulation.
    if (round === 0) continue;
    times.push({ first, all, raw });
    stops.push(stop);
  }
  const cores = await page.evaluate(() => navigator.hardwareConcurrency);
  const all = median(times.map((time) => time.all));
  const raw = median(times.map((time) => time.raw));
  console.log(
    `  all ${formatNumber(all)} ms; in ${cores} workers without a check ${formatNumber(raw)} ms`,
  );
  const frames = await measureFrames(browser, page);
  await page.close();
  return [
    {
      label: "first result of a check, from the click",
      measured: median(times.map(({ first }) => first)),
      bound: { atMost: 100 },
      unit: "ms",
    },
    {
      label: "stop of a check, from the click",
      measured: Math.max(...stops),
      bound: { atMost: 50 },
      unit: "ms",
    },
    {
      label: `check in ${MAZES} trees, relative to workers without a page`,
      measured: median(times.map((time) => time.all / time.raw)),
      bound: { atMost: 1.3 },
      unit: "times",
    },
    frames,
  ];
}

async function openLesson(browser: Browser, url: string, program: ProgramDocument): Promise<Page> {
  const link = encodeLink({ lesson, program });
  if (!link.ok) throw new Error(`the lesson cannot be encoded as a link: ${link.code}`);
  const viewport = { width: 1440, height: 900 };
  const page = await browser.newPage({ viewport, reducedMotion: "reduce" });
  page.setDefaultTimeout(120_000);
  await page.addInitScript(capturePoolWorkerUrl);
  await page.goto(`${url}/#${link.text}`);
  await page.getByRole("button", { name: /^Check in all/ }).waitFor();
  // Resources that load late belong to opening the lesson, not to the check.
  await page.waitForLoadState("networkidle");
  await waitUntilStored(page);
  return page;
}

/**
 * No path leads to the goal of the given maze, so that the task stays unsolved and offers its check
 * again.
 */
const lesson = benchLesson(
  "Every tree",
  {
    format: "corridor/maze",
    version: 1,
    name: "Closed",
    blocks: ["#####", "#.#.#", "#####"],
    start: { column: 1, row: 1, heading: "east" },
    goals: [{ column: 3, row: 1 }],
  },
  { kind: "tree", columns: SIDE, rows: SIDE, seed: SEED, count: MAZES, pass: MAZES },
);

/** Measures the share of frames that the main thread completes on time during a check. */
async function measureFrames(browser: Browser, page: Page): Promise<Goal> {
  const frames: number[] = [];
  for (let round = 0; round < ROUNDS; round++) {
    const traced = traceFrames(browser, page, TRACE_MS);
    await page.waitForTimeout(100);
    await page.evaluate(checkAndWait);
    frames.push(...(await traced).mainThread);
  }
  const onTime = frames.filter((milliseconds) => milliseconds <= FRAME_MS).length;
  console.log(`  main thread: max ${Math.max(...frames).toFixed(1)} ms per frame`);
  return {
    label: "frames on time during a check",
    measured: (100 * onTime) / frames.length,
    bound: { atLeast: 99 },
    unit: "%",
  };
}

/**
 * Runs in the page. Presses Check and waits for its end.
 * @returns milliseconds until the first result and until the end are displayed
 */
async function checkAndWait(): Promise<{ first: number; all: number }> {
  const buttonOf = (text: string) =>
    [...document.querySelectorAll("button")].find(({ textContent }) =>
      textContent.startsWith(text),
    );
  const start = performance.now();
  buttonOf("Check in all")?.click();
  let first = Number.NaN;
  await new Promise<void>((resolve) => {
    const observer = new MutationObserver(() => {
      const text = document.querySelector('section[aria-label="Mission"]')?.textContent ?? "";
      const isOver = text.includes("Passes in");
      const hasResult = isOver || (document.querySelector("progress")?.value ?? 0) > 0;
      if (hasResult && Number.isNaN(first)) first = performance.now() - start;
      if (!isOver || buttonOf("Check in all") === undefined) return;
      observer.disconnect();
      resolve();
    });
    observer.observe(document, {
      subtree: true,
      childList: true,
      attributes: true,
      characterData: true,
    });
  });
  return { first, all: performance.now() - start };
}

/**
 * Runs in the page. Presses Check, and Stop once there is a result.
 * @returns milliseconds from Stop until the page shows that the check has stopped
 */
async function checkAndStop(): Promise<number> {
  const press = (text: string): void =>
    [...document.querySelectorAll("button")]
      .find(({ textContent }) => textContent.startsWith(text))
      ?.click();
  const wait = async (isReached: () => boolean): Promise<void> =>
    new Promise((resolve) => {
      const look = (): void => {
        if (!isReached()) return;
        observer.disconnect();
        resolve();
      };
      const observer = new MutationObserver(look);
      observer.observe(document, {
        subtree: true,
        childList: true,
        attributes: true,
        characterData: true,
      });
      look();
    });
  press("Check in all");
  await wait(() => (document.querySelector("progress")?.value ?? 0) > 1);
  const start = performance.now();
  press("Stop");
  const panel = document.querySelector('section[aria-label="Mission"]');
  await wait(() => panel?.textContent.includes("Stopped after") === true);
  return performance.now() - start;
}
