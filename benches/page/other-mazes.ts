/**
 * Measures "Try it in other mazes" with 100 trees of 11 x 11: the time from the click until the
 * first and the last result are displayed, and the frames of the main thread. The baseline is
 * workers that run the same mazes without a page.
 */
import { encodeLink } from "@corridor/link";
import { mazePresets } from "@corridor/maze";
import { programPresets, type ProgramDocument } from "@corridor/program";
import type { Browser, Page } from "playwright";
import { formatNumber, type Goal } from "../core/goals.ts";
import { median } from "../core/measure.ts";
import { traceFrames } from "./frame-times.ts";
import { capturePoolWorkerUrl, runOnCores } from "./pool-worker.ts";
import type { PageUnderTest, Section } from "./section.ts";
import { waitUntilStored } from "./wait-until-stored.ts";

const ROUNDS = 5;
const TRACE_MS = 1500;
const FRAME_MS = 1000 / 60;
const SIDE = 11;
const MAZES = 100;

/**
 * The first program reaches every goal. The second drives to and fro and always uses all the time.
 */
const programs = ["right-wall", "left-at-every-wall"] as const;

export const otherMazes: Section = { title: "Other mazes", measure };

async function measure({ browser, url }: PageUnderTest): Promise<readonly Goal[]> {
  const firstTimes: number[] = [];
  const goals: Goal[] = [];
  for (const id of programs) {
    const program = programPresets.find((preset) => preset.id === id)?.program;
    if (program === undefined) throw new Error(`no preset program ${id}`);
    const page = await openWith(browser, url, program);
    const times: { first: number; all: number; raw: number }[] = [];
    for (let round = 0; round <= ROUNDS; round++) {
      const { first, all } = await page.evaluate(clickAndWait, MAZES);
      const raw = await page.evaluate(runOnCores, { program, side: SIDE, mazes: MAZES, first: 1 });
      // The first round loads the dialog and its texts.
      if (round > 0) times.push({ first, all, raw });
    }
    const cores = await page.evaluate(() => navigator.hardwareConcurrency);
    firstTimes.push(...times.map(({ first }) => first));
    const all = median(times.map((time) => time.all));
    const raw = median(times.map((time) => time.raw));
    console.log(
      `  ${id}: first ${formatNumber(median(times.map(({ first }) => first)))} ms, all ${formatNumber(all)} ms; in ${cores} workers without a page ${formatNumber(raw)} ms`,
    );
    goals.push({
      label: `${MAZES} trees with ${id}, relative to workers without a page`,
      measured: median(times.map((time) => time.all / time.raw)),
      bound: { atMost: 1.3 },
      unit: "times",
    });
    if (id === "left-at-every-wall") goals.push(await measureFramesDuringTrials(browser, page));
    await page.close();
  }
  return [
    {
      label: "first result of the other mazes, from the click",
      measured: median(firstTimes),
      bound: { atMost: 150 },
      unit: "ms",
    },
    ...goals,
  ];
}

async function openWith(browser: Browser, url: string, program: ProgramDocument): Promise<Page> {
  const [preset] = mazePresets;
  if (preset === undefined) throw new Error("no maze presets");
  // The name differs from the preset's, so that the page treats the program as the student's own.
  const link = encodeLink({ maze: preset.maze, program: { ...program, name: "Mine" } });
  if (!link.ok) throw new Error(`the maze cannot be encoded as a link: ${link.code}`);
  // Without a GPU, the opening animation of the dialog uses one core, which the mazes would then
  // lack.
  const viewport = { width: 1440, height: 900 };
  const page = await browser.newPage({ viewport, reducedMotion: "reduce" });
  page.setDefaultTimeout(120_000);
  await page.addInitScript(capturePoolWorkerUrl);
  await page.goto(`${url}/#${link.text}`);
  await page.getByRole("button", { name: "Try it in other mazes" }).waitFor();
  // Resources that load late belong to the first visit, not to this measurement.
  await page.waitForLoadState("networkidle");
  await waitUntilStored(page);
  return page;
}

/**
 * Measures the share of frames that the main thread completes on time while all cores try mazes.
 */
async function measureFramesDuringTrials(browser: Browser, page: Page): Promise<Goal> {
  const frames: number[] = [];
  for (let round = 0; round < ROUNDS; round++) {
    const traced = traceFrames(browser, page, TRACE_MS);
    await page.waitForTimeout(100);
    await page.evaluate(clickAndWait, MAZES);
    frames.push(...(await traced).mainThread);
  }
  const onTime = frames.filter((milliseconds) => milliseconds <= FRAME_MS).length;
  console.log(`  main thread: max ${Math.max(...frames).toFixed(1)} ms per frame`);
  return {
    label: "frames on time while other mazes are tried",
    measured: (100 * onTime) / frames.length,
    bound: { atLeast: 99 },
    unit: "%",
  };
}

/**
 * Runs in the page. Opens the dialog, waits for all results and closes it.
 * @returns milliseconds until the first result and until all results are displayed
 */
async function clickAndWait(mazes: number): Promise<{ first: number; all: number }> {
  const button = [...document.querySelectorAll("button")].find(
    ({ textContent }) => textContent === "Try it in other mazes",
  );
  const start = performance.now();
  button?.click();
  let first = Number.NaN;
  await new Promise<void>((resolve) => {
    const observer = new MutationObserver(() => {
      const count = document.querySelectorAll("[data-outcome]").length;
      if (count > 0 && Number.isNaN(first)) first = performance.now() - start;
      if (count < mazes) return;
      observer.disconnect();
      resolve();
    });
    observer.observe(document, { subtree: true, childList: true, attributes: true });
  });
  const all = performance.now() - start;
  document.querySelector<HTMLElement>("dialog[open] button")?.click();
  await new Promise((resolve) => setTimeout(resolve, 200));
  return { first, all };
}
