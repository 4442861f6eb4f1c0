/**
 * Measures the cost of a frame while a program runs, for the product's page and three variants of
 * its stage. The limit is a minimal variant: three layers drawn by a worker, and eight numbers in
 * plain elements.
 */
import type { Browser, Page } from "playwright";
import type { Goal } from "../core/goals.ts";
import { median, quantile, timesSlower } from "../core/measure.ts";
import { traceFrames, type FrameTimes } from "./frame-times.ts";
import { longProgram, mutePanels, openProduct } from "./product.ts";
import type { PageUnderTest, Section } from "./section.ts";
import { serveVariants } from "./serve-variants.ts";
import { STAGE_PX } from "./variants/bench-run.ts";

const sides = [33, 101] as const;
const stageVariants = ["product", "worker-layers", "page-layers", "svg"] as const;
type StageVariant = (typeof stageVariants)[number];

/** The maximum number of lines of a program. */
const MAX_LINES = 200;

const ROUNDS = 3;
/** Delay before a trace, so that the effect of throttling or muting panels is not measured. */
const STABILISE_MS = 1000;
/** A page that fetches nothing for this long is loaded completely. */
const IDLE_MS = 2000;
const TRACE_MS = 3000;
/** Factor by which Chromium slows down the processor. */
const THROTTLE = 4;
const FRAME_MS = 1000 / 60;

/** Times in milliseconds. Nested lists have one list per round. */
interface Rounds {
  mainThread: number[][];
  script: number[][];
  workerFrames: number[];
  /** main thread with a throttled processor */
  throttled: number[];
  /** the stage with muted panels */
  stageOnly: { mainThread: number[][]; script: number[][] };
}

export const frames: Section = { title: "Frames", measure };

async function measure({ browser, url }: PageUnderTest): Promise<readonly Goal[]> {
  const variants = await serveVariants("variants/");
  try {
    const goals: Goal[] = [];
    for (const side of sides) {
      const open = (variant: StageVariant): Promise<Page> =>
        variant === "product"
          ? openProduct(browser, url, side)
          : openVariant(browser, variants.url, variant, side);
      const measured = await measureAll(browser, open);
      printTable(side, measured);
      goals.push(...goalsOf(side, measured));
    }
    goals.push(await measureManyLines(browser, url));
    return goals;
  } finally {
    await variants.stop();
  }
}

/**
 * Opens one page at a time, alternating, so that a slow period of the machine affects all variants.
 */
async function measureAll(
  browser: Browser,
  open: (variant: StageVariant) => Promise<Page>,
): Promise<Record<StageVariant, Rounds>> {
  const empty = (): Rounds => ({
    mainThread: [],
    script: [],
    workerFrames: [],
    throttled: [],
    stageOnly: { mainThread: [], script: [] },
  });
  const measured: Record<StageVariant, Rounds> = {
    product: empty(),
    "worker-layers": empty(),
    "page-layers": empty(),
    svg: empty(),
  };
  for (let round = 0; round < ROUNDS; round++) {
    for (const variant of stageVariants) {
      const page = await open(variant);
      await waitUntilLoaded(page);
      const rounds = measured[variant];
      const times = await traceFrames(browser, page, TRACE_MS);
      rounds.mainThread.push(times.mainThread);
      rounds.script.push(times.script);
      rounds.workerFrames.push(...times.workerFrames);
      if (variant === "product") {
        rounds.throttled.push(...(await traceThrottled(browser, page)).mainThread);
        await mutePanels(page);
        await page.waitForTimeout(STABILISE_MS);
        const stageOnly = await traceFrames(browser, page, TRACE_MS);
        rounds.stageOnly.mainThread.push(stageOnly.mainThread);
        rounds.stageOnly.script.push(stageOnly.script);
      }
      await page.close();
    }
  }
  return measured;
}

/**
 * Measures the longest program, without throttling. All of its lines display their truth values.
 */
async function measureManyLines(browser: Browser, url: string): Promise<Goal> {
  const side = 33;
  const page = await openProduct(browser, url, side, longProgram(MAX_LINES));
  await waitUntilLoaded(page);
  const { mainThread } = await traceFrames(browser, page, ROUNDS * TRACE_MS);
  await page.close();
  const onTime = mainThread.filter((milliseconds) => milliseconds <= FRAME_MS).length;
  const [p99, max] = [quantile(mainThread, 0.99), Math.max(...mainThread)];
  console.log(
    `  ${MAX_LINES} lines at ${side}: main mean ${mean(mainThread).toFixed(3)}, p99 ${p99.toFixed(2)}, max ${max.toFixed(1)}`,
  );
  return {
    label: `frames on time with ${MAX_LINES} lines`,
    measured: (100 * onTime) / mainThread.length,
    bound: { atLeast: 99 },
    unit: "%",
  };
}

