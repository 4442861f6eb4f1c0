/**
 * Measures the dashboard of a class of which every robot moves. The class is at a real relay, and
 * its students send the tiles that the product's page would send. The limit of the main thread is a
 * page with one canvas, on which a worker draws as many sprites.
 */
import type { Browser, Page } from "playwright";
import type { Goal } from "../../core/goals.ts";
import { quantile, timesSlower } from "../../core/measure.ts";
import { traceFrames, type FrameTimes } from "../frame-times.ts";
import type { PageUnderTest, Section } from "../section.ts";
import { serveVariants } from "../serve-variants.ts";
import { openDashboard, startClass, startStudents, VIEWPORT } from "./live-class.ts";
import { measureTileMemory } from "./tile-memory.ts";

const TYPICAL = 40;
const LARGEST = 200;
const ROUNDS = 7;
const TRACE_MS = 5_000;
/** Delay before a trace, so that opening the page is not measured, nor the end of its garbage. */
const STABILISE_MS = 3_000;
/** Factor by which Chromium slows down the processor. */
const THROTTLE = 4;
const FRAME_MS = 1_000 / 60;
const LESSON_SECONDS = 2 * 3_600;
const MIB = 1_024 * 1_024;

interface Rounds {
  product: FrameTimes[];
  limit: FrameTimes[];
  throttled: FrameTimes[];
}

export const dashboard: Section = { title: "Dashboard", measure };

async function measure({ browser, url }: PageUnderTest): Promise<readonly Goal[]> {
  const typical = await measureTypical(browser, url);
  const largest = await measureLargest(browser, url);
  printTable(typical, largest);
  const memory = await measureTileMemory({
    browser,
    relay: url,
    students: TYPICAL,
    seconds: LESSON_SECONDS,
  });
  const total = ({ main, workers }: typeof memory.before): number => (main + workers) / MIB;
  console.log(
    `  memory ${total(memory.before).toFixed(1)} MiB, then ${total(memory.after).toFixed(1)} MiB; tiles ${memory.speed.toFixed(0)} times as fast as in a lesson`,
  );
  return [
    ...goalsOf(typical),
    {
      label: `dashboard worker per frame, ${LARGEST} students, p99`,
      measured: quantile(largest.workerThread, 0.99),
      bound: { atMost: 12 },
      unit: "ms",
    },
    {
      label: `memory of the dashboard, growth in a lesson of ${LESSON_SECONDS / 3_600} hours`,
      measured: total(memory.after) - total(memory.before),
      bound: { atMost: 64 },
      unit: "MiB",
    },
  ];
}

/** Opens the dashboard and the limit in turn, while the students of one class drive. */
async function measureTypical(browser: Browser, relay: string): Promise<Rounds> {
  const limit = await serveVariants("variants/sprites/");
  const teacher = await startClass(relay);
  const stop = await startStudents({ relay, code: teacher.code, students: TYPICAL });
  const rounds: Rounds = { product: [], limit: [], throttled: [] };
  try {
    for (let round = 0; round < ROUNDS; round++) {
      const page = await openDashboard(browser, relay, teacher, TYPICAL);
      rounds.product.push(await traceLater(browser, page));
      rounds.throttled.push(await traceThrottled(browser, page));
      await page.close();
      const sprites = await browser.newPage({ viewport: VIEWPORT });
      await sprites.goto(`${limit.url}/?count=${TYPICAL}`);
      await sprites.locator("[data-ready]").waitFor({ state: "attached" });
      rounds.limit.push(await traceLater(browser, sprites));
      await sprites.close();
    }
  } finally {
    await stop();
    await limit.stop();
  }
  return rounds;
}

async function measureLargest(browser: Browser, relay: string): Promise<FrameTimes> {
  const teacher = await startClass(relay);
  const stop = await startStudents({ relay, code: teacher.code, students: LARGEST });
  try {
    const page = await openDashboard(browser, relay, teacher, LARGEST);
    const times = await traceLater(browser, page, ROUNDS * TRACE_MS);
    await page.close();
    return times;
  } finally {
    await stop();
  }
}

