/** Students and dashboards, in a process separate from the measured relay. Runs one job. */
import { delay } from "../load/load-recorder.ts";
import { processorMs } from "../process-metrics.ts";
import type { ClassesJob, ClassesResult } from "./jobs.ts";
import { LiveClass } from "./live-class.ts";

const WARM_UP_MS = 2_000;
/** Interval of the pauses, one class after the other. */
const PAUSE_INTERVAL_MS = 200;
/** The end of a pause reaches all students before the next one starts. */
const LONG_POLL_INTERVAL_MS = 2_000;

process.on("message", (job: ClassesJob) => {
  run(job).then(
    (result) => process.send?.(result),
    (error: unknown) => {
      console.error(error);
      process.exit(1);
    },
  );
});
process.on("disconnect", () => process.exit(0));

async function run(job: ClassesJob): Promise<ClassesResult> {
  const joins = await measureJoins(job);
  const longPollPauses = await measureLongPollPauses(job);
  return { ...(await measureLessons(job)), joins, longPollPauses };
}

async function measureJoins({ port, joins }: ClassesJob): Promise<number[]> {
  const crowd = await LiveClass.create({ port, client: "10.2.1.1" });
  const startedAt = performance.now();
  const times = await Promise.all(
    Array.from({ length: joins }, async () => {
      await crowd.join();
      return performance.now() - startedAt;
    }),
  );
  crowd.close();
  return times;
}

/** Pauses a class of which all students poll. */
async function measureLongPollPauses(job: ClassesJob): Promise<number[]> {
  const { port, students, longPollPauses } = job;
  if (longPollPauses === 0) return [];
  const lesson = await LiveClass.create({ port, client: "10.2.1.2" });
  let observer = (): void => undefined;
  for (let student = 0; student < students; student++) {
    await lesson.joinByLongPoll((isPaused) => {
      if (isPaused) observer();
    });
  }
  const pauses: number[] = [];
  for (let n = 0; n < longPollPauses; n++) {
    pauses.push(await pause(lesson, students, (observe) => (observer = observe)));
    await delay(LONG_POLL_INTERVAL_MS);
  }
  lesson.close();
  return pauses;
}

type Lessons = Omit<ClassesResult, "joins" | "longPollPauses">;

/** Every student sends tiles. Each class in turn is paused and continued meanwhile. */
async function measureLessons(job: ClassesJob): Promise<Lessons> {
  const { port, pids, classes, students, tilesPerSecond, recordsPerSecond, seconds } = job;
  const everyone = classes * students;
  const sentAt = Array.from({ length: everyone }, () => new Map<number, number>());
  const tileAges: number[] = [];
  /** called when a student of the class receives the start of a pause */
  const observers: (() => void)[] = [];
  let isMeasured = false;
  let stored = 0;
  const lessons: LiveClass[] = [];
  for (let n = 0; n < classes; n++) {
    const lesson = await LiveClass.create({ port, client: `10.2.0.${n + 1}` });
    await lesson.fill(students, {
      onPause: (_student, isPaused) => {
        if (isPaused) observers[n]?.();
      },
      onTile: (student, seq) => {
        const sent = sentAt[n * students + student]?.get(seq);
        if (isMeasured && sent !== undefined) tileAges.push(performance.now() - sent);
      },
      onStored: () => (stored += 1),
    });
    lessons.push(lesson);
  }
  const startedAt = performance.now();
  let tiles = 0;
  let records = 0;
  const timer = setInterval(() => {
    const elapsed = (performance.now() - startedAt) / 1000;
    for (; tiles < elapsed * tilesPerSecond * everyone; tiles++) {
      const at = tiles % everyone;
      const seq = Math.floor(tiles / everyone) + 1;
      sentAt[at]?.set(seq, performance.now());
      lessons[Math.floor(at / students)]?.sendTile(at % students, seq);
    }
    for (; records < elapsed * recordsPerSecond * classes; records++) {
      const at = records % everyone;
      const seq = Math.floor(records / everyone) + 1;
      lessons[at % classes]?.sendProgress(Math.floor(at / classes), seq);
    }
  }, 1);
  await delay(WARM_UP_MS);
  isMeasured = true;
  const before = { tiles, stored, processor: pids.map(processorMs), at: performance.now() };
  await delay(seconds * 1000);
  const result = {
    seconds: (performance.now() - before.at) / 1000,
    tiles: tiles - before.tiles,
    stored: stored - before.stored,
    processorMs: pids.map((pid, at) => processorMs(pid) - (before.processor[at] ?? Number.NaN)),
  };
  isMeasured = false;
  const pauses: number[] = [];
  for (const [n, lesson] of lessons.entries()) {
    pauses.push(await pause(lesson, students, (observer) => (observers[n] = observer)));
    await delay(PAUSE_INTERVAL_MS);
  }
  clearInterval(timer);
  for (const lesson of lessons) lesson.close();
  return { ...result, tileAges, pauses };
}

/** @returns milliseconds until all students have received the pause */
async function pause(
  lesson: LiveClass,
  students: number,
  observe: (onStudent: () => void) => void,
): Promise<number> {
  const all = Promise.withResolvers<void>();
  let left = students;
  observe(() => {
    if (--left === 0) all.resolve();
  });
  const startedAt = performance.now();
  await Promise.all([lesson.setPaused(true), all.promise]);
  const elapsed = performance.now() - startedAt;
  await lesson.setPaused(false);
  return elapsed;
}
