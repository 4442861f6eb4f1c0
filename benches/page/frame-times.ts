/**
 * Measures a page's threads with a Chromium trace: the duration of every task of the main thread,
 * the share of script, and the animation frames of the workers. All durations are processor time of
 * the thread, so that other load on the machine does not affect them.
 */
import type { Browser, CDPSession, Page } from "playwright";

export interface TraceEvent {
  name: string;
  cat: string;
  ph: string;
  pid: number;
  tid: number;
  /** microseconds */
  ts: number;
  dur?: number;
  /** processor time of the thread, in microseconds; if missing, `dur` is used */
  tdur?: number;
  args: Record<string, unknown>;
}

/** Milliseconds in each frame of the trace. A frame lasts from one screen refresh to the next. */
export interface FrameTimes {
  /** all tasks of the main thread: script, style, layout, paint and browser internals */
  mainThread: number[];
  /** script of the main thread */
  script: number[];
  /** duration of the callbacks of each animation frame in the drawing worker; empty without one */
  workerFrames: number[];
  /** time between the starts of consecutive animation frames of the worker */
  workerGaps: number[];
  /** all tasks of the thread of the drawing worker: callbacks, messages and browser internals */
  workerThread: number[];
}

const FRAME_US = 1e6 / 60;
/** A refresh may start this much earlier than the mean phase. */
const MAX_EARLY_US = 2000;
const MARK_NAME = "corridor-bench";
const categories = ["devtools.timeline", "toplevel", "blink.user_timing"];

/** Names of script events. Nested events are counted once. */
const scriptNames = new Set([
  "FunctionCall",
  "EvaluateScript",
  "RunMicrotasks",
  "MajorGC",
  "MinorGC",
]);

/** Traces a page for a number of milliseconds. */
export async function traceFrames(
  browser: Browser,
  page: Page,
  milliseconds: number,
): Promise<FrameTimes> {
  const events = await traceWhile(browser, async () => {
    await page.evaluate((mark) => performance.mark(`${mark}-start`), MARK_NAME);
    await page.waitForTimeout(milliseconds);
    await page.evaluate((mark) => performance.mark(`${mark}-end`), MARK_NAME);
  });
  return readTrace(events);
}

/** Records a trace of all threads of the browser while an action runs. */
export async function traceWhile(
  browser: Browser,
  action: () => Promise<void>,
): Promise<TraceEvent[]> {
  const session = await browser.newBrowserCDPSession();
  const events: TraceEvent[] = [];
  session.on("Tracing.dataCollected", ({ value }) => {
    for (const event of value) events.push(event as unknown as TraceEvent);
  });
  await session.send("Tracing.start", {
    transferMode: "ReportEvents",
    traceConfig: { includedCategories: categories, recordMode: "recordAsMuchAsPossible" },
  });
  await action();
  await endTrace(session);
  await session.detach();
  return events;
}

async function endTrace(session: CDPSession): Promise<void> {
  const ended = new Promise((resolve) => session.once("Tracing.tracingComplete", resolve));
  await session.send("Tracing.end");
  await ended;
}

function readTrace(events: readonly TraceEvent[]): FrameTimes {
  const startMark = events.find(({ name }) => name === `${MARK_NAME}-start`);
  const endMark = events.find(({ name }) => name === `${MARK_NAME}-end`);
  if (startMark === undefined || endMark === undefined) {
    throw new Error("The trace does not contain its start and end marks.");
  }
  const traced = events.filter(({ ts }) => ts >= startMark.ts && ts < endMark.ts);
  const mainEvents = traced.filter(
    ({ pid, tid }) => pid === startMark.pid && tid === startMark.tid,
  );
  const tasks = outermost(mainEvents.filter(({ name, cat }) => isTask(name, cat)));
  const scripts = outermost(mainEvents.filter(({ name }) => scriptNames.has(name)));
  const frames = traced
    .filter(
      ({ name, pid, tid }) =>
        name === "FireAnimationFrame" && pid === startMark.pid && tid !== startMark.tid,
    )
    .toSorted((a, b) => a.ts - b.ts);
  const from = firstFrame(mainEvents, tasks, startMark.ts);
  const workerTasks = traced.filter(
    ({ name, cat, pid, tid }) =>
      isTask(name, cat) && pid === startMark.pid && tid === frames[0]?.tid,
  );
  return {
    mainThread: sumByFrame(tasks, from, endMark.ts),
    script: sumByFrame(scripts, from, endMark.ts),
    workerFrames: frames.map((frame) => processorMs(frame)),
    workerGaps: frames.slice(1).map(({ ts }, at) => (ts - (frames[at]?.ts ?? ts)) / 1000),
    workerThread: sumByFrame(outermost(workerTasks), from, endMark.ts),
  };
}

/** Milliseconds of processor time of one thread's tasks that started in an interval. */
export function processorTime(thread: readonly TraceEvent[], from: number, to: number): number {
  const tasks = thread.filter(({ name, cat, ts }) => isTask(name, cat) && ts >= from && ts < to);
  return outermost(tasks).reduce((sum, task) => sum + processorMs(task), 0);
}

function isTask(name: string, cat: string): boolean {
  return (
    name === "RunTask" || (name === "ThreadControllerImpl::RunTask" && cat.includes("toplevel"))
  );
}

/** Events with a duration that are not nested in another of the events. */
function outermost(events: readonly TraceEvent[]): TraceEvent[] {
  const inOrder = events
    .filter(({ ph, dur }) => ph === "X" && dur !== undefined)
    .toSorted((a, b) => a.ts - b.ts || (b.dur ?? 0) - (a.dur ?? 0));
  let coveredTo = Number.NEGATIVE_INFINITY;
  return inOrder.filter(({ ts, dur = 0 }) => {
    if (ts < coveredTo) return false;
    coveredTo = ts + dur;
    return true;
  });
}

/**
 * Start time of the first frame. The deadline of a frame is the next screen refresh, so frames must
 * be aligned with the refreshes: otherwise work for one frame would count for the previous frame.
 * The phase of the refreshes is the circular mean of the phases of all `Layerize` tasks.
 * @param tasks tasks of the main thread, in order
 */
function firstFrame(
  mainEvents: readonly TraceEvent[],
  tasks: readonly TraceEvent[],
  from: number,
): number {
  const phases = mainEvents
    .filter(({ name }) => name === "Layerize")
    .map(({ ts }) => tasks.findLast((task) => task.ts <= ts)?.ts ?? ts)
    .map((ts) => (2 * Math.PI * (ts - from)) / FRAME_US);
  if (phases.length === 0) return from;
  const total = (of: (phase: number) => number): number =>
    phases.reduce((sum, phase) => sum + of(phase), 0);
  const meanPhase = Math.atan2(total(Math.sin), total(Math.cos)) / (2 * Math.PI);
  const offset = meanPhase * FRAME_US - MAX_EARLY_US;
  return from + offset - FRAME_US * Math.floor(offset / FRAME_US);
}

/** The total processor time in milliseconds of the events of each frame. */
function sumByFrame(events: readonly TraceEvent[], from: number, to: number): number[] {
  const frames: number[] = Array.from({ length: Math.floor((to - from) / FRAME_US) }, () => 0);
  for (const event of events) {
    const at = Math.floor((event.ts - from) / FRAME_US);
    if (frames[at] !== undefined) frames[at] += processorMs(event);
  }
  return frames;
}

/** Processor time in milliseconds. It excludes other load on the machine. */
function processorMs({ dur = 0, tdur = dur }: TraceEvent): number {
  return tdur / 1000;
}
