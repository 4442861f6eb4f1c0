/**
 * What a frame costs while a program runs: the product's page beside three variants of its stage, in one
 * run. The limit is the bare thing, three layers drawn by a worker and eight numbers in plain elements.
 */
import type { Browser, Page } from "playwright";
import type { Goal } from "../core/goals.ts";
import { median, quantile, timesSlower } from "../core/measure.ts";
import { watchPage, type Watched } from "./main-thread.ts";
import { longProgram, openProduct, quietPanels } from "./product.ts";
import type { PageUnderTest, Section } from "./section.ts";
import { serveVariants } from "./serve-variants.ts";
import { STAGE_PX } from "./variants/scenery.ts";

const sides = [33, 101] as const;
const contenders = ["product", "worker-layers", "page-layers", "svg"] as const;
type Contender = (typeof contenders)[number];

/** As many as a program may have. */
const MOST_LINES = 200;

const ROUNDS = 3;
/** What a page does when it has just been slowed down, or its panels fell silent, is not measured. */
const SETTLE_MS = 1000;
/** A page that has fetched nothing for so long has all its parts: what comes late is the first visit's. */
const QUIET_MS = 2000;
const WATCH_MS = 3000;
/** How many times slower the processor is made. */
const THROTTLE = 4;
const FRAME_MS = 1000 / 60;

/** One list of numbers for each round. */
interface Rounds {
  mainThread: number[][];
  script: number[][];
  workerFrames: number[];
  /** processor slowed down: milliseconds of main thread in each frame */
  throttled: number[];
  /** the stage without its panels */
  alone: { mainThread: number[][]; script: number[][] };
}

export const frames: Section = { title: "Frames", measure };

async function measure({ browser, url }: PageUnderTest): Promise<readonly Goal[]> {
  const variants = await serveVariants("variants/");
  try {
    const goals: Goal[] = [];
    for (const side of sides) {
      const open = (contender: Contender): Promise<Page> =>
        contender === "product"
          ? openProduct(browser, url, side)
          : openVariant(browser, variants.url, contender, side);
      const measured = await measureAll(browser, open);
      print(side, measured);
      goals.push(...goalsOf(side, measured));
    }
    goals.push(await manyLines(browser, url));
    return goals;
  } finally {
    await variants.stop();
  }
}

/** One page at a time, in turns, so that one moment of the machine meets all of them. */
async function measureAll(
  browser: Browser,
  open: (contender: Contender) => Promise<Page>,
): Promise<Record<Contender, Rounds>> {
  const empty = (): Rounds => ({
    mainThread: [],
    script: [],
    workerFrames: [],
    throttled: [],
    alone: { mainThread: [], script: [] },
  });
  const measured: Record<Contender, Rounds> = {
    product: empty(),
    "worker-layers": empty(),
    "page-layers": empty(),
    svg: empty(),
  };
  for (let round = 0; round < ROUNDS; round++) {
    for (const contender of contenders) {
      const page = await open(contender);
      await untilComplete(page);
      const rounds = measured[contender];
      const seen = await watchPage(browser, page, WATCH_MS);
      rounds.mainThread.push(seen.mainThread);
      rounds.script.push(seen.script);
      rounds.workerFrames.push(...seen.workerFrames);
      if (contender === "product") {
        rounds.throttled.push(...(await watchThrottled(browser, page)).mainThread);
        await quietPanels(page);
        await page.waitForTimeout(SETTLE_MS);
        const alone = await watchPage(browser, page, WATCH_MS);
        rounds.alone.mainThread.push(alone.mainThread);
        rounds.alone.script.push(alone.script);
      }
      await page.close();
    }
  }
  return measured;
}

