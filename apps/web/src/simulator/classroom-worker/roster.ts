/** The students of a class, from its stored state, its events and the tiles. */
import { CELL } from "@corridor/maze";
import type {
  ClassEvent,
  ClassView,
  ProgressRecord,
  StudentView,
  Tile,
  StudentTile,
} from "@corridor/protocol";
import type { CountedBump, SeenStudent } from "../protocol/classroom-messages.ts";
import { noWork, withRecord, type Work } from "./student-work.ts";

interface Entry {
  view: StudentView;
  work: Work;
  /** number of the newest record in `work` */
  progress: number;
  isConnected: boolean;
  tile: Tile | null;
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
  readonly #bumps = new Map<string, CountedBump>();
  #hasNewBumps = false;
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
      const work = progress.reduce(withRecord, noWork(progress[0]?.activeMs ?? joinedAt));
      // When programs were edited is not stored: the student may have edited one just now.
      const busyAt = view.programs > 0 ? Math.max(work.busyAt, joinedAt) : work.busyAt;
      this.#set({
        view,
        work: { ...work, busyAt },
        progress: progress.at(-1)?.seq ?? 0,
        isConnected: before?.isConnected ?? false,
        tile: before?.tile ?? null,
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
      const isSame =
        before.isConnected === connected &&
        isSameState(before.tile, tile) &&
        (student !== this.#watched || before.tile?.line === tile?.line);
      const entry = { ...before, isConnected: connected, tile: tile ?? before.tile };
      this.#entries.set(student, entry);
      if (!isSame) this.#changed.add(student);
      if (tile !== null) this.#countBump(before.tile, tile);
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
      return entry === undefined ? [] : [seenOf(entry)];
    });
    const removed = [...this.#removed];
    this.#changed.clear();
    this.#removed.clear();
    return { changed, removed };
  }

  /** The bumps so far; null: none since the last call */
  takeBumps(): CountedBump[] | null {
    if (!this.#hasNewBumps) return null;
    this.#hasNewBumps = false;
    return [...this.#bumps.values()];
  }

  /** A bump counts where the robot is when its page reports it. */
  #countBump(before: Tile | null, { task, maze, state, bumps, pose: [x, y] }: Tile): void {
    const hasBumped = state === "bumped" && (before?.state !== "bumped" || before.bumps < bumps);
    if (!hasBumped || maze === null) return;
    const [column, row] = [Math.floor(x / CELL), Math.floor(y / CELL)];
    const key = `${task} ${maze} ${column} ${row}`;
    const count = (this.#bumps.get(key)?.count ?? 0) + 1;
    this.#bumps.set(key, { task, maze, column, row, count });
    this.#hasNewBumps = true;
  }

  #joined(view: StudentView): Entry {
    const work = noWork(this.#activeMs());
    return { view, work, progress: 0, isConnected: false, tile: null };
  }

  #set(entry: Entry): void {
    const { student } = entry.view;
    this.#entries.set(student, entry);
    this.#removed.delete(student);
    this.#changed.add(student);
  }

  #remove(student: number): void {
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
    progress: isNew ? progress.seq : before.progress,
  };
}

/** Whether two tiles have the same words on the card. */
function isSameState(one: Tile | null, other: Tile | null): boolean {
  return one?.task === other?.task && one?.state === other?.state;
}

function seenOf({ view, work, isConnected, tile }: Entry): SeenStudent {
  const { student, name, helpSince, programs } = view;
  const { busyAt, bestAt, repeats, tasks, answers } = work;
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
    tasks,
    answers,
  };
}

function seenTile({ task, state, line }: Tile): SeenStudent["tile"] {
  return { task, state, line };
}
