/**
 * The works that this device keeps: each a maze with its program, under a key of its own, so that
 * two tabs that save different works never write over each other.
 *
 * What is read back is parsed like any other outside input, by a reader that may come later than the
 * page: until then, what this tab wrote is known and all else stays untouched. An entry that cannot be
 * read is moved aside, never deleted, and comes back by itself when a later Corridor can read it.
 * At most 30 works are kept, but one that the reader has edited is never dropped to make room: only
 * copies that were opened and left as they came make way, the oldest first.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";

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

type WorkResult = { ok: true; value: Work } | { ok: false; reason: string };

/** Reads a stored text as the work of an id; the reason of a refusal is a line for the reader. */
export type ReadWork = (text: string, id: string) => WorkResult;

/** As much of the browser's Storage as is needed. Any call may throw: full, forbidden. */
export type KeyValueStorage = Pick<
  Storage,
  "length" | "key" | "getItem" | "setItem" | "removeItem"
>;

const MAX_WORKS = 30;
const WORK_PREFIX = "corridor.work.";
const ASIDE_PREFIX = "corridor.aside.";
const CHALLENGE_PREFIX = "corridor.challenge.";

/** Where the shared challenge is stored that is tried in a work; it goes when the work goes. */
export function challengeKey(work: string): string {
  return CHALLENGE_PREFIX + work;
}

export class WorkShelf {
  readonly #storage: KeyValueStorage;
  readonly #reader: () => ReadWork | null;
  /** what was read or written here, by id; good for as long as the stored text is the same */
  readonly #known = new Map<string, { text: string; result: WorkResult }>();

  /** @param reader null while it is not there yet */
  constructor(storage: KeyValueStorage, reader: () => ReadWork | null) {
    this.#storage = storage;
    this.#reader = reader;
  }

  /** Whether nothing is stored, aside or not. */
  get isEmpty(): boolean {
    return this.#keys(WORK_PREFIX).length === 0 && this.#keys(ASIDE_PREFIX).length === 0;
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
      damaged.push({ key, reason: result.reason });
    }
    return damaged;
  }

  /** Drops challenges whose work is gone: a browser that was ended in between, or an older Corridor. */
  sweepChallenges(): void {
    for (const key of this.#keys(CHALLENGE_PREFIX)) {
      const id = key.slice(CHALLENGE_PREFIX.length);
      const isNeeded = this.has(id) || this.#storage.getItem(ASIDE_PREFIX + id) !== null;
      if (!isNeeded) this.#storage.removeItem(key);
    }
  }

  /** One work; null when it is not there or cannot be read. */
  read(id: string): Work | null {
    const result = this.#readEntry(WORK_PREFIX + id);
    return result?.ok === true ? result.value : null;
  }

  /** Whether anything is stored under the id, readable or not. */
  has(id: string): boolean {
    return this.#storage.getItem(WORK_PREFIX + id) !== null;
  }

  /**
   * Whether writing this work would write over nothing but itself: its entry has the revision that
   * the work came from, or there is none. An entry that cannot be read is not its own.
   */
  mayWriteOver({ id, revision }: Work): boolean {
    const text = this.#storage.getItem(WORK_PREFIX + id);
    if (text === null) return true;
    const result = this.#readEntry(WORK_PREFIX + id);
    return result === null
      ? revisionIn(text) === revision
      : result.ok && result.value.revision === revision;
  }

  /**
   * Stores a work under its id, and lets untouched copies go while there are more than 30.
   * @param challenge what `remove` gave, to bring it back with the work
   * @throws what the storage throws when it is full or forbidden; then nothing has changed
   */
  write(work: Work, challenge: string | null = null): void {
    const text = JSON.stringify(work);
    if (challenge !== null) this.#storage.setItem(challengeKey(work.id), challenge);
    this.#storage.setItem(WORK_PREFIX + work.id, text);
    this.#known.set(work.id, { text, result: { ok: true, value: work } });
    if (this.#keys(WORK_PREFIX).length <= MAX_WORKS) return;
    const works = this.list();
    const droppable = works.filter((each) => !each.edited && each.id !== work.id);
    const surplus = Math.min(works.length - MAX_WORKS, droppable.length);
    for (let left = surplus; left > 0; left--) {
      const oldest = droppable.pop();
      if (oldest !== undefined) this.remove(oldest.id);
    }
  }

  /** Removes a work and the challenge that was tried in it. @returns that challenge's text; null without one */
  remove(id: string): string | null {
    const challenge = this.#storage.getItem(challengeKey(id));
    this.#storage.removeItem(WORK_PREFIX + id);
    this.#storage.removeItem(challengeKey(id));
    this.#known.delete(id);
    return challenge;
  }

  #keys(prefix: string): string[] {
    const keys: string[] = [];
    for (let index = 0; index < this.#storage.length; index++) {
      const key = this.#storage.key(index);
      if (key?.startsWith(prefix) === true) keys.push(key);
    }
    return keys;
  }

  /** null where nothing is stored, and for the text of others while the reader is not there yet */
  #readEntry(key: string): WorkResult | null {
    const text = this.#storage.getItem(key);
    if (text === null) return null;
    const id = key.slice(key.lastIndexOf(".") + 1);
    const known = this.#known.get(id);
    if (known?.text === text) return known.result;
    const result = this.#reader()?.(text, id) ?? null;
    if (result !== null) this.#known.set(id, { text, result });
    return result;
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

/** The revision in the text of an entry, told without a schema; null where the text is damaged. */
function revisionIn(text: string): string | null {
  try {
    const { revision } = JSON.parse(text) as { revision?: unknown };
    return typeof revision === "string" ? revision : null;
  } catch {
    return null;
  }
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
