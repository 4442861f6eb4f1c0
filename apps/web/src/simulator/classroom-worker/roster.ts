/** The students of a class, from its stored state, its events and the tiles. */
import type {
  ClassEvent,
  ClassView,
  ProgressRecord,
  StudentView,
  Tile,
  StudentTile,
} from "@corridor/protocol";
import type { CountedBump, SeenStudent } from "../protocol/classroom-messages.ts";
import { noLiveBumps, withoutRecorded, withTileBumps, type LiveBumps } from "./live-bumps.ts";
import {
  noBumps,
  noWork,
  taskOf,
  withRecord,
  withRestart,
  withTask,
  workIn,
  type Work,
} from "./student-work.ts";

/**
 * The page learns of a robot that drives on at most this often, in ms: often enough for minutes
 * without a run.
 */
const BUSY_STEP_MS = 30_000;

interface Entry {
  view: StudentView;
  work: Work;
  /** not in `work` yet */
  live: LiveBumps;
  /** number of the newest record in `work` */
  progress: number;
  isConnected: boolean;
  tile: Tile | null;
  /** active time at which its newest tile drove; no record has it */
  drivenAt: number;
  /** `work.busyAt` as the page last received it */
  sentBusyAt: number;
}

/** What the page has not received yet. */
export interface RosterChanges {
  changed: SeenStudent[];
  removed: number[];
}

export class Roster {
  readonly #activeMs: () => number;
  readonly #entries = new Map<number, Entry>();
  readonly #changed = new Set<number>();
  readonly #removed = new Set<number>();
  #hasNewBumps = false;
  /** active time at which the class got another lesson */
  #restartedAt = Number.NEGATIVE_INFINITY;
  /** mark of the lesson of the class; null: not known yet */
  #lesson: string | null = null;
  #watched: number | null = null;

  /** @param activeMs the active time now */
  constructor(activeMs: () => number) {
    this.#activeMs = activeMs;
  }

  /** Replaces the students by those of the class as it was read. Tiles stay. */
  replace({ students }: Pick<ClassView, "students">): void {
    const present = new Set(students.map(({ student }) => student));
    for (const student of this.#entries.keys()) if (!present.has(student)) this.#remove(student);
    for (const { progress, ...view } of students) {
      const before = this.#entries.get(view.student);
      const joinedAt = before?.work.busyAt ?? this.#activeMs();
      const stored = progress.reduce(withRecord, noWork(progress[0]?.activeMs ?? joinedAt));
      const isOld = (progress.at(-1)?.activeMs ?? 0) < this.#restartedAt;
      const work = isOld ? withRestart(stored, this.#restartedAt) : stored;
      const drivenAt = before?.drivenAt ?? Number.NEGATIVE_INFINITY;
      // When programs were edited is not stored: the student may have edited one just now.
      const editedAt = view.programs > 0 ? joinedAt : Number.NEGATIVE_INFINITY;
      const busyAt = Math.max(work.busyAt, drivenAt, editedAt);
      this.#set({
        view,
        work: { ...work, busyAt },
        live: before?.live ?? noLiveBumps,
        progress: progress.at(-1)?.seq ?? 0,
        isConnected: before?.isConnected ?? false,
        tile: before?.tile ?? null,
        drivenAt,
        sentBusyAt: busyAt,
      });
    }
  }

  /** Applies an event about a student. */
  follow(event: Exclude<ClassEvent, { type: "settings" }>): void {
    if (event.type === "removed") return this.#remove(event.student);
    const { student: view, progress } = event;
    const before = this.#entries.get(view.student) ?? this.#joined(view);
    this.#set(withView(before, view, progress, this.#activeMs()));
  }

  /** The class has another lesson: nobody has had the time to open it yet. */
  restart(): void {
    this.#restartedAt = this.#activeMs();
    for (const entry of this.#entries.values()) {
      this.#set({ ...entry, work: withRestart(entry.work, this.#restartedAt) });
    }
  }

