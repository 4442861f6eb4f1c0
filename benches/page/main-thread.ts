/**
 * What a page's threads did while it was watched, from Chromium's own trace: the length of every task of
 * the main thread, how much of it was script, and the animation frames of the workers. All in processor
 * time of the thread, so that a busy machine does not show in it.
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
  /** processor time of the thread, in microseconds; where it is missing, the time on the clock stands in */
  tdur?: number;
  args: Record<string, unknown>;
}

/** Milliseconds in each frame (from one turn of the screen to the next) of the time that was watched. */
export interface Watched {
  /** tasks of the main thread: script, style, layout, paint, and what the browser does in between */
  mainThread: number[];
  /** script of the main thread alone */
  script: number[];
  /** length of each animation frame's callbacks in the worker that draws; empty where none does */
  workerFrames: number[];
  /** time from one picture of the worker to the next */
  workerGaps: number[];
}

const FRAME_US = 1e6 / 60;
/** So much sooner than usual a turn may come. */
const EARLY_US = 2000;
const MARK = "corridor-bench";
const categories = ["devtools.timeline", "toplevel", "blink.user_timing"];

/** Names of events that are script, and are not counted twice where one lies in another. */
const scriptNames = new Set([
  "FunctionCall",
  "EvaluateScript",
  "RunMicrotasks",
  "MajorGC",
  "MinorGC",
]);

/** Watches a page for so many milliseconds. */
export async function watchPage(
  browser: Browser,
  page: Page,
  milliseconds: number,
): Promise<Watched> {
  const events = await traceWhile(browser, async () => {
    await page.evaluate((mark) => performance.mark(`${mark}-begin`), MARK);
    await page.waitForTimeout(milliseconds);
    await page.evaluate((mark) => performance.mark(`${mark}-end`), MARK);
  });
  return readTrace(events);
}

/** What the browser's threads did while something was done. */
export async function traceWhile(
  browser: Browser,
  work: () => Promise<void>,
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
  await work();
  await endTrace(session);
  await session.detach();
  return events;
}

async function endTrace(session: CDPSession): Promise<void> {
  const ended = new Promise((resolve) => session.once("Tracing.tracingComplete", resolve));
  await session.send("Tracing.end");
  await ended;
}

function readTrace(events: readonly TraceEvent[]): Watched {
  const begin = events.find(({ name }) => name === `${MARK}-begin`);
  const end = events.find(({ name }) => name === `${MARK}-end`);
  if (begin === undefined || end === undefined) throw new Error("the trace has lost its marks");
  const inTime = events.filter(({ ts }) => ts >= begin.ts && ts < end.ts);
  const ofMain = inTime.filter(({ pid, tid }) => pid === begin.pid && tid === begin.tid);
  const tasks = outermost(ofMain.filter(({ name, cat }) => isTask(name, cat)));
  const scripts = outermost(ofMain.filter(({ name }) => scriptNames.has(name)));
  const frames = inTime
    .filter(
      ({ name, pid, tid }) =>
        name === "FireAnimationFrame" && pid === begin.pid && tid !== begin.tid,
    )
    .toSorted((a, b) => a.ts - b.ts);
  const from = firstFrame(ofMain, tasks, begin.ts);
  return {
    mainThread: byFrame(tasks, from, end.ts),
    script: byFrame(scripts, from, end.ts),
    workerFrames: frames.map((frame) => spent(frame)),
    workerGaps: frames.slice(1).map(({ ts }, at) => (ts - (frames[at]?.ts ?? ts)) / 1000),
  };
}

/** Milliseconds of processor time that one thread's tasks took that began in a stretch of time. */
export function processorTime(thread: readonly TraceEvent[], from: number, to: number): number {
  const tasks = thread.filter(({ name, cat, ts }) => isTask(name, cat) && ts >= from && ts < to);
  return outermost(tasks).reduce((sum, task) => sum + spent(task), 0);
}

function isTask(name: string, cat: string): boolean {
  return (
    name === "RunTask" || (name === "ThreadControllerImpl::RunTask" && cat.includes("toplevel"))
  );
}

/** Events with a length that lie in no other of them. */
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
 * When the first frame begins. Work has until the screen's next turn, so frames are counted from there: in
 * a grid that lies anywhere, much of what is done for one picture would count for the picture before.
 * @param tasks of the main thread, in order
 */
function firstFrame(
  ofMain: readonly TraceEvent[],
  tasks: readonly TraceEvent[],
  from: number,
): number {
  const angles = ofMain
    .filter(({ name }) => name === "Layerize")
    .map(({ ts }) => tasks.findLast((task) => task.ts <= ts)?.ts ?? ts)
    .map((ts) => (2 * Math.PI * (ts - from)) / FRAME_US);
  if (angles.length === 0) return from;
  const sum = (of: (angle: number) => number): number =>
    angles.reduce((all, it) => all + of(it), 0);
  const usual = Math.atan2(sum(Math.sin), sum(Math.cos)) / (2 * Math.PI);
  const turn = usual * FRAME_US - EARLY_US;
  return from + turn - FRAME_US * Math.floor(turn / FRAME_US);
}

/** Milliseconds in each frame. */
function byFrame(events: readonly TraceEvent[], from: number, to: number): number[] {
  const frames: number[] = Array.from({ length: Math.floor((to - from) / FRAME_US) }, () => 0);
  for (const event of events) {
    const at = Math.floor((event.ts - from) / FRAME_US);
    if (frames[at] !== undefined) frames[at] += spent(event);
  }
  return frames;
}

/** Milliseconds of processor time: what others do on the machine meanwhile does not count. */
function spent({ dur = 0, tdur = dur }: TraceEvent): number {
  return tdur / 1000;
}