/** The longest program, all of whose lines show their truths, at the machine's own speed. */
async function manyLines(browser: Browser, url: string): Promise<Goal> {
  const side = 33;
  const page = await openProduct(browser, url, side, longProgram(MOST_LINES));
  await untilComplete(page);
  const { mainThread } = await watchPage(browser, page, ROUNDS * WATCH_MS);
  await page.close();
  const inTime = mainThread.filter((milliseconds) => milliseconds <= FRAME_MS).length;
  const [p99, most] = [quantile(mainThread, 0.99), Math.max(...mainThread)];
  console.log(
    `  ${MOST_LINES} lines at ${side}: main mean ${mean(mainThread).toFixed(3)}, p99 ${p99.toFixed(2)}, most ${most.toFixed(1)}`,
  );
  return {
    label: `frames with ${MOST_LINES} lines whose main thread is done in time`,
    measured: (100 * inTime) / mainThread.length,
    bound: { atLeast: 99 },
    unit: "%",
  };
}

/** Waits until a page loads nothing more; a robot may drive in it meanwhile. */
async function untilComplete(page: Page): Promise<void> {
  await page.waitForFunction((quiet) => {
    const loaded = performance.getEntriesByType("resource") as PerformanceResourceTiming[];
    const last = Math.max(0, ...loaded.map(({ responseEnd }) => responseEnd));
    return performance.now() - last >= quiet;
  }, QUIET_MS);
}

async function watchThrottled(browser: Browser, page: Page): Promise<Watched> {
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: THROTTLE });
  await page.waitForTimeout(SETTLE_MS);
  const seen = await watchPage(browser, page, WATCH_MS);
  await session.send("Emulation.setCPUThrottlingRate", { rate: 1 });
  await session.detach();
  return seen;
}

async function openVariant(
  browser: Browser,
  url: string,
  variant: Exclude<Contender, "product">,
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
  { product, "worker-layers": limit }: Record<Contender, Rounds>,
): Goal[] {
  const script = product.alone.script.flat();
  const inTime = product.throttled.filter((milliseconds) => milliseconds <= FRAME_MS).length;
  const painted = product.workerFrames.filter(
    (milliseconds) => milliseconds * THROTTLE <= FRAME_MS,
  );
  return [
    {
      label: `script for the stage a frame at ${side}, p50`,
      measured: quantile(script, 0.5),
      bound: { atMost: 0.1 },
      unit: "ms",
    },
    {
      label: `script for the stage a frame at ${side}, p99`,
      measured: quantile(script, 0.99),
      bound: { atMost: 0.5 },
      unit: "ms",
    },
    {
      label: `main thread at ${side}, the stage alone, against the limit`,
      measured: timesSlower(product.alone.mainThread.map(mean), limit.mainThread.map(mean)),
      bound: { atMost: 1.3 },
      unit: "times",
    },
    {
      label: `main thread at ${side}, panel included, against the limit`,
      measured: timesSlower(product.mainThread.map(mean), limit.mainThread.map(mean)),
      bound: { atMost: 1.3 },
      unit: "times",
    },
    {
      label: `frames at ${side} whose main thread is done in time, ${THROTTLE} times throttled`,
      measured: (100 * inTime) / product.throttled.length,
      bound: { atLeast: 99 },
      unit: "%",
    },
    {
      label: `pictures at ${side} that a ${THROTTLE} times slower worker would draw in time`,
      measured: (100 * painted.length) / product.workerFrames.length,
      bound: { atLeast: 99 },
      unit: "%",
    },
  ];
}

function print(side: number, measured: Record<Contender, Rounds>): void {
  console.log(`\n${side} cells a side: milliseconds of processor time a frame`);
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
  for (const contender of contenders) {
    const { mainThread, script, workerFrames } = measured[contender];
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
    console.log(`  ${contender.padEnd(16)}${cells}`);
  }
  const { mainThread, script } = measured.product.alone;
  const numbers = [
    median(mainThread.map(mean)),
    quantile(mainThread.flat(), 0.5),
    quantile(mainThread.flat(), 0.99),
    median(script.map(mean)),
    quantile(script.flat(), 0.5),
    quantile(script.flat(), 0.99),
  ];
  const cells = numbers.map((number) => number.toFixed(3).padStart(12)).join("");
  console.log(`  ${"stage alone".padEnd(16)}${cells}`);
}

function mean(numbers: readonly number[]): number {
  return numbers.reduce((sum, number) => sum + number, 0) / numbers.length;
}