  /** The page receives the work in this lesson of the class. @param mark of the lesson */
  setLesson(mark: string): void {
    if (mark === this.#lesson) return;
    this.#lesson = mark;
    this.#hasNewBumps = true;
    for (const student of this.#entries.keys()) this.#changed.add(student);
  }

  /** The page shows the running line of this student; null: of nobody. */
  watch(student: number | null): void {
    this.#watched = student;
    if (student !== null && this.#entries.has(student)) this.#changed.add(student);
  }

  /** Applies a batch of tiles. @returns the students whose picture may have changed */
  show(tiles: readonly StudentTile[]): number[] {
    const shown: number[] = [];
    for (const { student, connected, tile } of tiles) {
      const before = this.#entries.get(student);
      if (before === undefined) continue;
      const hasDriven = tile !== null && before.tile !== null && tile.tick !== before.tile.tick;
      const drivenAt = hasDriven ? this.#activeMs() : before.drivenAt;
      const work = withTile(before, tile, drivenAt, this.#activeMs());
      const live = withTileBumps(before.live, before.tile, tile, work);
      if (live.places !== before.live.places) this.#hasNewBumps = true;
      const isSame =
        before.isConnected === connected &&
        isSameState(before.tile, tile) &&
        busyStep(work.busyAt) === busyStep(before.sentBusyAt) &&
        (student !== this.#watched || before.tile?.line === tile?.line);
      const next = { isConnected: connected, tile: tile ?? before.tile, work, live, drivenAt };
      const entry = { ...before, ...next };
      this.#entries.set(student, entry);
      if (!isSame || hasOpenRun(entry) !== hasOpenRun(before)) this.#changed.add(student);
      shown.push(student);
    }
    return shown;
  }

  /** The newest tile of a student; null without one. */
  tileOf(student: number): Tile | null {
    return this.#entries.get(student)?.tile ?? null;
  }

  get hasChanges(): boolean {
    return this.#changed.size + this.#removed.size > 0;
  }

  /** The changes since the last call. */
  takeChanges(): RosterChanges {
    const changed = [...this.#changed].flatMap((student) => {
      const entry = this.#entries.get(student);
      if (entry === undefined) return [];
      entry.sentBusyAt = entry.work.busyAt;
      const work = workIn(entry.work, this.#lesson);
      const recent = student === this.#watched ? work.recent : [];
      return [{ ...seenOf(entry, work), recent }];
    });
    const removed = [...this.#removed];
    this.#changed.clear();
    this.#removed.clear();
    return { changed, removed };
  }

  /** All bumps in the lesson of the class; null: the same as at the last call */
  takeBumps(): CountedBump[] | null {
    if (!this.#hasNewBumps) return null;
    this.#hasNewBumps = false;
    const all = new Map<string, CountedBump>();
    for (const { work, live } of this.#entries.values()) {
      for (const { lesson, ...bump } of [...work.bumped, ...live.places]) {
        const isOther = this.#lesson !== null && lesson !== null && lesson !== this.#lesson;
        if (isOther) continue;
        const key = `${bump.task} ${bump.maze} ${bump.column} ${bump.row}`;
        all.set(key, { ...bump, count: bump.count + (all.get(key)?.count ?? 0) });
      }
    }
    return [...all.values()];
  }

  #joined(view: StudentView): Entry {
    const work = noWork(this.#activeMs());
    const drivenAt = Number.NEGATIVE_INFINITY;
    const still = { progress: 0, isConnected: false, tile: null, drivenAt };
    return { view, work, live: noLiveBumps, ...still, sentBusyAt: work.busyAt };
  }

  #set(entry: Entry): void {
    const { student } = entry.view;
    const before = this.#entries.get(student);
    const isSame =
      (before?.work.bumped ?? noBumps) === entry.work.bumped &&
      (before?.live ?? noLiveBumps).places === entry.live.places &&
      (before === undefined || before.work.lesson === entry.work.lesson);
    if (!isSame) this.#hasNewBumps = true;
    this.#entries.set(student, entry);
    this.#removed.delete(student);
    this.#changed.add(student);
  }

  #remove(student: number): void {
    const { work, live } = this.#entries.get(student) ?? {};
    if (work?.bumped.length || live?.places.length) this.#hasNewBumps = true;
    this.#entries.delete(student);
    this.#changed.delete(student);
    this.#removed.add(student);
  }
}

function withView(
  before: Entry,
  view: StudentView,
  progress: ProgressRecord | null,
  now: number,
): Entry {
  const isNew = progress !== null && progress.seq > before.progress;
  const work = isNew ? withRecord(before.work, progress) : before.work;
  const hasEdited = view.programs > before.view.programs;
  return {
    ...before,
    view,
    work: hasEdited ? { ...work, busyAt: Math.max(work.busyAt, now) } : work,
    live: isNew ? withoutRecorded(before.live, progress) : before.live,
    progress: isNew ? progress.seq : before.progress,
  };
}

/**
 * A robot that drives is a run, also before its record arrives. Tiles are faster than records: the
 * tile of another task starts its counts, so that nobody is stuck in a task that has just opened.
 */
function withTile(
  { work, tile: before }: Pick<Entry, "work" | "tile">,
  tile: Tile | null,
  drivenAt: number,
  now: number,
): Work {
  const isOther = tile !== null && before !== null && tile.task !== before.task;
  if (isOther) return withRestart(work, now);
  return drivenAt > work.busyAt ? { ...work, busyAt: drivenAt } : work;
}

/** The same for all students, so that the page learns of all in one message. */
function busyStep(busyAt: number): number {
  return Math.floor(busyAt / BUSY_STEP_MS);
}

/** Whether two tiles have the same words on the card. */
function isSameState(one: Tile | null, other: Tile | null): boolean {
  return one?.task === other?.task && one?.state === other?.state;
}

/**
 * Whether the first run of the open task is under way, or a pause of the class has stopped it: its
 * record follows when it ends.
 */
function hasOpenRun({ tile, work }: Pick<Entry, "tile" | "work">): boolean {
  if (tile === null || tile.maze === null || tile.tick === 0) return false;
  return taskOf(work, tile.task).runs === 0;
}

/** The work on the tasks, with the run that is under way: it is an attempt, too. */
function seenTasks(entry: Entry, work: Work): SeenStudent["tasks"] {
  const { tile } = entry;
  // A run in another lesson belongs to none of these tasks.
  if (work !== entry.work || tile === null || !hasOpenRun(entry)) return work.tasks;
  const { attempts } = taskOf(work, tile.task);
  return withTask(work, tile.task, { runs: 1, attempts: Math.max(1, attempts) }).tasks;
}

/** @param work in the lesson of the class */
function seenOf(entry: Entry, work: Work): Omit<SeenStudent, "recent"> {
  const { view, isConnected, tile } = entry;
  const { student, name, helpSince, programs } = view;
  const { busyAt, bestAt, repeats, answers } = work;
  return {
    student,
    name,
    helpSince: helpSince === null ? null : Date.parse(helpSince),
    programs,
    isConnected,
    tile: tile === null ? null : seenTile(tile),
    busyAt,
    bestAt,
    repeats,
    tasks: seenTasks(entry, work),
    answers,
  };
}

function seenTile({ task, state, line }: Tile): SeenStudent["tile"] {
  return { task, state, line };
}
