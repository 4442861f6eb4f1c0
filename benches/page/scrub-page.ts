/**
 * Scrubbing as its user meets it: the file of an hour's run is dropped on the built page, a pointer holds the
 * timeline's playhead and jumps about, and each jump is timed from the pointer's event until the picture of that
 * moment is drawn by the worker and its panel handed over by the page.
 */
import type { Browser, Page } from "playwright";
import { heldByPage, type Held } from "./heap.ts";
import { HOUR, type Hour } from "./hours.ts";
import { processorTime, traceWhile, type TraceEvent } from "./main-thread.ts";

const MOMENTS = 300;
/** What opening the file and the press itself set going is not part of a jump. */
const SETTLE_MS = 1000;
/** From one jump to the next, so that page and worker come to rest. */
const REST_MS = 50;
/** Where the first jump may go, in px from the timeline's left end. */
const MARGIN = 4;
const ASKED = "scrub-asked";
const SHOWN = "scrub-shown";

interface Jump {
  /** milliseconds on the clock */
  time: number;
  /** processor time of each thread, in milliseconds */
  main: number;
  worker: number;
}

export interface PageScrubReport {
  jumps: readonly Jump[];
  /** after the last jump */
  held: Held;
}

export async function pageScrubReport(
  browser: Browser,
  url: string,
  hour: Hour,
): Promise<PageScrubReport> {
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  // The machine may be busy; how long opening takes is not measured.
  page.setDefaultTimeout(30_000);
  await page.addInitScript(markMoments, { ASKED, SHOWN });
  await page.goto(url);
  await openRun(page, hour);
  const events = await traceWhile(browser, () => jumpAbout(page));
  const jumps = jumpsOf(events);
  if (jumps.length !== MOMENTS) throw new Error(`${jumps.length} of ${MOMENTS} moments were shown`);
  const held = await heldByPage(page);
  await page.close();
  return { jumps, held };
}

/** Drops the run's file on the page and waits until it is shown. */
async function openRun(page: Page, { record }: Hour): Promise<void> {
  const written = record(HOUR).toDocument("hour");
  if (!written.ok) throw new Error(`the hour fits no file: ${written.reason}`);
  await page.getByRole("button", { name: "Run", exact: true }).waitFor();
  const dataTransfer = await page.evaluateHandle((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "hour.run.json"));
    return data;
  }, written.text);
  for (const type of ["dragenter", "dragover", "drop"]) {
    await page.locator("body").dispatchEvent(type, { dataTransfer });
  }
  await dataTransfer.dispose();
  const slider = page.getByRole("slider", { name: "Timeline" });
  await page.waitForFunction(
    ([input, end]) => input instanceof HTMLInputElement && input.max === end,
    [await slider.elementHandle(), String(HOUR)] as const,
  );
  await page.waitForTimeout(SETTLE_MS);
}

declare global {
  /** how many moments that were asked for have been shown */
  var momentsShown: number | undefined;
}

/**
 * Runs in the page before its own scripts: marks the time of the pointer's event that asks the worker for a moment,
 * and the time at which the clock tells of exactly that moment.
 */
function markMoments(names: { ASKED: string; SHOWN: string }): void {
  let movedAt = 0;
  globalThis.addEventListener("pointermove", ({ timeStamp }) => (movedAt = timeStamp), true);
  const PlainWorker = globalThis.Worker;
  globalThis.Worker = class extends PlainWorker {
    override postMessage(message: unknown, given?: StructuredSerializeOptions | Transferable[]) {
      super.postMessage(message, Array.isArray(given) ? { transfer: given } : given);
      const { type, tick } = message as { type?: string; tick?: number };
      if (type === "seek" && tick !== undefined && globalThis.momentsShown !== undefined) {
        performance.mark(names.ASKED, { startTime: movedAt });
        markWhenShown(tick);
      }
    }
  };

  function markWhenShown(tick: number): void {
    const tenths = Math.floor(tick / 6);
    const seconds = ((tenths % 600) / 10).toFixed(1).padStart(4, "0");
    const time = `Time ${Math.floor(tenths / 600)}:${seconds}`;
    const clock = [...document.querySelectorAll("p")].find(({ textContent }) =>
      textContent.startsWith("Time "),
    );
    if (clock === undefined) throw new Error("there is no clock");
    const observer = new MutationObserver(() => {
      if (!clock.textContent.startsWith(time)) return;
      observer.disconnect();
      performance.mark(names.SHOWN);
      globalThis.momentsShown = (globalThis.momentsShown ?? 0) + 1;
    });
    observer.observe(clock, { subtree: true, characterData: true, childList: true });
  }
}

/** Asks for one moment after the other, each when the one before is shown. */
async function jumpAbout(page: Page): Promise<void> {
  const box = await page.getByRole("slider", { name: "Timeline" }).boundingBox();
  if (box === null) throw new Error("there is no timeline");
  const y = box.y + box.height / 2;
  // Spread over the run and in no order; at its very end the pointer asks for now.
  const width = Math.floor(0.94 * box.width);
  await page.mouse.move(box.x + 2, y);
  await page.mouse.down();
  await page.waitForTimeout(SETTLE_MS);
  await page.evaluate(() => (globalThis.momentsShown = 0));
  for (let at = 1; at <= MOMENTS; at++) {
    await page.mouse.move(box.x + MARGIN + ((at * 7919) % width), y);
    await page.waitForFunction((count) => globalThis.momentsShown === count, at, { polling: 20 });
    await page.waitForTimeout(REST_MS);
  }
  await page.mouse.up();
}

/** What each jump took; one whose picture or panel is not to be found took for ever. */
function jumpsOf(events: readonly TraceEvent[]): Jump[] {
  const inOrder = events.toSorted((a, b) => a.ts - b.ts);
  const asked = inOrder.filter(({ name }) => name === ASKED);
  const shown = inOrder.filter(({ name }) => name === SHOWN);
  return asked.map((wish, at) => {
    const until = asked[at + 1]?.ts ?? Number.POSITIVE_INFINITY;
    const ours = inOrder.filter(({ pid, ts }) => pid === wish.pid && ts >= wish.ts && ts < until);
    const ofMain = ours.filter(({ tid }) => tid === wish.tid);
    const ofWorkers = ours.filter(({ tid }) => tid !== wish.tid);
    // The first message that a worker gets is the wish; the first frame that it draws then shows it.
    const heard = ofWorkers.find(({ name }) => name === "HandlePostMessage");
    const ofWorker = ofWorkers.filter(({ tid, ts }) => tid === heard?.tid && ts >= heard.ts);
    const picture = ofWorker.find(({ name }) => name === "FireAnimationFrame");
    const panel = ofMain.find(
      ({ name, ts }) => name === "Layerize" && ts > (shown[at]?.ts ?? until),
    );
    if (picture === undefined || panel === undefined)
      return { time: Infinity, main: Infinity, worker: Infinity };
    const end = Math.max(endOf(picture), endOf(panel));
    return {
      time: (end - wish.ts) / 1000,
      main: processorTime(ofMain, wish.ts, end),
      worker: processorTime(ofWorker, wish.ts, end),
    };
  });
}

function endOf({ ts, dur = 0 }: TraceEvent): number {
  return ts + dur;
}
