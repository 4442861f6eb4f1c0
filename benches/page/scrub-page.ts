/**
 * Measures scrubbing from the user's view. Drops the file of an hour's run on the built page, drags
 * the playhead of the timeline, and jumps to ticks of the run. Each jump is timed from the pointer
 * event until the worker has drawn the tick and the page has laid out the panel.
 */
import type { Browser, Page } from "playwright";
import { processorTime, traceWhile, type TraceEvent } from "./frame-times.ts";
import { HOUR_TICKS, type HourRun } from "./hour-runs.ts";
import { measurePageMemory, type PageMemory } from "./page-memory.ts";
import { waitUntilStored } from "./wait-until-stored.ts";

const JUMPS = 300;
/** Delay after opening the file and after the pointer press, which are not part of a jump. */
const STABILISE_MS = 1000;
/** Delay between two jumps, so that page and worker become idle. */
const REST_MS = 50;
/** Smallest position of a jump, in CSS pixels from the left end of the timeline. */
const MARGIN = 4;
/** Names of the performance marks. */
const REQUESTED = "scrub-requested";
const DISPLAYED = "scrub-displayed";

interface Jump {
  /** elapsed time in milliseconds */
  time: number;
  /** processor time of each thread, in milliseconds */
  main: number;
  worker: number;
}

export interface PageScrubReport {
  jumps: readonly Jump[];
  /** memory after the last jump */
  memory: PageMemory;
}

export async function scrubPage(
  browser: Browser,
  url: string,
  run: HourRun,
): Promise<PageScrubReport> {
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  // A long timeout, because the machine may be busy. Opening the page is not measured.
  page.setDefaultTimeout(30_000);
  await page.addInitScript(markJumps, { REQUESTED, DISPLAYED });
  await page.goto(url);
  await openRun(page, run);
  await waitUntilStored(page);
  const events = await traceWhile(browser, () => jumpRandomly(page));
  const jumps = jumpsOf(events);
  if (jumps.length !== JUMPS) throw new Error(`Only ${jumps.length} of ${JUMPS} jumps completed.`);
  const memory = await measurePageMemory(page);
  await page.close();
  return { jumps, memory };
}

/** Drops the run's file on the page and waits until the page displays the run. */
async function openRun(page: Page, { record }: HourRun): Promise<void> {
  const document = record(HOUR_TICKS).toDocument("hour");
  if (!document.ok) throw new Error(`the run cannot be stored in a file: ${document.reason}`);
  await page.getByRole("button", { name: "Run", exact: true }).waitFor();
  const dataTransfer = await page.evaluateHandle((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "hour.run.json"));
    return data;
  }, document.text);
  for (const type of ["dragenter", "dragover", "drop"]) {
    await page.locator("body").dispatchEvent(type, { dataTransfer });
  }
  await dataTransfer.dispose();
  const slider = page.getByRole("slider", { name: "Timeline" });
  await page.waitForFunction(
    ([input, end]) => input instanceof HTMLInputElement && input.max === end,
    [await slider.elementHandle(), String(HOUR_TICKS)] as const,
  );
  await page.waitForTimeout(STABILISE_MS);
}

declare global {
  /** number of requested ticks that the page has displayed */
  var displayedJumps: number | undefined;
}

/**
 * Runs in the page before its own scripts. Marks the time of the pointer event that requests a tick
 * from the worker, and the time when the clock displays that tick.
 */
