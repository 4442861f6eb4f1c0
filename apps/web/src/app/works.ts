/**
 * The works that this device keeps: each a maze with its program, under a key of its own, so that
 * two tabs that save different works never write over each other.
 *
 * What is read back is parsed like any other outside input. An entry that cannot be read is moved
 * aside, never deleted, and comes back by itself when a later Corridor can read it.
 * At most 30 works are kept, but one that the reader has edited is never dropped to make room: only
 * copies that were opened and left as they came make way, the oldest first.
 */
import { parseMaze, type MazeDocument } from "@corridor/maze";
import { parseProgram, type ProgramDocument } from "@corridor/program";
import { describeProblem, problem, type ReadResult } from "@corridor/protocol";

export interface Work {
  id: string;
  /** milliseconds since 1970 */
  savedAt: number;
  /** changes with every save, so that a tab notices that another one saved since */
  revision: string;
  /** false while the work is as it was opened: such a copy can be had again */
  edited: boolean;
  maze: MazeDocument;
  program: ProgramDocument;
}

/** An entry that was moved aside, and why, as a line for the reader. */
export interface DamagedEntry {
  key: string;
  reason: string;
}

/** As much of the browser's Storage as is needed. Any call may throw: full, forbidden. */
export type KeyValueStorage = Pick<
  Storage,
  "length" | "key" | "getItem" | "setItem" | "removeItem"
>;

const MAX_WORKS = 30;
const WORK_PREFIX = "corridor.work.";
const ASIDE_PREFIX = "corridor.aside.";

export class WorkShelf {
  readonly #storage: KeyValueStorage;

  constructor(storage: KeyValueStorage) {
    this.#storage = storage;
  }

  /** All works that can be read, newest first. */
  list(): Work[] {
    const works: Work[] = [];
    for (const key of this.#keys(WORK_PREFIX)) {
      const result = this.#readEntry(key);
      if (result?.ok === true) works.push(result.value);
    }
    return works.toSorted((a, b) => b.savedAt - a.savedAt || (a.id < b.id ? -1 : 1));
  }

  /**
   * Moves entries that cannot be read aside, and takes back those that an older Corridor moved aside
   * and this one can read. @returns what was moved aside now
   */
  sweep(): DamagedEntry[] {
    for (const key of this.#keys(ASIDE_PREFIX)) {
      const home = WORK_PREFIX + key.slice(ASIDE_PREFIX.length);
      if (this.#storage.getItem(home) !== null) continue;
      if (this.#readEntry(key)?.ok === true) this.#rename(key, home);
    }
    const damaged: DamagedEntry[] = [];
    for (const key of this.#keys(WORK_PREFIX)) {
      const result = this.#readEntry(key);
      if (result === null || result.ok) continue;
      this.#rename(key, ASIDE_PREFIX + key.slice(WORK_PREFIX.length));
      damaged.push({ key, reason: result.problems.map(describeProblem).join("; ") });
    }
    return damaged;
  }

  /** One work; null when it is not there or cannot be read. */
  read(id: string): Work | null {
    const result = this.#readEntry(WORK_PREFIX + id);
    return result?.ok === true ? result.value : null;
  }

  /**
   * Stores a work under its id, and lets untouched copies go while there are more than 30.
   * @throws what the storage throws when it is full or forbidden; then nothing has changed
   */
  write(work: Work): void {
    this.#storage.setItem(WORK_PREFIX + work.id, JSON.stringify(work));
    if (this.#keys(WORK_PREFIX).length <= MAX_WORKS) return;
    const works = this.list();
    const droppable = works.filter((each) => !each.edited && each.id !== work.id);
    const surplus = Math.min(works.length - MAX_WORKS, droppable.length);
    for (let left = surplus; left > 0; left--) {
      const oldest = droppable.pop();
      if (oldest !== undefined) this.remove(oldest.id);
    }
  }

  remove(id: string): void {
    this.#storage.removeItem(WORK_PREFIX + id);
  }

  #keys(prefix: string): string[] {
    const keys: string[] = [];
    for (let index = 0; index < this.#storage.length; index++) {
      const key = this.#storage.key(index);
      if (key?.startsWith(prefix) === true) keys.push(key);
    }
    return keys;
  }

  #readEntry(key: string): ReadResult<Work> | null {
    const text = this.#storage.getItem(key);
    return text === null ? null : readWork(text, key.slice(key.lastIndexOf(".") + 1));
  }

  /** The copy is made first: when there is no room for it, the entry stays where it is. */
  #rename(from: string, to: string): void {
    const text = this.#storage.getItem(from);
    if (text === null) return;
    try {
      this.#storage.setItem(to, text);
    } catch {
      return;
    }
    this.#storage.removeItem(from);
  }
}

/** Reads one stored entry. `id` is the one in its key, which wins: a copied entry is its own work. */
function readWork(text: string, id: string): ReadResult<Work> {
  let input: unknown;
  try {
    input = JSON.parse(text);
  } catch {
    return problem("", "unreadable text", "a JSON document");
  }
  if (typeof input !== "object" || input === null) return problem("", "no object", "a saved work");
  const { savedAt, revision, edited, maze, program } = input as Record<string, unknown>;
  const readMaze = parseMaze(maze);
  if (!readMaze.ok) return within("maze", readMaze.problems);
  const readProgram = parseProgram(program);
  if (!readProgram.ok) return within("program", readProgram.problems);
  return {
    ok: true,
    value: {
      id,
      // The documents are the work. The rest has a harmless reading whatever stands there.
      savedAt: typeof savedAt === "number" && Number.isFinite(savedAt) ? savedAt : 0,
      revision: typeof revision === "string" ? revision : "",
      edited: edited !== false,
      maze: readMaze.value,
      program: readProgram.value,
    },
  };
}

function within(
  field: string,
  problems: { path: string; found: string; expected: string }[],
): ReadResult<Work> {
  return {
    ok: false,
    problems: problems.map((each) => ({
      ...each,
      path: each.path === "" ? field : `${field}.${each.path}`,
    })),
  };
}

/**
 * The browser's storage, or, where it is forbidden, one that keeps nothing and says so when
 * something is to be kept.
 * @param open reads `localStorage` or `sessionStorage`, which may throw by itself
 */
export function storageOrNone(open: () => KeyValueStorage): KeyValueStorage {
  try {
    return open();
  } catch (error) {
    return {
      length: 0,
      key: () => null,
      getItem: () => null,
      setItem: () => {
        throw error;
      },
      removeItem: () => undefined,
    };
  }
}