/** Waits until a page loads nothing more. A running program does not matter. */
async function waitUntilLoaded(page: Page): Promise<void> {
  await page.waitForFunction((idle) => {
    const loaded = performance.getEntriesByType("resource") as PerformanceResourceTiming[];
    const last = Math.max(0, ...loaded.map(({ responseEnd }) => responseEnd));
    return performance.now() - last >= idle;
  }, IDLE_MS);
}

async function traceThrottled(browser: Browser, page: Page): Promise<FrameTimes> {
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: THROTTLE });
  await page.waitForTimeout(STABILISE_MS);
  const times = await traceFrames(browser, page, TRACE_MS);
  await session.send("Emulation.setCPUThrottlingRate", { rate: 1 });
  await session.detach();
  return times;
}

async function openVariant(
  browser: Browser,
  url: string,
  variant: Exclude<StageVariant, "product">,
  side: number,
): Promise<Page> {
  const page = await browser.newPage({
    viewport: { width: STAGE_PX + 412, height: STAGE_PX + 40 },
  });
  await page.goto(`${url}/?variant=${variant}&side=${side}`);
  await page.locator("[data-ready]").waitFor({ state: "attached" });
  return page;
}

function goalsOf(
  side: number,
  { product, "worker-layers": limit }: Record<StageVariant, Rounds>,
): Goal[] {
  const script = product.stageOnly.script.flat();
  const onTime = product.throttled.filter((milliseconds) => milliseconds <= FRAME_MS).length;
  const drawnOnTime = product.workerFrames.filter(
    (milliseconds) => milliseconds * THROTTLE <= FRAME_MS,
  ).length;
  return [
    {
      label: `script per frame for the stage at ${side}, p50`,
      measured: quantile(script, 0.5),
      bound: { atMost: 0.1 },
      unit: "ms",
    },
    {
      label: `script per frame for the stage at ${side}, p99`,
      measured: quantile(script, 0.99),
      bound: { atMost: 0.5 },
      unit: "ms",
    },
    {
      label: `main thread at ${side}, stage only, relative to the limit`,
      measured: timesSlower(product.stageOnly.mainThread.map(mean), limit.mainThread.map(mean)),
      bound: { atMost: 1.3 },
      unit: "times",
    },
    {
      label: `main thread at ${side}, panel included, relative to the limit`,
      measured: timesSlower(product.mainThread.map(mean), limit.mainThread.map(mean)),
      bound: { atMost: 1.3 },
      unit: "times",
    },
    {
      label: `frames on time at ${side}, main thread throttled ${THROTTLE} times`,
      measured: (100 * onTime) / product.throttled.length,
      bound: { atLeast: 99 },
      unit: "%",
    },
    {
      label: `worker frames on time at ${side}, calculated for a ${THROTTLE} times slower worker`,
      measured: (100 * drawnOnTime) / product.workerFrames.length,
      bound: { atLeast: 99 },
      unit: "%",
    },
  ];
}

function printTable(side: number, measured: Record<StageVariant, Rounds>): void {
  console.log(`\n${side} cells per side: milliseconds of processor time per frame`);
  console.log(
    `  ${"".padEnd(16)}${[
      "main mean",
      "p50",
      "p99",
      "script mean",
      "p50",
      "p99",
      "worker p50",
      "p99",
    ]
      .map((each) => each.padStart(12))
      .join("")}`,
  );
  for (const variant of stageVariants) {
    const { mainThread, script, workerFrames } = measured[variant];
    const numbers = [
      median(mainThread.map(mean)),
      quantile(mainThread.flat(), 0.5),
      quantile(mainThread.flat(), 0.99),
      median(script.map(mean)),
      quantile(script.flat(), 0.5),
      quantile(script.flat(), 0.99),
      quantile(workerFrames, 0.5),
      quantile(workerFrames, 0.99),
    ];
    const cells = numbers.map((number) => number.toFixed(3).padStart(12)).join("");
    console.log(`  ${variant.padEnd(16)}${cells}`);
  }
  const { mainThread, script } = measured.product.stageOnly;
  const numbers = [
    median(mainThread.map(mean)),
    quantile(mainThread.flat(), 0.5),
    quantile(mainThread.flat(), 0.99),
    median(script.map(mean)),
    quantile(script.flat(), 0.5),
    quantile(script.flat(), 0.99),
  ];
  const cells = numbers.map((number) => number.toFixed(3).padStart(12)).join("");
  console.log(`  ${"stage only".padEnd(16)}${cells}`);
}

function mean(numbers: readonly number[]): number {
  return numbers.reduce((sum, number) => sum + number, 0) / numbers.length;
}