function markJumps(names: { REQUESTED: string; DISPLAYED: string }): void {
  let pointerMovedAt = 0;
  globalThis.addEventListener("pointermove", ({ timeStamp }) => (pointerMovedAt = timeStamp), true);
  const PlainWorker = globalThis.Worker;
  globalThis.Worker = class extends PlainWorker {
    override postMessage(message: unknown, options?: StructuredSerializeOptions | Transferable[]) {
      super.postMessage(message, Array.isArray(options) ? { transfer: options } : options);
      const { type, tick } = message as { type?: string; tick?: number };
      if (type === "seek" && tick !== undefined && globalThis.displayedJumps !== undefined) {
        performance.mark(names.REQUESTED, { startTime: pointerMovedAt });
        markWhenDisplayed(tick);
      }
    }
  };

  function markWhenDisplayed(tick: number): void {
    const tenths = Math.floor(tick / 6);
    const seconds = ((tenths % 600) / 10).toFixed(1).padStart(4, "0");
    const time = `Time ${Math.floor(tenths / 600)}:${seconds}`;
    const clock = [...document.querySelectorAll("p")].find(({ textContent }) =>
      textContent.startsWith("Time "),
    );
    if (clock === undefined) throw new Error("the page has no clock");
    const observer = new MutationObserver(() => {
      if (!clock.textContent.startsWith(time)) return;
      observer.disconnect();
      performance.mark(names.DISPLAYED);
      globalThis.displayedJumps = (globalThis.displayedJumps ?? 0) + 1;
    });
    observer.observe(clock, { subtree: true, characterData: true, childList: true });
  }
}

/** Jumps to ticks one after the other, each when the previous tick is displayed. */
async function jumpRandomly(page: Page): Promise<void> {
  const box = await page.getByRole("slider", { name: "Timeline" }).boundingBox();
  if (box === null) throw new Error("the page has no timeline");
  const y = box.y + box.height / 2;
  // Jumps are spread over the run in pseudorandom order. The end of the timeline means live.
  const width = Math.floor(0.94 * box.width);
  await page.mouse.move(box.x + 2, y);
  await page.mouse.down();
  await page.waitForTimeout(STABILISE_MS);
  await page.evaluate(() => (globalThis.displayedJumps = 0));
  for (let at = 1; at <= JUMPS; at++) {
    await page.mouse.move(box.x + MARGIN + ((at * 7919) % width), y);
    await page.waitForFunction((count) => globalThis.displayedJumps === count, at, { polling: 20 });
    await page.waitForTimeout(REST_MS);
  }
  await page.mouse.up();
}

/** Evaluates each jump. A jump whose frame or panel is missing in the trace takes Infinity. */
function jumpsOf(events: readonly TraceEvent[]): Jump[] {
  const inOrder = events.toSorted((a, b) => a.ts - b.ts);
  const requests = inOrder.filter(({ name }) => name === REQUESTED);
  const displays = inOrder.filter(({ name }) => name === DISPLAYED);
  return requests.map((request, at) => {
    const until = requests[at + 1]?.ts ?? Number.POSITIVE_INFINITY;
    const jumpEvents = inOrder.filter(
      ({ pid, ts }) => pid === request.pid && ts >= request.ts && ts < until,
    );
    const mainEvents = jumpEvents.filter(({ tid }) => tid === request.tid);
    const workersEvents = jumpEvents.filter(({ tid }) => tid !== request.tid);
    // The first message to a worker is the request. That worker displays the tick in its next frame.
    const received = workersEvents.find(({ name }) => name === "HandlePostMessage");
    const workerEvents = workersEvents.filter(
      ({ tid, ts }) => tid === received?.tid && ts >= received.ts,
    );
    const frame = workerEvents.find(({ name }) => name === "FireAnimationFrame");
    const panel = mainEvents.find(
      ({ name, ts }) => name === "Layerize" && ts > (displays[at]?.ts ?? until),
    );
    if (frame === undefined || panel === undefined)
      return { time: Infinity, main: Infinity, worker: Infinity };
    const end = Math.max(endOf(frame), endOf(panel));
    return {
      time: (end - request.ts) / 1000,
      main: processorTime(mainEvents, request.ts, end),
      worker: processorTime(workerEvents, request.ts, end),
    };
  });
}

function endOf({ ts, dur = 0 }: TraceEvent): number {
  return ts + dur;
}