async function traceLater(browser: Browser, page: Page, ms = TRACE_MS): Promise<FrameTimes> {
  await page.waitForTimeout(STABILISE_MS);
  await page.requestGC();
  return traceFrames(browser, page, ms);
}

/** Slows down the main thread. Chromium cannot slow down a worker. */
async function traceThrottled(browser: Browser, page: Page): Promise<FrameTimes> {
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: THROTTLE });
  const times = await traceLater(browser, page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: 1 });
  await session.detach();
  return times;
}

function goalsOf({ product, limit, throttled }: Rounds): Goal[] {
  const script = product.flatMap((times) => times.script);
  const worker = product.flatMap((times) => times.workerThread);
  const main = throttled.flatMap((times) => times.mainThread);
  const means = (all: readonly FrameTimes[]): number[] =>
    all.map(({ mainThread }) => mean(mainThread));
  return [
    {
      label: `script per frame, ${TYPICAL} cards, p50`,
      measured: quantile(script, 0.5),
      bound: { atMost: 0.2 },
      unit: "ms",
    },
    {
      label: `script per frame, ${TYPICAL} cards, p99`,
      measured: quantile(script, 0.99),
      bound: { atMost: 1.5 },
      unit: "ms",
    },
    {
      label: `main thread, ${TYPICAL} cards, relative to a canvas of ${TYPICAL} sprites`,
      measured: timesSlower(means(product), means(limit)),
      bound: { atMost: 1.3 },
      unit: "times",
    },
    {
      label: `dashboard worker per frame, ${TYPICAL} cards, p99`,
      measured: quantile(worker, 0.99),
      bound: { atMost: 4 },
      unit: "ms",
    },
    {
      label: `frames on time, ${TYPICAL} cards, main thread throttled ${THROTTLE} times`,
      measured: percent(main, (ms) => ms <= FRAME_MS),
      bound: { atLeast: 99 },
      unit: "%",
    },
    {
      label: `worker frames on time, calculated for a ${THROTTLE} times slower worker`,
      measured: percent(worker, (ms) => ms * THROTTLE <= FRAME_MS),
      bound: { atLeast: 99 },
      unit: "%",
    },
  ];
}

function printTable({ product, limit, throttled }: Rounds, largest: FrameTimes): void {
  const head = [
    "main mean",
    "p50",
    "p99",
    "script mean",
    "p50",
    "p99",
    "worker mean",
    "p50",
    "p99",
  ];
  console.log(`  ${"".padEnd(24)}${head.map((each) => each.padStart(12)).join("")}`);
  const rows: [string, readonly FrameTimes[]][] = [
    [`${TYPICAL} cards`, product],
    [`throttled ${THROTTLE} times`, throttled],
    [`${LARGEST} students`, [largest]],
    [`${TYPICAL} sprites`, limit],
  ];
  for (const [name, times] of rows) {
    const numbers = (["mainThread", "script", "workerThread"] as const).flatMap((part) => {
      const all = times.flatMap((each) => each[part]);
      return [mean(all), quantile(all, 0.5), quantile(all, 0.99)];
    });
    const cells = numbers.map((number) => number.toFixed(3).padStart(12)).join("");
    console.log(`  ${name.padEnd(24)}${cells}`);
  }
  const byRound = product.map(({ mainThread }, round) => {
    const ratio = mean(mainThread) / mean(limit[round]?.mainThread ?? []);
    return ratio.toFixed(2);
  });
  console.log(`  main thread relative to the limit, by round: ${byRound.join(", ")}`);
}

function percent(numbers: readonly number[], isGood: (number: number) => boolean): number {
  return (100 * numbers.filter((each) => isGood(each)).length) / numbers.length;
}

function mean(numbers: readonly number[]): number {
  return numbers.reduce((sum, number) => sum + number, 0) / numbers.length;
}
